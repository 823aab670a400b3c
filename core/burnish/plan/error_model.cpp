#include <burnish/plan/error_model.h>

#include <burnish/error_table_json.h>
#include <burnish/material/lobe.h>
#include <burnish/sampling/tuned_patterns.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

namespace burnish {
namespace {

using nlohmann::json;

using Gains = std::vector<PredictedGain>;  // one for each of configurations()
template <class Value>
using Curve = std::map<float, Value>;  // by what it is interpolated in, linearly in its logarithm

struct ErrorTable {
    std::map<LobeTail, Curve<Curve<Gains>>> gains;  // by aspect, then by width
    Curve<Gains> sparse;                            // by safety, one entry each
};

Gains gains_from_json(const json& entry, const char* mean) {
    const json &means = entry.at(mean), &deviations = entry.at("deviation");
    Gains gains;
    for (size_t i = 0; i < means.size(); ++i) gains.push_back({means.at(i).get<float>(), deviations.at(i).get<float>()});
    return gains;
}

const ErrorTable& error_table() {
    static const ErrorTable table = [] {
        const json document = json::parse(kErrorTableJson);
        ErrorTable made;
        for (const json& lobe : document.at("lobes")) {
            const LobeTail tail = lobe.at("tail") == "long" ? LobeTail::long_tail : LobeTail::gaussian;
            made.gains[tail][lobe.at("aspect").get<float>()][lobe.at("m").get<float>()] = gains_from_json(lobe, "gain");
        }
        for (const json& entry : document.at("sparse"))
            made.sparse[entry.at("safety").get<float>()] = gains_from_json(entry, "psnr");
        return made;
    }();
    return table;
}

Gains blend(const Gains& low, const Gains& high, float part) {
    Gains between;
    for (size_t i = 0; i < low.size(); ++i)
        between.push_back({std::lerp(low[i].mean, high[i].mean, part), std::lerp(low[i].deviation, high[i].deviation, part)});
    return between;
}

/// The curve at x; beyond its ends, its ends. `at`: of an entry, the gains there.
template <class Value, class At>
Gains interpolated(const Curve<Value>& curve, float x, At&& at) {
    const auto above = curve.upper_bound(x);
    if (above == curve.begin()) return at(above->second);
    const auto below = std::prev(above);
    if (above == curve.end()) return at(below->second);
    return blend(at(below->second), at(above->second), std::log(x / below->first) / std::log(above->first / below->first));
}

size_t tabulated_count() { return error_table().gains.begin()->second.begin()->second.begin()->second.size(); }

size_t place_of(const Configuration& configuration) {
    const auto& all = configurations();
    return static_cast<size_t>(std::ranges::find(all, configuration) - all.begin());
}

}  // namespace

PredictedGain predicted_gain(const LobeParameters& lobe, const Configuration& configuration) {
    const size_t place = place_of(configuration);
    if (place == configurations().size()) return {};
    if (place >= tabulated_count()) {  // more samples than were measured: errors fall as their number's root
        PredictedGain fewer = predicted_gain(lobe, configurations()[place - 1]);
        fewer.mean += 10 * std::log10(static_cast<float>(configuration.samples) / configurations()[place - 1].samples);
        return fewer;
    }
    const LobeTail tail =
        visit_lobe(lobe, [](const auto& model) { return lobe_tail([&](float xi) { return model.border(xi); }); });
    const float m = std::sqrt(lobe.mx * lobe.my), aspect = std::max(lobe.mx / lobe.my, lobe.my / lobe.mx);
    const auto own = [](const Gains& gains) { return gains; };
    const auto at_width = [&](const Curve<Gains>& by_width) { return interpolated(by_width, m, own); };
    return interpolated(error_table().gains.at(tail), aspect, at_width)[place];
}

PredictedGain predicted_sparse(float safety) {
    return interpolated(error_table().sparse, safety, [](const Gains& gains) { return gains; })[0];
}

}  // namespace burnish
