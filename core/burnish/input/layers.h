// The layers of a file: channels of all parts, gathered by layer name, for one view.
//
// OpenEXR says the layer is in the channel name and the part name means nothing; Nuke, V-Ray and others write bare R, G, B
// into a part named after the layer. So: a channel with a dot names its layer; a bare one belongs to the main layer in the
// first part, to the layer named like the part elsewhere.
#pragma once

#include <string>
#include <vector>

namespace burnish {

enum class ChannelType { half, float32, uint32 };

struct Channel {
    std::string name;       // full name in the file
    std::string component;  // normal form: r g b a x y z w u v, else lower case
    int part = 0, index = 0;
    ChannelType type = ChannelType::float32;
};

struct Layer {
    std::string name;  // "" is the main layer
    std::vector<Channel> channels;

    /// The channel of that component, null when there is none.
    const Channel* find(const std::string& component) const;
};

/// The names in one part of a file, as its header gives them.
struct PartNames {
    std::string name, view;
    std::vector<std::string> channels;
    std::vector<ChannelType> types;
    std::vector<std::string> multi_view;  // the older way: views inside one part, the first is unmarked
};

/// All views of a file, in its order; empty for a mono file.
std::vector<std::string> views_of(const std::vector<PartNames>& parts);

/// Layers of the given view ("" = every channel is the only view's), in the order of the file.
std::vector<Layer> gather_layers(const std::vector<PartNames>& parts, const std::string& view);

}  // namespace burnish
