#include <burnish/input/channel_names.h>
#include <burnish/input/layers.h>
#include <burnish/input/roles.h>

#include <algorithm>

namespace burnish {
namespace {

bool contains(const std::vector<std::string>& list, const std::string& item) {
    return std::find(list.begin(), list.end(), item) != list.end();
}

bool is_rgba(const std::string& component) {
    return component.size() == 1 && std::string("rgba").find(component) != std::string::npos;
}

/// Takes the view's name out of "left.R", "normal.left.X" or "left.normal.X"; the first view of the list when none is named.
std::string take_view(std::string& channel, const std::vector<std::string>& multi_view) {
    ChannelName name = split_channel(channel);
    const std::string last(last_token(name.layer)), first = name.layer.substr(0, name.layer.find('.'));
    for (const std::string& view : {last, first}) {
        if (!contains(multi_view, view)) continue;
        std::string layer = view == last ? std::string(parent_path(name.layer)) : name.layer.substr(first.size() + 1);
        channel = layer.empty() ? name.component : layer + "." + name.component;
        return view;
    }
    return multi_view.front();
}

/// Files of some tools spread the main layer over parts of one channel each, with part names that say nothing.
bool main_layer_is_scattered(const std::vector<PartNames>& parts) {
    const auto bare = [](const PartNames& part, const char* component) {
        return std::any_of(part.channels.begin(), part.channels.end(),
                           [&](const std::string& name) { return normal_component(name) == component; });
    };
    return parts.size() > 1 && bare(parts[0], "r") && !bare(parts[0], "g");
}

bool names_a_data_layer(const std::string& part_name) {
    const std::string form = normal_form(part_name);
    for (const RoleInfo& info : roles())
        if (info.role != Role::beauty && info.role != Role::alpha && !form.empty() &&
            std::find(info.aliases.begin(), info.aliases.end(), form) != info.aliases.end())
            return true;
    return false;
}

std::string layer_of(const ChannelName& name, const PartNames& part, bool is_main_part, bool scattered) {
    if (!name.layer.empty()) return without_view(name.layer, part.view);
    const std::string component = normal_component(name.component);
    if (is_rgba(component) && (is_main_part || scattered)) return "";
    if (is_main_part || part.name.empty()) return name.component;  // "Z", "pscale": a layer of its own
    return without_view(part.name, part.view);
}

void add_channel(std::vector<Layer>& layers, const std::string& layer_name, Channel channel) {
    auto layer = std::find_if(layers.begin(), layers.end(), [&](const Layer& l) { return l.name == layer_name; });
    if (layer == layers.end()) layer = layers.insert(layers.end(), {layer_name, {}});
    if (!layer->find(channel.component)) layer->channels.push_back(std::move(channel));
}

}  // namespace

const Channel* Layer::find(const std::string& component) const {
    for (const Channel& channel : channels)
        if (channel.component == component) return &channel;
    return nullptr;
}

std::vector<std::string> views_of(const std::vector<PartNames>& parts) {
    std::vector<std::string> views;
    for (const PartNames& part : parts) {
        if (!part.view.empty() && !contains(views, part.view)) views.push_back(part.view);
    }
    if (views.empty() && parts.size() == 1) views = parts[0].multi_view;
    return views;
}

std::vector<Layer> gather_layers(const std::vector<PartNames>& parts, const std::string& view) {
    std::vector<Layer> layers;
    const bool scattered = main_layer_is_scattered(parts);
    bool is_first = true;
    for (size_t p = 0; p < parts.size(); ++p) {
        const PartNames& part = parts[p];
        if (!view.empty() && !part.view.empty() && part.view != view) continue;
        const bool is_main_part = is_first && !(parts.size() > 1 && names_a_data_layer(without_view(part.name, part.view)));
        is_first = false;
        for (size_t c = 0; c < part.channels.size(); ++c) {
            std::string full = part.channels[c];
            if (!part.multi_view.empty() && parts.size() == 1 && take_view(full, part.multi_view) != view) continue;
            const ChannelName name = split_channel(full);
            const std::string layer = layer_of(name, part, is_main_part, scattered);
            add_channel(
                layers, layer,
                {part.channels[c], normal_component(name.component), static_cast<int>(p), static_cast<int>(c), part.types[c]});
        }
    }
    return layers;
}

}  // namespace burnish
