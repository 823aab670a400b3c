// The bandwidth study to look at: a render, what was measured in it and what was predicted, side by side.
#pragma once

#include "bench/window_bandwidth.h"

#include <string>
#include <utility>
#include <vector>

namespace burnish {

/// Luminance of a render, linear, or scaled to a mean of 0.18 and encoded as a display would.
Image luminance_picture(const Image& rgb, bool display);

class BandwidthPictures {
public:
    /// `windows` are `stride` pixels apart; each is shown about its middle.
    BandwidthPictures(const Image& render, const std::vector<PictureWindow>& windows, int stride);

    /// Predicted cycles per pixel, one channel, 0 where nothing is.
    void add(const std::string& prediction, const Image& bandwidth) { m_bandwidths.emplace_back(prediction, bandwidth); }

    /// Writes `name`.png, levels in their colours beside the render, and `name`.exr, RGB and a layer of cycles per pixel each.
    void write(const std::string& name) const;

private:
    Image m_render;
    std::vector<std::pair<std::string, Image>> m_bandwidths;  // "measured" first
};

}  // namespace burnish
