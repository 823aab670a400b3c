#include <burnish/base/error.h>
#include <burnish/input/candidates.h>
#include <burnish/input/channel_names.h>

#include <algorithm>
#include <cctype>
#include <tuple>

namespace burnish {
namespace {

std::string letters(const std::vector<Channel>& channels) {
    std::string text;
    for (const Channel& channel : channels) {
        if (channel.component.size() > 1) return channels.size() == 1 ? channel.component : "";
        for (const char c : channel.component) text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    return text;
}

std::string type_name(ChannelType type) {
    switch (type) {
        case ChannelType::half: return "half";
        case ChannelType::float32: return "float";
        case ChannelType::uint32: return "uint";
    }
    return "";
}

/// The first list of components the layer has completely; empty when it has none.
std::vector<Channel> pick(const Layer& layer, const std::vector<std::vector<std::string>>& lists) {
    for (const std::vector<std::string>& list : lists) {
        std::vector<Channel> channels;
        for (const std::string& component : list)
            if (const Channel* channel = layer.find(component)) channels.push_back(*channel);
        if (channels.size() == list.size()) return channels;
    }
    return {};
}

std::vector<Channel> channels_for(Role role, const Layer& layer) {
    const bool is_single = layer.channels.size() == 1;
    switch (role_info(role).channels) {
        case 3: return pick(layer, {{"x", "y", "z"}, {"r", "g", "b"}});
        case 2: return pick(layer, {{"u", "v"}, {"x", "y"}, {"r", "g"}});
        default: break;
    }
    if (role == Role::alpha) {
        const bool is_alpha_layer = normal_form(layer.name) == "alpha" || normal_form(layer.name) == "a";
        return is_single && is_alpha_layer ? layer.channels : pick(layer, {{"a"}});
    }
    if (is_single) return layer.channels;
    if (role == Role::depth) return pick(layer, {{"z"}, {"r"}});
    return pick(layer, {{"x"}, {"r"}, {"v"}, {"y"}, {"z"}});
}

/// Place of the layer among the role's aliases; the renderer's own names come after the general ones. -1: no match.
int rank_of(const RoleInfo& info, const std::string& form, bool has_meaning) {
    const auto alias = std::find(info.aliases.begin(), info.aliases.end(), form);
    if (alias != info.aliases.end()) return static_cast<int>(alias - info.aliases.begin());
    return has_meaning ? static_cast<int>(info.aliases.size()) : -1;
}

struct Ranked {
    Candidate candidate;
    int rank;
};

std::vector<Ranked> by_rank(Role role, const std::vector<Layer>& layers, Renderer renderer) {
    std::vector<Ranked> ranked;
    for (const Layer& layer : layers) {
        const std::string form = normal_form(layer.name);
        const std::optional<Meaning> meaning = meaning_of(renderer, role, form);
        const int rank = rank_of(role_info(role), form, meaning.has_value());
        std::vector<Channel> channels = rank < 0 ? std::vector<Channel>() : channels_for(role, layer);
        if (channels.empty()) continue;
        const bool is_inverted = role == Role::roughness && form.ends_with("glossiness");
        ranked.push_back({{layer.name, std::move(channels), meaning.value_or(Meaning{}), is_inverted, false}, rank});
    }
    std::stable_sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) { return a.rank < b.rank; });
    return ranked;
}

bool equal_without_case(const std::string& a, const std::string& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// By full name, else by last token, neither minding case.
const Layer* layer_named(const std::string& name, const std::vector<Layer>& layers) {
    for (const Layer& layer : layers)
        if (layer.name == name) return &layer;
    for (const Layer& layer : layers)
        if (equal_without_case(layer.name, name) || equal_without_case(std::string(last_token(layer.name)), name))
            return &layer;
    return nullptr;
}

const Channel* channel_named(const std::string& name, const std::vector<Layer>& layers) {
    for (const Layer& layer : layers)
        for (const Channel& channel : layer.channels)
            if (channel.name == name) return &channel;
    return nullptr;
}

}  // namespace

std::string Candidate::description() const {
    const bool is_bare = channels.front().name == layer;
    const std::string shown = is_bare ? "" : letters(channels);
    return (layer.empty() ? "the main layer" : layer) + " (" + (shown.empty() ? "" : shown + ", ") +
           type_name(channels.front().type) + ")";
}

std::vector<Candidate> candidates(Role role, const std::vector<Layer>& layers, Renderer renderer) {
    const std::vector<Ranked> beauty = by_rank(Role::beauty, layers, renderer);
    const std::string path(beauty.empty() ? "" : parent_path(beauty.front().candidate.layer));
    std::vector<Ranked> ranked = by_rank(role, layers, renderer);
    std::stable_sort(ranked.begin(), ranked.end(), [&](const Ranked& a, const Ranked& b) {
        return (parent_path(a.candidate.layer) == path) > (parent_path(b.candidate.layer) == path);
    });
    std::vector<Candidate> result;
    for (Ranked& entry : ranked) result.push_back(std::move(entry.candidate));
    return result;
}

Candidate chosen_candidate(const std::string& file, Role role, const std::string& name, const std::vector<Layer>& layers) {
    Candidate candidate{name, {}, {}, false, true};
    if (const Layer* layer = layer_named(name, layers)) {
        candidate.layer = layer->name;
        candidate.channels = channels_for(role, *layer);
        candidate.is_inverted = role == Role::roughness && normal_form(name).ends_with("glossiness");
    } else if (const Channel* channel = channel_named(name, layers); channel && role_info(role).channels == 1) {
        candidate.channels = {*channel};
    }
    if (!candidate.channels.empty()) return candidate;
    const std::string needs = std::to_string(role_info(role).channels);
    throw Error(ErrorCode::missing_channel, file + ": --channel " + std::string(role_info(role).name) + "=" + name +
                                                ": there is no such layer of " + needs + " channels; the file has " +
                                                list_layers(layers));
}

std::string list_layers(const std::vector<Layer>& layers) {
    std::string text;
    for (const Layer& layer : layers) {
        const std::string shown = letters(layer.channels);
        std::string entry = layer.name.empty() ? shown : layer.name;
        if (!layer.name.empty() && !shown.empty() && layer.channels.front().name != layer.name) entry += "." + shown;
        text += (text.empty() ? "" : ", ") + entry;
    }
    return text;
}

}  // namespace burnish
