// A float image: what every stage hands to the next. Meaning (which layer, which colour space) is the holder's business.
#pragma once

#include <burnish/base/pixel_vector.h>

#include <cstddef>

namespace burnish {

/// A rectangle of pixels, origin included; x right, y down, as in EXR data and display windows.
struct Window {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Window&) const = default;
};

/// Interleaved float pixels, row 0 on top, shape (height, width, channels).
struct Image {
    int width = 0, height = 0, channels = 0;
    PixelVector<float> data;

    Image() = default;
    Image(int columns, int rows, int depth, float value = 0.0f)
        : width(columns), height(rows), channels(depth), data(static_cast<size_t>(columns) * rows * depth, value) {}
    /// Pixels of any value, for those who write all of them.
    static Image unset(int columns, int rows, int depth) {
        Image image;
        image.width = columns, image.height = rows, image.channels = depth;
        image.data.resize(static_cast<size_t>(columns) * rows * depth);
        return image;
    }

    bool empty() const { return data.empty(); }
    size_t pixel_count() const { return static_cast<size_t>(width) * height; }
    float* at(int x, int y) { return &data[(static_cast<size_t>(y) * width + x) * channels]; }
    const float* at(int x, int y) const { return &data[(static_cast<size_t>(y) * width + x) * channels]; }
    /// Pixel by flat index y * width + x.
    float* at(size_t index) { return &data[index * channels]; }
    const float* at(size_t index) const { return &data[index * channels]; }
};

}  // namespace burnish
