// Light of the environment's bright discs through a lobe: flux times the mean of f cos over the disc.
//
// Where the disc is small against the lobe, f cos at its centre is that mean. Where it is not, the mean is taken over taps on
// circles with the disc's own second moment, and a lobe narrower than the taps' spacing is widened to it: a mirror shows a
// disc, not dots. How large a disc is for a lobe is measured in slopes of the half vector, where the lobe's widths mx, my live.
// A disc that a horizon cuts counts with the part above it.
#pragma once

#include <burnish/light/bright_discs.h>
#include <burnish/light/environment.h>
#include <burnish/material/lobe.h>
#include <burnish/shading/half_slopes.h>
#include <burnish/shading/shading_point.h>

#include <algorithm>
#include <array>
#include <span>

namespace burnish {

/// A disc's places in units of its radius: `circles` circles of 6, 12, 18 ... around the centre, spaced so that the mean square
/// distance is a disc's, 1 / 2.
template <int circles>
std::array<Vec2f, 1 + 3 * circles*(circles + 1)> disc_taps() {
    std::array<Vec2f, 1 + 3 * circles*(circles + 1)> taps;
    float sum = 0;
    for (int i = 1; i <= circles; ++i) sum += static_cast<float>(6 * i * i * i);
    const float spacing = std::sqrt(0.5f * static_cast<float>(taps.size()) / sum);
    size_t at = 0;
    taps[at++] = Vec2f(0, 0);
    for (int i = 1; i <= circles; ++i)
        for (int k = 0; k < 6 * i; ++k) {
            const float r = spacing * static_cast<float>(i), phi = 2 * kPi * static_cast<float>(k) / static_cast<float>(6 * i);
            taps[at++] = Vec2f(r * std::cos(phi), r * std::sin(phi));
        }
    return taps;
}
inline const auto kFewDiscTaps = disc_taps<1>();
inline const auto kManyDiscTaps = disc_taps<3>();

/// The part of a disc above a straight horizon, and how far above its centre that part's centroid lies; x = height of the
/// centre above the horizon over the radius.
struct DiscAbove {
    float share, lift;

    explicit DiscAbove(float x) : share(x > 0 ? 1.0f : 0.0f), lift(0) {
        if (std::fabs(x) >= 1) return;
        const float half_chord = std::sqrt(1 - x * x);
        share = 0.5f + (x * half_chord + std::asin(x)) / kPi;
        lift = 2 * half_chord * half_chord * half_chord / (3 * kPi * std::max(share, 1e-6f));
    }
};

inline constexpr float kNothing = 1e-13f;         // a lobe's border with nothing beyond, even of a sun
inline constexpr float kPointReach = 0.1f;        // disc radius over lobe width: up to here the centre's value is the mean
inline constexpr float kFewTapsReach = 0.5f;      // and up to here seven taps' mean is
inline constexpr float kPointDistance = 16.0f;    // distance from the peak over disc radius, from where the centre will do
inline constexpr float kWidthAtManyTaps = 0.19f;  // of the disc's radius: as narrow as 37 taps can resolve

/// A disc in a point's local frame, its axes scaled.
struct LocalDisc {
    Vec3f wi, along, across;

    LocalDisc(const BrightDisc& disc, const Vec3f& local_wi, const Frame& frame)
        : wi(local_wi), along(frame.to_local(disc.along)), across(frame.to_local(disc.across)) {}

    /// Height of the disc's rim over its centre, seen along unit vector n.
    float extent(const Vec3f& n) const {
        const float a = along.dot(n), b = across.dot(n);
        return std::max(std::sqrt(a * a + b * b), 1e-7f);
    }
    /// A part of it, `scale` as large, about place (x, y) of the unit disc.
    LocalDisc part(const Vec2f& place, float scale) const {
        LocalDisc other = *this;
        const Vec3f d = wi + along * place.x + across * place.y;
        other.wi = d / std::sqrt(d.length2()), other.along *= scale, other.across *= scale;
        return other;
    }
};

/// f cos at the centre for the part of a disc above the horizons; smooth where it sets.
template <class LobeType>
Color3f disc_value(const LobeType& lobe, const ShadingPoint& point, const LocalDisc& disc) {
    const float cos_i = disc.wi.z * lobe.side_sign, extent = disc.extent({0, 0, 1}), x = cos_i / extent,
                ng_x = point.ng.dot(disc.wi) * lobe.side_sign / disc.extent(point.ng);
    if (x <= -1 || ng_x <= -1) return Color3f(0, 0, 0);
    if (x >= 1 && ng_x >= 1) return lobe.eval(point.wo, disc.wi) * cos_i;
    const DiscAbove above(x), above_ng(ng_x);
    const float cosine = std::min(cos_i + above.lift * extent, 1.0f);
    const Vec3f seen(disc.wi.x, disc.wi.y, cosine * lobe.side_sign);
    return lobe.eval(point.wo, seen / std::sqrt(seen.length2())) * (cosine * std::min(above.share, above_ng.share));
}

template <class LobeType>
Color3f mean_of_taps(const LobeType& lobe, const ShadingPoint& point, const LocalDisc& disc, std::span<const Vec2f> taps) {
    const float count = static_cast<float>(taps.size()), scale = 1 / std::sqrt(count);
    Color3f sum(0, 0, 0);
    for (const Vec2f& tap : taps) sum += disc_value(lobe, point, disc.part(tap, scale));
    return sum / count;
}

/// Mean over a disc that is not small against the lobe.
template <class LobeType>
Color3f disc_mean(const LobeType& lobe, const ShadingPoint& point, const LocalDisc& disc) {
    const Vec2f centre = half_slopes(point.wo, lobe.mirrored(disc.wi));
    const Vec2f along = half_slopes(point.wo, lobe.mirrored(disc.wi + disc.along)) - centre,
                across = half_slopes(point.wo, lobe.mirrored(disc.wi + disc.across)) - centre;
    const Vec2f reach(std::sqrt(along.x * along.x + across.x * across.x), std::sqrt(along.y * along.y + across.y * across.y));
    const float widths = std::max(reach.x / point.mx, reach.y / point.my);
    if (widths < kPointReach) return disc_value(lobe, point, disc);
    if (widths < kFewTapsReach) return mean_of_taps(lobe, point, disc, kFewDiscTaps);
    const float mx = std::max(point.mx, kWidthAtManyTaps * reach.x), my = std::max(point.my, kWidthAtManyTaps * reach.y);
    return mean_of_taps(lobe.with_widths(mx, my), point, disc, kManyDiscTaps);
}

/// Whether nothing of a lobe lies beyond the border of its slopes: so are the ones about half vectors, which kernels are compiled for.
template <class LobeType>
inline constexpr bool kEndsAtItsBorder = !std::is_same_v<LobeType, Lobe<AnyModel>>;

/// Reflected radiance of the discs, without point.scale; `lobe` has the point's widths.
template <class LobeType>
Color3f disc_light(const LobeType& lobe, std::span<const BrightDisc> discs, const ShadingPoint& point) {
    Color3f sum(0, 0, 0);
    for (const BrightDisc& disc : discs) {
        const Vec3f wi = point.frame.to_local(disc.direction), half = point.wo + lobe.mirrored(wi);  // half: any length
        const float radius = disc.longest_radius();
        if (wi.z * lobe.side_sign <= -radius || half.z <= 0) continue;
        // In slopes times z^2: the half vector's place, the lobe's border, and the disc's radius r |half| / z^2, |half| <= 2.
        const float z2 = half.z * half.z, x = std::fabs(half.x) * half.z, y = std::fabs(half.y) * half.z;
        const float border = lobe.border(kNothing) * z2, reach = 2 * radius;
        const bool is_beyond = x > border * point.mx + reach || y > border * point.my + reach;
        if (kEndsAtItsBorder<LobeType> && is_beyond) continue;
        const bool small = reach < kPointReach * z2 * std::min(point.mx, point.my) || std::max(x, y) > kPointDistance * reach;
        const float cos_i = wi.z * lobe.side_sign;
        if (small && cos_i > radius && point.ng.dot(wi) * lobe.side_sign > radius) {
            sum += disc.flux * lobe.eval(point.wo, wi) * cos_i;
            continue;
        }
        const LocalDisc local(disc, wi, point.frame);
        sum += disc.flux * (small ? disc_value(lobe, point, local) : disc_mean(lobe, point, local));
    }
    return sum;
}

/// Adds the light of an environment's discs, which filtered lookups do not hold; its gain and the points' scale included.
template <class LobeType>
void add_disc_light(const LobeType& prototype, const LobeParameters& lobe, const Environment& light, const SurfaceBatch& batch,
                    std::span<Color3f> overlay) {
    if (light.discs().empty()) return;
    for (size_t i = 0; i < batch.size(); ++i) {
        const ShadingPoint point = shading_point(batch, i, lobe, light.world_to_light());
        const Color3f discs = disc_light(prototype.with_widths(point.mx, point.my), light.discs(), point);
        overlay[i] += discs * point.scale * light.gain();
    }
}

}  // namespace burnish
