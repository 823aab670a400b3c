#include <burnish/scene/map_pyramid.h>

#include <burnish/base/parallel.h>

#include <algorithm>

namespace burnish {
namespace {

Image halved(const Image& picture) {
    Image half = Image::unset((picture.width + 1) / 2, (picture.height + 1) / 2, 3);
    for_each_index(half.height, [&](int y) {
        const int y0 = 2 * y, y1 = std::min(y0 + 1, picture.height - 1);
        for (int x = 0; x < half.width; ++x) {
            const int x0 = 2 * x, x1 = std::min(x0 + 1, picture.width - 1);
            const float *a = picture.at(x0, y0), *b = picture.at(x1, y0), *c = picture.at(x0, y1), *d = picture.at(x1, y1);
            for (int k = 0; k < 3; ++k) half.at(x, y)[k] = 0.25f * (a[k] + b[k] + c[k] + d[k]);
        }
    });
    return half;
}

/// Of a coordinate in texels; what is not a number is 0.
float inside(float x, int size) { return std::min(std::max(0.0f, x), static_cast<float>(size - 1)); }

Color3f mix(const float* a, const float* b, float t) {
    return {a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t};
}

}  // namespace

MapPyramid::MapPyramid(Image picture, int halvings) {
    if (picture.empty()) return;
    m_levels.push_back(std::move(picture));
    for (int i = 0; i < halvings && std::max(m_levels.back().width, m_levels.back().height) > 1; ++i)
        m_levels.push_back(halved(m_levels.back()));
}

float MapPyramid::resolution() const {
    return empty() ? 0 : std::sqrt(static_cast<float>(m_levels[0].width) * static_cast<float>(m_levels[0].height));
}

float MapPyramid::widest() const { return empty() ? 0 : std::exp2(static_cast<float>(m_levels.size())); }

Color3f MapPyramid::at(const Vec2f& uv, float texels) const {
    const Image& picture = m_levels[0];
    const Vec2f place(uv.x * static_cast<float>(picture.width), (1 - uv.y) * static_cast<float>(picture.height));
    const float level = texels > 2 ? std::min(std::log2(texels) - 1, static_cast<float>(m_levels.size() - 1)) : 0.0f;
    const auto finer = static_cast<size_t>(level);
    const Color3f value = bilinear(finer, place);
    const float t = level - static_cast<float>(finer);
    return t > 0 ? value + (bilinear(finer + 1, place) - value) * t : value;
}

Color3f MapPyramid::bilinear(size_t level, const Vec2f& place) const {
    const Image& texels = m_levels[level];
    const float scale = std::ldexp(1.0f, -static_cast<int>(level));
    const float x = inside(place.x * scale - 0.5f, texels.width), y = inside(place.y * scale - 0.5f, texels.height);
    const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, texels.width - 1), y1 = std::min(y0 + 1, texels.height - 1);
    const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
    const Color3f above = mix(texels.at(x0, y0), texels.at(x1, y0), fx), below = mix(texels.at(x0, y1), texels.at(x1, y1), fx);
    return above + (below - above) * fy;
}

}  // namespace burnish
