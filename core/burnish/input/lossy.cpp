#include <burnish/input/lossy.h>

#include <burnish/input/channel_names.h>

#include <algorithm>
#include <array>

namespace burnish {
namespace {

/// DWA packs what looks like colour by its name, whatever it holds: X and Z of a position stay, Y does not.
bool is_dwa_color(const Channel& channel) {
    constexpr std::array<std::string_view, 6> kEnds{"R", "G", "B", "Y", "BY", "RY"};
    return channel.type != ChannelType::uint32 &&
           std::ranges::find(kEnds, split_channel(channel.name).component) != kEnds.end();
}

bool is_changed(const std::string& compression, const Channel& channel) {
    if (compression.starts_with("dwa")) return is_dwa_color(channel);
    if (compression.starts_with("b44")) return channel.type == ChannelType::half;
    return compression == "pxr24" && channel.type == ChannelType::float32;
}

}  // namespace

std::vector<std::string> changed_channels(const std::string& compression, const std::vector<Channel>& channels) {
    std::vector<std::string> names;
    for (const Channel& channel : channels)
        if (is_changed(compression, channel)) names.push_back(channel.name);
    return names;
}

}  // namespace burnish
