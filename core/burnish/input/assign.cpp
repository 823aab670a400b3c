#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/input/assign.h>
#include <burnish/input/cryptomatte.h>

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace burnish {
namespace {

/// The objects a rule names, in the cryptomatte that knows them.
struct NamedObjects {
    const Cryptomatte* cryptomatte = nullptr;
    std::vector<uint32_t> ids;  // sorted
};

/// True when the manifest lists one of the ids.
bool lists_any(const Cryptomatte& cryptomatte, const std::vector<uint32_t>& ids) {
    return std::any_of(cryptomatte.manifest.begin(), cryptomatte.manifest.end(),
                       [&](const auto& entry) { return std::binary_search(ids.begin(), ids.end(), entry.second); });
}

NamedObjects find_objects(const std::vector<Cryptomatte>& cryptomattes, const std::string& patterns) {
    for (const Cryptomatte& cryptomatte : cryptomattes)
        for (const std::string& name : {cryptomatte.name, cryptomatte.name.substr(cryptomatte.name.rfind('.') + 1)})
            if (patterns.starts_with(name + ":"))
                return {&cryptomatte, matching_ids(cryptomatte, patterns.substr(name.size() + 1))};
    for (const Cryptomatte& cryptomatte : cryptomattes) {
        if (cryptomatte.manifest.empty()) continue;
        if (auto ids = matching_ids(cryptomatte, patterns); lists_any(cryptomatte, ids)) return {&cryptomatte, std::move(ids)};
    }
    const auto unlisted = std::find_if(cryptomattes.begin(), cryptomattes.end(),
                                       [](const Cryptomatte& cryptomatte) { return cryptomatte.manifest.empty(); });
    const Cryptomatte& last_resort = unlisted != cryptomattes.end() ? *unlisted : cryptomattes.front();
    return {&last_resort, matching_ids(last_resort, patterns)};
}

[[noreturn]] void fail_missing(const AovFrame& frame, const AssignRule& rule, size_t index, const std::string& what,
                               const std::string& remedy) {
    throw Error(ErrorCode::missing_channel, frame.label() + ": assign[" + std::to_string(index) + "] (material " +
                                                rule.material + ") needs " + what + ", which the frame does not have; " +
                                                remedy);
}

const Image& index_layer(const AovFrame& frame, Role role, const AssignRule& rule, size_t index) {
    if (const auto layer = frame.layers.find(role); layer != frame.layers.end()) return layer->second;
    const bool object = role == Role::object_id;
    fail_missing(frame, rule, index, object ? "an object index layer" : "a material index layer",
                 std::string("render one (") + (object ? "IndexOB" : "IndexMA") + " in Blender), name it with --channel " +
                     (object ? "object_id" : "material_id") + "=LAYER, or select by cryptomatte");
}

/// The objects each rule keeps: those that no later rule takes whole.
std::vector<NamedObjects> objects_of_rules(const AovFrame& frame, const std::vector<AssignRule>& rules) {
    std::vector<NamedObjects> objects(rules.size());
    for (size_t r = rules.size(); r-- > 0;) {
        if (rules[r].cryptomatte.empty()) continue;
        if (frame.cryptomattes.empty())
            fail_missing(frame, rules[r], r, "a cryptomatte", "render one, or select by object_index or material_index");
        objects[r] = find_objects(frame.cryptomattes, rules[r].cryptomatte);
        for (size_t later = r + 1; later < rules.size(); ++later) {
            const bool partly = rules[later].object_index || rules[later].material_index;
            if (partly || objects[later].cryptomatte != objects[r].cryptomatte) continue;
            std::vector<uint32_t> rest;
            std::set_difference(objects[r].ids.begin(), objects[r].ids.end(), objects[later].ids.begin(),
                                objects[later].ids.end(), std::back_inserter(rest));
            objects[r].ids = std::move(rest);
        }
    }
    return objects;
}

/// What one rule selects on its own.
struct Selector {
    NamedObjects objects;
    std::vector<std::pair<const Image*, float>> indices;  // layers, and the index each must show

    /// Share of each pixel from `first` on, where anything is left of it.
    void shares(size_t first, const std::vector<float>& left, std::vector<float>& share) const {
        std::ranges::transform(left, share.begin(), [](float rest) { return rest > 0 ? 1.0f : 0.0f; });
        for (const auto& [layer, wanted] : indices) {
            const float* index = layer->at(first);
            for (size_t i = 0; i < share.size(); ++i) share[i] = std::fabs(index[i] - wanted) < 0.5f ? share[i] : 0.0f;
        }
        if (!objects.cryptomatte) return;
        for (size_t i = 0; i < share.size(); ++i)
            if (share[i] > 0) share[i] = cryptomatte_coverage(*objects.cryptomatte, objects.ids, first + i);
    }
};

std::vector<Selector> selectors_of(const AovFrame& frame, const std::vector<AssignRule>& rules) {
    std::vector<NamedObjects> objects = objects_of_rules(frame, rules);
    std::vector<Selector> selectors;
    for (size_t r = 0; r < rules.size(); ++r) {
        Selector& selector = selectors.emplace_back(Selector{std::move(objects[r]), {}});
        const auto add = [&](Role role, const std::optional<int>& wanted) {
            if (wanted) selector.indices.emplace_back(&index_layer(frame, role, rules[r], r), static_cast<float>(*wanted));
        };
        add(Role::object_id, rules[r].object_index);
        add(Role::material_id, rules[r].material_index);
    }
    return selectors;
}

/// A row at work: what rules take and leave of its pixels.
struct RowShares {
    explicit RowShares(int width)
        : left(static_cast<size_t>(width)), share(left.size()), most(left.size()), rule(left.size()) {}

    std::vector<float> left, share, most;
    std::vector<int32_t> rule;
};

/// Gives each pixel from `first` on the rule that covers most of it, the last one first: what it takes is gone for the others.
void assign_row(const std::vector<Selector>& selectors, size_t first, RowShares& row, Assignment& result) {
    const size_t count = row.left.size();
    std::fill(row.left.begin(), row.left.end(), 1.0f), std::fill(row.most.begin(), row.most.end(), 0.0f);
    std::fill(row.rule.begin(), row.rule.end(), -1);
    float *left = row.left.data(), *most = row.most.data();
    int32_t* rule = row.rule.data();
    for (size_t r = selectors.size(); r-- > 0;) {
        selectors[r].shares(first, row.left, row.share);
        for (size_t i = 0; i < count; ++i) {
            const float taken = std::min(row.share[i], left[i]);
            left[i] -= taken;
            rule[i] = taken > most[i] ? static_cast<int32_t>(r) : rule[i];
            most[i] = std::max(taken, most[i]);
        }
    }
    std::copy(row.most.begin(), row.most.end(), result.coverage.begin() + static_cast<std::ptrdiff_t>(first));
    std::copy(row.rule.begin(), row.rule.end(), result.rule.begin() + static_cast<std::ptrdiff_t>(first));
}

/// Whether all values of a block are the same.
bool is_uniform(const int32_t* rules, size_t count) {
    int32_t differences = 0;
    for (size_t i = 0; i < count; ++i) differences |= rules[i] ^ rules[0];
    return differences == 0;
}

/// Adds the pixels of each rule, block by block: neighbours mostly wear the same.
void count_rules(const std::vector<int32_t>& rules, std::vector<size_t>& counts) {
    constexpr size_t kBlock = 64;
    for (size_t begin = 0; begin < rules.size(); begin += kBlock) {
        const size_t end = std::min(begin + kBlock, rules.size()),
                     step = is_uniform(&rules[begin], end - begin) ? end - begin : 1;
        for (size_t i = begin; i < end; i += step)
            if (rules[i] >= 0) counts[static_cast<size_t>(rules[i])] += step;
    }
}

}  // namespace

Assignment assign_rules(const AovFrame& frame, const std::vector<AssignRule>& rules) {
    if (rules.size() > static_cast<size_t>(std::numeric_limits<int16_t>::max()))
        throw Error(ErrorCode::bad_argument, "assign has " + std::to_string(rules.size()) + " rules; at most 32767");
    const int width = frame.data_window.width, height = frame.data_window.height;
    const size_t pixels = static_cast<size_t>(width) * height;
    Assignment result{width, height, {}, {}, std::vector<size_t>(rules.size())};
    result.rule.resize(pixels), result.coverage.resize(pixels);
    const std::vector<Selector> selectors = selectors_of(frame, rules);
    tbb::enumerable_thread_specific<RowShares> shares([&] { return RowShares(width); });
    tbb::enumerable_thread_specific<std::vector<size_t>> counts(result.counts);
    for_each_index(height, [&](int y) {
        RowShares& row = shares.local();
        assign_row(selectors, static_cast<size_t>(y) * width, row, result);
        count_rules(row.rule, counts.local());
    });
    for (const std::vector<size_t>& part : counts)
        for (size_t r = 0; r < part.size(); ++r) result.counts[r] += part[r];
    return result;
}

}  // namespace burnish
