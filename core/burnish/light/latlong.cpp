#include <burnish/light/latlong.h>

namespace burnish {

Color3f latlong_bilinear(const Image& picture, const Vec2f& uv) {
    const int width = picture.width, height = picture.height;
    const float x = uv.x * static_cast<float>(width) - 0.5f, y = uv.y * static_cast<float>(height) - 0.5f;
    const float left = std::floor(x), top = std::floor(y), fx = x - left, fy = y - top;
    // A coordinate that is not a number lands on the first texel.
    const auto column = [&](float c) { return c >= 0.0f ? static_cast<int>(c) % width : width - 1; };
    const auto row = [&](float r) { return static_cast<int>(std::min(std::max(0.0f, r), static_cast<float>(height - 1))); };
    const int x0 = column(left), x1 = column(left + 1.0f), y0 = row(top), y1 = row(top + 1.0f);
    const float *p00 = picture.at(x0, y0), *p10 = picture.at(x1, y0), *p01 = picture.at(x0, y1), *p11 = picture.at(x1, y1);
    Color3f value;
    for (int k = 0; k < 3; ++k) {
        value[k] = (1.0f - fy) * ((1.0f - fx) * p00[k] + fx * p10[k]) + fy * ((1.0f - fx) * p01[k] + fx * p11[k]);
    }
    return value;
}

}  // namespace burnish
