#include <burnish/light/filter/planar_stack.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>

#include <algorithm>
#include <numbers>
#include <string>

namespace burnish {
namespace {

constexpr float kTexelArea = 1 / 12.0f, kTent = 1 / 6.0f;  // variance of a texel's square and of the bilinear tent, texels^2
constexpr float kTexelPerSigma = 0.75f;
constexpr float kKernelReach = 3.5f;  // deviations

/// Variance of what a level's texels hold, texels of the picture squared.
float content(const PlanarStack::Level& level) {
    return level.sigma * level.sigma - kTent * static_cast<float>(level.scale * level.scale);
}

int margin_of(float sigma, int scale) { return static_cast<int>(std::ceil(kKernelReach * sigma / static_cast<float>(scale))); }

/// Where a place lies between four texels: offset of the upper left one, and the weights of all.
struct Corners {
    size_t first = 0;
    float weight[4] = {};
    bool is_inside = false;

    /// (x, y) in texels of `image`, centres at + 0.5.
    Corners(const Image& image, float x, float y, float share) {
        is_inside =
            x >= 0.5f && y >= 0.5f && x < static_cast<float>(image.width) - 0.5f && y < static_cast<float>(image.height) - 0.5f;
        if (!is_inside) return;
        const int ix = static_cast<int>(x - 0.5f), iy = static_cast<int>(y - 0.5f);
        const float fx = x - 0.5f - static_cast<float>(ix), fy = (y - 0.5f - static_cast<float>(iy)) * share;
        first = static_cast<size_t>(iy) * static_cast<size_t>(image.width) + static_cast<size_t>(ix);
        weight[3] = fx * fy, weight[2] = fy - weight[3], weight[1] = fx * share - weight[3];
        weight[0] = share - fy - weight[1];
    }

    template <int channels>
    void add(const Image& image, float* sum) const {
        const float *above = &image.data[first * channels], *below = above + static_cast<size_t>(image.width) * channels;
        for (int c = 0; c < channels; ++c)
            sum[c] +=
                weight[0] * above[c] + weight[1] * above[c + channels] + weight[2] * below[c] + weight[3] * below[c + channels];
    }
};

/// The picture within an edge of nothing, so that lookups fade over the last half texel.
Image with_edge(const Image& picture) {
    Image image(picture.width + 2, picture.height + 2, 4);
    for (int y = 0; y < picture.height; ++y)
        std::copy_n(picture.at(0, y), static_cast<size_t>(picture.width) * 4, image.at(1, y + 1));
    return image;
}

/// One axis of the way from a level's texels to the next one's.
struct Resampling {
    int from_margin, from_scale, to_margin, to_scale;
    float sigma;  // of the kernel, texels of the picture

    /// Weights of the source texels [first, first + size) about texel i of the new level.
    int weights(int i, std::vector<float>& out) const {
        const float centre = (static_cast<float>(i - to_margin) + 0.5f) * static_cast<float>(to_scale);
        const auto place = [&](int texel) {
            return (static_cast<float>(texel - from_margin) + 0.5f) * static_cast<float>(from_scale);
        };
        const float reach = kKernelReach * sigma, scale = static_cast<float>(from_scale);
        const int first = static_cast<int>(std::ceil((centre - reach) / scale - 0.5f)) + from_margin;
        out.clear();
        float sum = 0;
        for (int texel = first; place(texel) <= centre + reach; ++texel) {
            const float distance = (place(texel) - centre) / sigma;
            sum += out.emplace_back(std::exp(-0.5f * distance * distance));
        }
        for (float& weight : out) weight /= sum;
        return first;
    }
};

/// Blurs the rows of an image and turns it: twice applied, both axes are blurred and the picture stands upright again.
Image blurred_rows_turned(const Image& image, const Resampling& kernel, int length) {
    Image turned(image.height, length, image.channels);
    for_each_index(length, [&](int i) {
        std::vector<float> weights;
        const int first = kernel.weights(i, weights);
        const int begin = std::max(first, 0), end = std::min(first + static_cast<int>(weights.size()), image.width);
        for (int y = 0; y < image.height; ++y)
            for (int x = begin; x < end; ++x)
                for (int c = 0; c < image.channels; ++c)
                    turned.at(y, i)[c] += weights[static_cast<size_t>(x - first)] * image.at(x, y)[c];
    });
    return turned;
}

/// Spectral norm of the second derivatives of the mean of RGB at a texel; what lies outside is black.
float curvature(const Image& rgba, int x, int y) {
    const auto value = [&](int dx, int dy) {
        const int column = x + dx, row = y + dy;
        if (column < 0 || row < 0 || column >= rgba.width || row >= rgba.height) return 0.0f;
        const float* c = rgba.at(column, row);
        return (c[0] + c[1] + c[2]) / 3;
    };
    const float xx = value(-1, 0) - 2 * value(0, 0) + value(1, 0), yy = value(0, -1) - 2 * value(0, 0) + value(0, 1);
    const float xy = 0.25f * (value(1, 1) - value(-1, 1) - value(1, -1) + value(-1, -1));
    return 0.5f * std::fabs(xx + yy) + std::sqrt(0.25f * (xx - yy) * (xx - yy) + xy * xy);
}

/// The largest value within `reach` texels along rows, the image turned.
Image largest_along_rows_turned(const Image& image, int reach) {
    Image turned(image.height, image.width, 1);
    for_each_index(image.height, [&](int y) {
        const float* row = image.at(0, y);
        for (int x = 0; x < image.width; ++x)
            *turned.at(y, x) = *std::max_element(row + std::max(x - reach, 0), row + std::min(x + reach + 1, image.width));
    });
    return turned;
}

Image bend_of(const PlanarStack::Level& level) {
    Image bend(level.rgba.width, level.rgba.height, 1);
    const float per_texel = 1 / static_cast<float>(level.scale * level.scale);
    for_each_index(bend.height, [&](int y) {
        for (int x = 0; x < bend.width; ++x) *bend.at(x, y) = curvature(level.rgba, x, y) * per_texel;
    });
    const int reach = static_cast<int>(std::ceil(PlanarStack::kPlanarReach * level.sigma / static_cast<float>(level.scale)));
    return largest_along_rows_turned(largest_along_rows_turned(bend, reach), reach);
}

/// The next level: `sigma` wide, from a narrower one.
PlanarStack::Level blurred(const PlanarStack::Level& from, float sigma, int width, int height) {
    PlanarStack::Level level;
    level.sigma = sigma;
    while (static_cast<float>(2 * level.scale) <= kTexelPerSigma * sigma) level.scale *= 2;
    level.margin = margin_of(sigma, level.scale);
    const Resampling kernel{from.margin, from.scale, level.margin, level.scale, std::sqrt(content(level) - content(from))};
    const auto length = [&](int texels) { return (texels + level.scale - 1) / level.scale + 2 * level.margin; };
    level.rgba = blurred_rows_turned(blurred_rows_turned(from.rgba, kernel, length(width)), kernel, length(height));
    return level;
}

}  // namespace

PlanarStack::PlanarStack(const Image& rgba) : m_width(rgba.width), m_height(rgba.height) {
    if (rgba.empty() || rgba.channels != 4)
        throw Error(ErrorCode::bad_argument, "picture of light: expected RGBA pixels, found " + std::to_string(rgba.width) +
                                                 " x " + std::to_string(rgba.height) + " x " + std::to_string(rgba.channels));
    constexpr float kDoubled = 2.0f, kWidest = 1.0f;  // widths double so far; the last one over the picture's longer side
    m_levels.push_back({with_edge(rgba), {}, std::sqrt(kTexelArea + kTent), 1, 1});
    const float widest = kWidest * static_cast<float>(std::max(m_width, m_height));
    for (float sigma = 1; m_levels.back().sigma < widest; sigma *= sigma < kDoubled ? 2.0f : std::numbers::sqrt2_v<float>)
        m_levels.push_back(blurred(m_levels.back(), sigma, m_width, m_height));
    for (Level& level : m_levels) level.bend = bend_of(level);
}

PlanarStack::Value PlanarStack::lookup(const Vec2f& place, float width) const {
    const float sigma = width > 0 ? width : 0;
    float rgba[4] = {}, bend = 0;
    const auto add = [&](const Level& level, float share) {
        const float scale = 1 / static_cast<float>(level.scale), margin = static_cast<float>(level.margin);
        const Corners corners(level.rgba, place.x * scale + margin, place.y * scale + margin, share);
        if (corners.is_inside) corners.add<4>(level.rgba, rgba), corners.add<1>(level.bend, &bend);
    };
    const auto wider = std::find_if(m_levels.begin() + 1, m_levels.end() - 1, [&](const Level& l) { return l.sigma >= sigma; });
    const Level &fine = *(wider - 1), &coarse = *wider;
    const float low = fine.sigma * fine.sigma, high = coarse.sigma * coarse.sigma;
    const float blend = std::clamp((sigma * sigma - low) / (high - low), 0.0f, 1.0f);
    add(fine, 1 - blend), add(coarse, blend);
    const float beyond =
        sigma > coarse.sigma ? high / (sigma * sigma) : 1.0f;  // the picture's share of a Gaussian wider than it
    return {Color3f(rgba[0], rgba[1], rgba[2]) * beyond, rgba[3] * beyond, bend * beyond};
}

}  // namespace burnish
