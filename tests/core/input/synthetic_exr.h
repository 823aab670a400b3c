// EXR files made for tests: any channel names, parts, windows, types and attributes.
#pragma once

#include <burnish/base/image.h>

#include <OpenImageIO/imageio.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace burnish {

/// Channels of one layer: `names` are full, "ViewLayer.Normal.X".
struct SyntheticLayer {
    std::vector<std::string> names;
    Image image;
    OIIO::TypeDesc type = OIIO::TypeFloat;
};

struct SyntheticPart {
    std::vector<SyntheticLayer> layers;
    std::string name = {}, view = {};
    std::vector<std::pair<std::string, std::string>> attributes = {};
    Window data = {}, display = {};  // empty: the size of the first layer, at 0, 0
    int tile = 0;
    std::string compression = "zip";
};

inline OIIO::ImageSpec spec_of(const SyntheticPart& part) {
    const Image& first = part.layers.front().image;
    const Window data = part.data.width ? part.data : Window{0, 0, first.width, first.height};
    const Window display = part.display.width ? part.display : data;
    OIIO::ImageSpec spec(data.width, data.height, 0, OIIO::TypeFloat);
    spec.x = data.x, spec.y = data.y;
    spec.full_x = display.x, spec.full_y = display.y, spec.full_width = display.width, spec.full_height = display.height;
    for (const SyntheticLayer& layer : part.layers)
        for (const std::string& name : layer.names) {
            spec.channelnames.push_back(name);
            spec.channelformats.push_back(layer.type);
        }
    spec.nchannels = static_cast<int>(spec.channelnames.size());
    spec.tile_width = spec.tile_height = part.tile;
    spec.attribute("compression", part.compression);
    if (!part.name.empty()) spec.attribute("oiio:subimagename", part.name);
    if (!part.view.empty()) spec.attribute("view", part.view);
    for (const auto& [name, value] : part.attributes) spec.attribute(name, value);
    return spec;
}

/// All channels interleaved in the native type of each.
inline std::vector<char> native_pixels(const SyntheticPart& part, const OIIO::ImageSpec& spec) {
    std::vector<char> bytes(spec.image_bytes(true));
    size_t offset = 0;
    for (const SyntheticLayer& layer : part.layers)
        for (int c = 0; c < layer.image.channels; ++c) {
            for (size_t i = 0; i < layer.image.pixel_count(); ++i) {
                char* to = bytes.data() + i * spec.pixel_bytes(true) + offset;
                const float value = layer.image.at(i)[c];
                if (layer.type == OIIO::TypeUInt32)
                    *reinterpret_cast<uint32_t*>(to) = static_cast<uint32_t>(value);
                else
                    OIIO::convert_pixel_values(OIIO::TypeFloat, &value, layer.type, to, 1);
            }
            offset += layer.type.size();
        }
    return bytes;
}

inline std::string write_synthetic(const std::string& file, const std::vector<SyntheticPart>& parts) {
    std::vector<OIIO::ImageSpec> specs;
    for (const SyntheticPart& part : parts) specs.push_back(spec_of(part));
    const auto output = OIIO::ImageOutput::create("openexr");
    bool written = output->open(file, static_cast<int>(specs.size()), specs.data());
    for (size_t p = 0; written && p < parts.size(); ++p) {
        if (p > 0) written = output->open(file, specs[p], OIIO::ImageOutput::AppendSubimage);
        written = written && output->write_image(OIIO::TypeUnknown, native_pixels(parts[p], specs[p]).data());
    }
    if (!written || !output->close()) throw std::runtime_error(file + ": " + output->geterror());
    return file;
}

}  // namespace burnish
