#include "bench/bandwidth_pictures.h"

#include <burnish/base/types.h>
#include <burnish/output/exr_writer.h>
#include <burnish/output/level_colors.h>
#include <burnish/output/preview.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

Image level_colors(const Image& bandwidth) {
    Image picture(bandwidth.width, bandwidth.height, 3);
    for (size_t i = 0; i < picture.pixel_count(); ++i)
        if (*bandwidth.at(i) > 0) std::copy_n(&level_color(windowed_level(*bandwidth.at(i))).x, 3, picture.at(i));
    return picture;
}

Image gray_picture(const Image& render) {
    const Image encoded = luminance_picture(render, true);
    Image picture(render.width, render.height, 3);
    for (size_t i = 0; i < picture.pixel_count(); ++i) std::fill_n(picture.at(i), 3, *encoded.at(i));
    return picture;
}

Image beside(const std::vector<Image>& pictures) {
    const Image& first = pictures.front();
    Image all(first.width * static_cast<int>(pictures.size()), first.height, 3);
    for (size_t k = 0; k < pictures.size(); ++k)
        for (int y = 0; y < first.height; ++y)
            std::copy_n(pictures[k].at(0, y), first.width * 3, all.at(static_cast<int>(k) * first.width, y));
    return all;
}

}  // namespace

Image luminance_picture(const Image& rgb, bool display) {
    Image image(rgb.width, rgb.height, 1);
    double sum = 0, count = 0;
    for (size_t i = 0; i < rgb.pixel_count(); ++i) {
        image.data[i] = luminance({rgb.at(i)[0], rgb.at(i)[1], rgb.at(i)[2]});
        sum += image.data[i], count += image.data[i] > 0;
    }
    const auto exposure = static_cast<float>(0.18 * count / std::max(sum, 1e-30));
    if (display)
        for (float& value : image.data) value = std::pow(std::min(value * exposure, 1.0f), 1 / 2.2f);
    return image;
}

BandwidthPictures::BandwidthPictures(const Image& render, const std::vector<PictureWindow>& windows, int stride)
    : m_render(render) {
    Image measured(render.width, render.height, 1);
    const int inset = (PictureWindow::kSize - stride) / 2;
    for (const PictureWindow& w : windows)
        for (int y = 0; y < stride; ++y) std::fill_n(measured.at(w.x + inset, w.y + inset + y), stride, w.bandwidth);
    add("measured", measured);
}

void BandwidthPictures::write(const std::string& name) const {
    AovFrame frame;
    frame.data_window = frame.display_window = {0, 0, m_render.width, m_render.height};
    std::vector<Image> pictures{gray_picture(m_render)};
    std::vector<OutputLayer> layers{{{"R", "G", "B"}, &m_render}};
    for (const auto& [what, bandwidth] : m_bandwidths) {
        pictures.push_back(level_colors(bandwidth));
        layers.push_back({{what + ".X"}, &bandwidth});
    }
    write_code_values(name + ".png", beside(pictures));
    write_exr(name + ".exr", frame, layers, PixelType::float32);
}

}  // namespace burnish
