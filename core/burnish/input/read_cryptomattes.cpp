#include <burnish/input/channel_names.h>
#include <burnish/input/cryptomatte.h>
#include <burnish/input/metadata.h>
#include <burnish/input/read_cryptomattes.h>

#include <map>
#include <set>

namespace burnish {
namespace {

/// By layer and component: bare channels of a part count as the part's layer.
std::string full_name(const Layer& layer, const Channel& channel) {
    return (layer.name.empty() ? "" : layer.name + ".") + split_channel(channel.name).component;
}

}  // namespace

std::vector<Cryptomatte> find_cryptomattes(const ExrFile& file, std::vector<std::string>& warnings) {
    CryptomatteSource source;
    source.file = file.name();
    std::set<int> parts;
    for (const Layer& layer : file.layers()) {
        for (const Channel& channel : layer.channels) {
            source.channels.push_back({full_name(layer, channel), channel.type == ChannelType::float32});
            parts.insert(channel.part);
        }
    }
    std::set<std::string> seen;
    for (const int part : parts) {
        const auto metadata = file.metadata(part);
        for (const std::string& name : attribute_names(*metadata))
            if (const auto value = string_attribute(*metadata, name); value && seen.insert(name).second)
                source.attributes.push_back({name, *value});
    }
    return decode_cryptomattes(source, warnings);
}

std::vector<Channel> channels_of(const ExrFile& file, const Cryptomatte& cryptomatte) {
    std::map<std::string, Channel> by_name;
    for (const Layer& layer : file.layers())
        for (const Channel& channel : layer.channels) by_name[full_name(layer, channel)] = channel;
    std::vector<Channel> channels;
    for (const std::string& name : cryptomatte.channels) channels.push_back(by_name.at(name));
    return channels;
}

void read_ranks(const ExrFile& file, const Window& window, Cryptomatte& cryptomatte) {
    const std::vector<Channel> channels = channels_of(file, cryptomatte);
    cryptomatte.ranks.assign(cryptomatte.channels.size() / 2, Image(window.width, window.height, 2));
    std::vector<ChannelRead> reads;
    for (size_t c = 0; c < channels.size(); ++c)
        reads.push_back({channels[c], &cryptomatte.ranks[c / 2], static_cast<int>(c % 2)});
    file.read(reads, window);
}

}  // namespace burnish
