// Channels of a real EXR as an image, read straight with OpenImageIO.
#pragma once

#include <burnish/base/image.h>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

inline burnish::Image read_layer(const std::filesystem::path& file, const std::vector<std::string>& channels) {
    const OIIO::ImageBuf all(file.string());
    std::vector<int> order;
    for (const std::string& name : channels) {
        order.push_back(all.spec().channelindex(name));
        if (order.back() < 0) throw std::runtime_error(file.string() + " has no channel " + name);
    }
    const OIIO::ImageBuf chosen = OIIO::ImageBufAlgo::channels(all, static_cast<int>(channels.size()), order);
    burnish::Image image(all.spec().width, all.spec().height, static_cast<int>(channels.size()));
    if (!chosen.get_pixels(chosen.roi(), OIIO::TypeFloat, image.data.data())) throw std::runtime_error(chosen.geterror());
    return image;
}
