#include <burnish/shading/lobe_quadrature.h>

#include <burnish/material/lobe.h>
#include <burnish/sampling/lobe_pattern.h>
#include <burnish/shading/lobe_image.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kCircles = 24, kAzimuths = 24;
constexpr float kShareBeyond = 1e-5f;             // of the lobe's slopes that the grid leaves out
constexpr float kFarthest = 4.0f;                 // slope widths: where taps of a long tail still make a difference
constexpr float kFinest = 0.4f, kGrazing = 0.1f;  // of the width of the lobe's image, which narrows as the cosine
constexpr float kLowView = 0.26f;                 // cosine: 75 degrees, beyond which the lobe lies on the horizon
constexpr float kLean = 0.5f;  // of the width: how far the facets that are seen at the horizon lean towards the eye
constexpr float kGap = 1.2f;   // deviations of a row of n Gaussians are this over n, of the lobe's longer one

struct GridPoint {
    float u, v, area;  // normalised slopes, and their area
};

/// Circles whose radii grow evenly near the centre and by equal factors in the tail: r = sinh(s), s evenly spaced.
std::vector<GridPoint> polar_grid(float border, bool half) {
    const float last = std::asinh(border), step = last / kCircles;
    const int azimuths = half ? kAzimuths / 2 : kAzimuths;
    std::vector<GridPoint> grid;
    for (int circle = 0; circle < kCircles; ++circle) {
        const float at = (static_cast<float>(circle) + 0.5f) * step, r = std::sinh(at);
        // The midpoint rule's error is that of its ends; the integrand has a slope only at the centre: step^2 / 24 of it.
        const float excess = circle == 0 ? step * step / 24 : 0.0f;
        const float area = (r * std::cosh(at) * step - excess) * 2 * kPi / static_cast<float>(azimuths);
        for (int i = 0; i < azimuths; ++i) {
            const float phi = (static_cast<float>(i) + 0.5f) * 2 * kPi / kAzimuths;
            grid.push_back({r * std::cos(phi), r * std::sin(phi), area});
        }
    }
    return grid;
}

void add(LobeQuadrature& q, const Vec3f& wi, float area, const Color3f& value) {
    q.x.push_back(wi.x), q.y.push_back(wi.y), q.z.push_back(wi.z), q.root_area.push_back(std::sqrt(area));
    for (int k = 0; k < 3; ++k) q.value[static_cast<size_t>(k)].push_back(value[k]);
}

template <class LobeType>
LobeQuadrature quadrature_of(const LobeType& lobe, float mx, float my, const Vec3f& wo, bool half) {
    LobeQuadrature q{};
    Imath::V3d albedo(0);
    for (const GridPoint& point : polar_grid(lobe.border(kShareBeyond), half)) {
        const float sx = point.u * mx, sy = point.v * my;
        const float cos_h = 1 / std::sqrt(1 + sx * sx + sy * sy);
        const Vec3f h = Vec3f(sx, sy, 1) * cos_h;
        const float wo_h = wo.dot(h);
        if (wo_h <= 0) continue;
        const Vec3f wi = reflect(wo, h);
        const float area = 4 * wo_h * point.area * mx * my * cos_h * cos_h * cos_h;
        const Color3f value = wi.z > 0 ? lobe.eval(wo, lobe.mirrored(wi)) * wi.z : Color3f(0);
        add(q, wi, area, value);
        // Facets that wo does not see would mirror it down there, where nothing is and a fit has to know.
        if (wo.z < kLowView && wi.z > wo.z) add(q, {wi.x, wi.y, -wi.z}, area, Color3f(0));
        albedo += Imath::V3d(value) * area;
    }
    q.albedo = Color3f(Vec3f(albedo));
    q.farthest = kFarthest * std::max(mx, my);
    q.finest = kFinest * std::min(mx, my) * std::max(wo.z, kGrazing);
    return q;
}

/// How narrow the lobe's peak is: the slopes that hold its first tenth, over those of a Gaussian lobe; 1 for all lobes without one.
float peak_width(const LobeParameters& lobe) {
    constexpr float kBeyond = 0.9f;
    return visit_lobe(lobe, [&](const auto& own) { return std::min(own.border(kBeyond) / gaussian_radius(kBeyond), 1.0f); });
}

/// A degree, more for wide lobes and less for peaked ones and for those that are not much wider themselves; and where a row of
/// so many Gaussians as narrow as an anisotropic lobe would leave gaps, as much as closes them: light that falls into gaps is
/// worse than a wider lobe. (Round lobes, long at grazing angles only, lose by that: there the horizon makes a wider lobe another lobe.)
float blur_for(const LobeParameters& lobe, const Vec3f& wo, int taps, float peak) {
    const LobeImage image = lobe_image(wo, lobe.mx, lobe.my);
    const float detail = (0.01f + 0.035f * image.major) * peak, gap = kGap * image.major / static_cast<float>(taps);
    const float closing = lobe.mx == lobe.my ? 0 : std::sqrt(std::max(gap * gap - image.minor * image.minor, 0.0f));
    return std::min(std::max(detail, closing), 0.35f * image.major);
}

/// wo, raised at grazing angles to the height it has over the facets that it sees, which lean towards it: from there a blur of
/// directions widens slopes as it does over the lobe. At the mirror direction itself that would be without bound.
Vec3f leaning_view(const Vec3f& wo, float m) {
    const float z = std::max(wo.z, kLean * m), sine = std::hypot(wo.x, wo.y);
    return sine > 0 ? Vec3f(wo.x / sine, wo.y / sine, 0) * std::sqrt(1 - z * z) + Vec3f(0, 0, z) : wo;
}

}  // namespace

LobeQuadrature lobe_quadrature(const LobeParameters& parameters, const Vec3f& wo, bool half, int taps) {
    const float mx = parameters.mx, my = parameters.my;
    const Vec3f leaning = leaning_view(wo, std::sqrt(mx * my));
    const float blur = blur_for(parameters, leaning, taps, peak_width(parameters));
    const Vec2f wider = widening(leaning, blur);
    return visit_lobe(parameters, [&](const auto& lobe) {
        const LobeQuadrature sharp = quadrature_of(lobe, mx, my, wo, half);
        LobeQuadrature q =
            quadrature_of(lobe.blurred(mx, my, wider), std::sqrt(mx * mx + wider.x), std::sqrt(my * my + wider.y), wo, half);
        for (int k = 0; k < 3; ++k) {
            if (!(q.albedo[k] > 0)) continue;
            for (float& value : q.value[static_cast<size_t>(k)]) value *= sharp.albedo[k] / q.albedo[k];
        }
        q.albedo = sharp.albedo, q.farthest = sharp.farthest, q.finest = sharp.finest, q.blur = blur;
        return q;
    });
}

}  // namespace burnish
