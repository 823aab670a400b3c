#include <burnish/input/channel_names.h>
#include <burnish/input/cryptomatte.h>
#include <burnish/input/metadata.h>
#include <burnish/input/read_cryptomattes.h>

#include <map>
#include <set>

namespace burnish {

std::vector<Cryptomatte> read_cryptomattes(const ExrFile& file, const Window& window, std::vector<std::string>& warnings) {
    CryptomatteSource source;
    source.file = file.name();
    std::map<std::string, Channel> channels;  // by layer and component: bare channels of a part count as the part's layer
    std::set<int> parts;
    for (const Layer& layer : file.layers()) {
        for (const Channel& channel : layer.channels) {
            const std::string name = (layer.name.empty() ? "" : layer.name + ".") + split_channel(channel.name).component;
            channels[name] = channel;
            source.channels.push_back({name, channel.type == ChannelType::float32});
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
    source.read = [&](const std::vector<std::string>& names) {
        Image image(window.width, window.height, static_cast<int>(names.size()));
        std::vector<ChannelRead> reads;
        for (size_t c = 0; c < names.size(); ++c) reads.push_back({channels.at(names[c]), &image, static_cast<int>(c)});
        file.read(reads, window);
        return image;
    };
    return decode_cryptomattes(source, warnings);
}

}  // namespace burnish
