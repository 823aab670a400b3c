// Which rows of a data window an image holds: all, or strips spread evenly over it and stacked. Large frames are judged by
// strips: what a camera or a layer is shows in a part of the pixels, and the same part in every run.
#pragma once

#include <burnish/base/image.h>

#include <algorithm>

namespace burnish {

struct RowStrips {
    Window data;               // the whole data window
    int first, height, pitch;  // top row of the first strip, rows of a strip, rows from strip to strip
    int rows;                  // of all strips together: the height of the image

    /// All rows.
    RowStrips(const Window& window)
        : data(window), first(0), height(std::max(window.height, 1)), pitch(height), rows(window.height) {}

    /// Strips of `block` rows that start at multiples of `block`, as many as `pixels` allow, one at least; all rows where they
    /// fit. `block`: the rows a file unpacks together.
    static RowStrips spread(const Window& window, int block, size_t pixels) {
        const int strips = std::max(static_cast<int>(pixels / (static_cast<size_t>(window.width) * block)), 1);
        RowStrips spread(window);
        const size_t all = static_cast<size_t>(window.width) * window.height;
        if (all <= pixels || static_cast<long long>(strips) * block >= window.height) return spread;
        spread.height = block, spread.pitch = window.height / strips / block * block, spread.rows = strips * block;
        spread.first = (window.height - (strips - 1) * spread.pitch - block) / 2 / block * block;
        return spread;
    }

    bool is_whole() const { return rows == data.height; }
    /// Row of the data window (0 on top) that row `y` of the image shows.
    int row(int y) const { return first + y / height * pitch + y % height; }
    /// Whether the rows above and below `y` in the image are its neighbours in the frame too.
    bool has_neighbours(int y) const { return y % height > 0 && y % height + 1 < height; }
};

}  // namespace burnish
