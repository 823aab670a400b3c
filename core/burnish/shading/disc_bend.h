// How sharply the light of a bright disc bends once a lobe has reflected it: a sun is seen as the lobe's own peak.
#pragma once

#include <burnish/light/bright_discs.h>
#include <burnish/light/filter/light_curvature.h>
#include <burnish/shading/shading_point.h>

#include <algorithm>
#include <cmath>

namespace burnish {

inline constexpr float kSteepest = 0.05f;  // cosine of the view below which a lobe's image gets no narrower
inline constexpr float kLowest = 0.01f;    // height of a half vector, before it is made a unit one

/// Width of the shorter axis of the lobe's image, radian.
inline float image_width(const Vec2f& widths, float cos_o) {
    return std::sqrt(2.0f) * std::min(widths.x, widths.y) * std::max(cos_o, kSteepest);
}

/// The angle between the mirrored view and d that counts as much for the lobe as along its narrow axis: by half vectors, whose
/// slopes the widths are of.
inline float narrow_angle(const ShadingPoint& point, const Vec3f& d, float side_sign) {
    const Vec3f wi = point.frame.to_local(d), sum(point.wo.x + wi.x, point.wo.y + wi.y, point.wo.z + wi.z * side_sign);
    const float slope = std::hypot(sum.x / point.mx, sum.y / point.my) / std::max(sum.z, kLowest);
    return 2 * std::atan(slope * std::min(point.mx, point.my));
}

/// Second derivative of the luminance that a disc of this flux (luminance, the lobe's scale included) makes, per radian^2 of the
/// reflected direction: D about the disc's direction, the sharpest bend within reach of the pixel's own direction. `lobe` has the
/// point's widths and lets through `albedo`.
template <class LobeType>
float disc_bend(const LobeType& lobe, float albedo, const ShadingPoint& point, const BrightDisc& disc, float flux) {
    const float width = image_width({point.mx, point.my}, point.wo.z);
    const float reach = kCurvatureReach * std::sqrt(2.0f) * std::min(point.mx, point.my);
    const float spread = std::hypot(width, disc.radius()), step = 0.25f * spread;
    const float angle = narrow_angle(point, disc.direction, lobe.side_sign);
    const float nearest = std::max(angle - reach, 0.0f) * width / spread;
    const auto density = [&](float theta) {
        const float sine = std::sin(0.5f * std::fabs(theta)), cosine = std::cos(0.5f * theta);
        return lobe.D(point.mx < point.my ? Vec3f(sine, 0, cosine) : Vec3f(0, sine, cosine));
    };
    const float here = density(nearest), below = density(nearest - step), above = density(nearest + step);
    const float along = std::fabs(below - 2 * here + above) / (step * step);
    const float across = std::fabs(above - below) / (2 * step * std::max(nearest, step));
    const float shrink = width * width / (spread * spread);  // a disc blurs the peak that it makes
    return flux * std::max(along, across) * shrink * albedo / (4 * std::max(point.wo.z, kSteepest));
}

}  // namespace burnish
