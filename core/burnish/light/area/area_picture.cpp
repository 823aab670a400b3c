#include <burnish/light/area/area_picture.h>

#include <burnish/base/parallel.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kSpacing = 1.7f;  // of round lookups along a longer axis, deviations
constexpr int kFinest = 32;       // times as many texels
constexpr float kLeast = 0.03f;   // weight of the last ones, taken off all so that none appears at once

/// RGBA with texels about as wide as high on a lamp of this aspect: finer along one axis where they are not.
Image with_cover(const AreaPicture& picture, float aspect) {
    const int width = picture.rgb().width, height = picture.rgb().height;
    const float texel_aspect = aspect * static_cast<float>(height) / static_cast<float>(width);
    const auto finer = [](float ratio) { return std::clamp(static_cast<int>(std::lround(ratio)), 1, kFinest); };
    Image rgba(width * finer(texel_aspect), height * finer(1 / texel_aspect), 4, 1.0f);
    for_each_index(rgba.height, [&](int y) {
        for (int x = 0; x < rgba.width; ++x) {
            const Color3f color = picture.at({(static_cast<float>(x) + 0.5f) / static_cast<float>(rgba.width),
                                              1 - (static_cast<float>(y) + 0.5f) / static_cast<float>(rgba.height)});
            std::copy_n(&color.x, 3, rgba.at(x, y));
        }
    });
    return rgba;
}

/// Two texels that a place of one axis lies between, clamped at the edges.
struct Between {
    int low, high;
    float part;

    Between(float x, int count) {
        const float place = std::clamp(x * static_cast<float>(count) - 0.5f, 0.0f, static_cast<float>(count - 1));
        low = std::min(static_cast<int>(place), count - 1), high = std::min(low + 1, count - 1);
        part = place - static_cast<float>(low);
    }
};

std::vector<double> weights_of(const AreaPicture& picture, int width, int height) {
    std::vector<double> weights(static_cast<size_t>(width) * height);
    const float dx = 0.25f / static_cast<float>(width), dy = 0.25f / static_cast<float>(height);
    for_each_index(height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const Vec2f centre((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                               1 - (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
            for (const Vec2f& aside : {Vec2f(-dx, -dy), Vec2f(dx, -dy), Vec2f(-dx, dy), Vec2f(dx, dy)})
                weights[static_cast<size_t>(y) * width + x] += luminance(picture.at(centre + aside));
        }
    });
    return weights;
}

/// An ellipse's axes in texels: the longer one, and both lengths.
struct Axes {
    Vec2f along;  // unit
    float longer, shorter;

    Axes(const Vec2f& a, const Vec2f& b) {
        const float xx = a.x * a.x + b.x * b.x, yy = a.y * a.y + b.y * b.y, xy = a.x * a.y + b.x * b.y;
        const float mean = 0.5f * (xx + yy), aside = std::sqrt(0.25f * (xx - yy) * (xx - yy) + xy * xy);
        longer = std::sqrt(mean + aside), shorter = std::sqrt(std::max(mean - aside, 0.0f));
        const float angle = 0.5f * std::atan2(2 * xy, xx - yy);
        along = Vec2f(std::cos(angle), std::sin(angle));
    }
};

}  // namespace

AreaPicture::AreaPicture(Image rgb, float aspect) : m_rgb(std::move(rgb)) {
    m_stack = PlanarStack(with_cover(*this, aspect));
    m_table = SampleTable(m_rgb.width, m_rgb.height, weights_of(*this, m_rgb.width, m_rgb.height));
}

Color3f AreaPicture::mean() const {
    Imath::V3d sum(0, 0, 0);
    for (size_t i = 0; i < m_rgb.pixel_count(); ++i) sum += Imath::V3d(m_rgb.at(i)[0], m_rgb.at(i)[1], m_rgb.at(i)[2]);
    return Color3f(Vec3f(sum / static_cast<double>(m_rgb.pixel_count())));
}

Color3f AreaPicture::at(const Vec2f& uv) const {
    const Between x(uv.x, m_rgb.width), y(1 - uv.y, m_rgb.height);
    Color3f color;
    for (int c = 0; c < 3; ++c) {
        const float above = m_rgb.at(x.low, y.low)[c] * (1 - x.part) + m_rgb.at(x.high, y.low)[c] * x.part,
                    below = m_rgb.at(x.low, y.high)[c] * (1 - x.part) + m_rgb.at(x.high, y.high)[c] * x.part;
        color[c] = above * (1 - y.part) + below * y.part;
    }
    return color;
}

AreaPicture::Filtered AreaPicture::filtered(const Vec2f& uv, const PictureEllipse& ellipse) const {
    const Vec2f texels(static_cast<float>(m_stack.width()), -static_cast<float>(m_stack.height()));
    const Vec2f centre(uv.x * texels.x, (uv.y - 1) * texels.y);
    const Axes axes(ellipse.a * texels, ellipse.b * texels);
    const float round = std::max(axes.shorter, axes.longer / kLongest);
    const float spread2 = std::max(axes.longer * axes.longer - round * round, 1e-12f);
    PlanarStack::Value sum;
    const auto add = [&](float aside, float weight) {
        const PlanarStack::Value value = m_stack.lookup(centre + axes.along * aside, round);
        sum.radiance += value.radiance * weight, sum.cover += value.cover * weight, sum.bend = std::max(sum.bend, value.bend);
    };
    add(0, 1 - kLeast);
    for (int i = 1;; ++i) {
        const float aside = kSpacing * round * static_cast<float>(i),
                    weight = std::exp(-0.5f * aside * aside / spread2) - kLeast;
        if (!(weight > 0)) break;
        add(aside, weight), add(-aside, weight);
    }
    const float along = m_stack.lookup(centre, axes.longer).bend * axes.longer * axes.longer;
    return {sum.radiance / std::max(sum.cover, 1e-6f), std::max(sum.bend * round * round, along)};
}

Vec2f AreaPicture::sample(const Vec2f& u) const {
    const SampleTable::Place place = m_table.sample(u);
    return {(static_cast<float>(place.column) + place.x) / static_cast<float>(m_rgb.width),
            1 - (static_cast<float>(place.row) + place.y) / static_cast<float>(m_rgb.height)};
}

float AreaPicture::pdf(const Vec2f& uv) const {
    const auto cell = [](float x, int count) {
        return std::clamp(static_cast<int>(x * static_cast<float>(count)), 0, count - 1);
    };
    const double probability = m_table.probability(cell(uv.x, m_rgb.width), cell(1 - uv.y, m_rgb.height));
    return static_cast<float>(probability * static_cast<double>(m_rgb.pixel_count()));
}

}  // namespace burnish
