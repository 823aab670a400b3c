#include <burnish/frequency/bandwidth_buffer.h>

#include <burnish/base/parallel.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

template <class Choose>
Image halved(const Image& fine, const Choose& choose) {
    Image coarse((fine.width + 1) / 2, (fine.height + 1) / 2, fine.channels);
    for_each_index(coarse.height, [&](int y) {
        const int top = 2 * y, bottom = std::min(top + 1, fine.height - 1);
        for (int x = 0; x < coarse.width; ++x) {
            const int left = 2 * x, right = std::min(left + 1, fine.width - 1);
            const float *a = fine.at(left, top), *b = fine.at(right, top), *c = fine.at(left, bottom),
                        *d = fine.at(right, bottom);
            for (int k = 0; k < fine.channels; ++k) coarse.at(x, y)[k] = choose(choose(a[k], b[k]), choose(c[k], d[k]));
        }
    });
    return coarse;
}

template <class Choose>
std::vector<Image> pyramid(Image finest, const Choose& choose) {
    std::vector<Image> levels;
    levels.push_back(std::move(finest));
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(halved(levels.back(), choose));
    return levels;
}

}  // namespace

float shading_level(float cycles_per_pixel, int width, int height) {
    const float coarsest = std::floor(std::log2(static_cast<float>(std::min(width, height))));
    if (!(cycles_per_pixel > 0)) return coarsest;
    return std::clamp(std::floor(-std::log2(2 * cycles_per_pixel)), 0.0f, coarsest);
}

std::vector<Image> min_pyramid(Image finest) {
    return pyramid(std::move(finest), [](float a, float b) { return std::min(a, b); });
}

std::vector<Image> max_pyramid(Image finest) {
    return pyramid(std::move(finest), [](float a, float b) { return std::max(a, b); });
}

}  // namespace burnish
