#include <burnish/shading/curvature_prediction.h>

#include <burnish/light/gaussian_stack.h>
#include <burnish/light/light_curvature.h>
#include <burnish/material/albedo.h>
#include <burnish/material/lobe.h>
#include <burnish/shading/fitted.h>
#include <burnish/shading/lobe_image.h>
#include <burnish/shading/table_shading.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kDirections = 4;        // taps a lobe, by measurement
constexpr int kViewAngles = 33;       // of the albedo's curve
constexpr int kAlbedoSamples = 1024;  // a point of the curve
constexpr float kMean = 0.18f;        // of a picture as a display shows it
constexpr float kDarkest = 0.0015f;   // of which a display shows no more detail than linearly
constexpr float kSteepest = 0.05f;    // cosine of the view below which a lobe's image gets no narrower
constexpr float kLowest = 0.01f;      // height of a half vector, before it is made a unit one

/// Mean luminance of the light over all directions, its suns apart.
float mean_luminance(const GaussianStack& stack) {
    const CubeLevel& widest = stack.stack()[stack.stack().level_count() - 1];
    double sum = 0;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < widest.size(); ++y)
            for (int x = 0; x < widest.size(); ++x) {
                const float* rgb = widest.at(face, x, y);
                sum += luminance({rgb[0], rgb[1], rgb[2]});
            }
    return static_cast<float>(sum / (6.0 * widest.size() * widest.size()));
}

/// Width of the shorter axis of the lobe's image, radian.
float image_width(const Vec2f& widths, float cos_o) {
    return std::sqrt(2.0f) * std::min(widths.x, widths.y) * std::max(cos_o, kSteepest);
}

/// The angle between the mirrored view and d that counts as much for the lobe as along its narrow axis: by half vectors, whose
/// slopes the widths are of.
float narrow_angle(const ShadingPoint& point, const Vec3f& d, float side_sign) {
    const Vec3f wi = point.frame.to_local(d), sum(point.wo.x + wi.x, point.wo.y + wi.y, point.wo.z + wi.z * side_sign);
    const float slope = std::hypot(sum.x / point.mx, sum.y / point.my) / std::max(sum.z, kLowest);
    return 2 * std::atan(slope * std::min(point.mx, point.my));
}

}  // namespace

CurvaturePrediction::LobeProbes::LobeProbes(const LobeParameters& parameters, const Environment& light, int directions)
    : lobe(parameters), relative_curvature(kViewAngles, 0.0f) {
    if (TapTable::covers(lobe, directions)) table = fitted_table(lobe, directions, light.gaussian_stack());
    const float step = 0.5f * kPi / (kViewAngles - 1);
    std::vector<float> albedo;
    for (int i = 0; i < kViewAngles; ++i) {
        const float theta = std::min(step * static_cast<float>(i), 1.553f);
        albedo.push_back(luminance(directional_albedo(lobe, {std::sin(theta), 0, std::cos(theta)}, kAlbedoSamples)));
    }
    typical_albedo = albedo[kViewAngles / 2];
    for (size_t i = 1; i + 1 < kViewAngles; ++i)
        relative_curvature[i] = std::fabs(albedo[i - 1] - 2 * albedo[i] + albedo[i + 1]) /
                                (step * step * std::max(albedo[i], 1e-6f * typical_albedo + 1e-12f));
    relative_curvature.front() = relative_curvature[1], relative_curvature.back() = relative_curvature[kViewAngles - 2];
}

float CurvaturePrediction::LobeProbes::albedo_curvature(float cos_o) const {
    const float place = std::acos(std::clamp(cos_o, 0.0f, 1.0f)) / (0.5f * kPi) * (kViewAngles - 1);
    const auto low = std::min(static_cast<size_t>(place), static_cast<size_t>(kViewAngles - 2));
    return std::max(relative_curvature[low], relative_curvature[low + 1]);
}

CurvaturePrediction::CurvaturePrediction(const Material& material, const Environment& light, const DensitySettings& settings)
    : m_light(light), m_safety(settings.safety) {
    const int directions = settings.directions > 0 ? settings.directions : kDirections;
    float albedo = 0;
    for (const LobeParameters& lobe : material.lobes) {
        m_lobes.emplace_back(lobe, light, directions);
        albedo += m_lobes.back().typical_albedo;
    }
    m_exposure = kMean / std::max(albedo * luminance(light.gain()) * mean_luminance(light.gaussian_stack()), 1e-20f);
}

void CurvaturePrediction::predict(const SurfaceBatch& batch, std::span<AngularPrediction> out) const {
    std::vector<Color3f> overlay(batch.size(), Color3f(0, 0, 0));
    std::vector<float> bend(batch.size(), 0.0f), view_bend(batch.size(), 0.0f), before(batch.size());
    std::fill(out.begin(), out.end(), AngularPrediction{0, 2 * kPi, 0});
    for (const LobeProbes& probes : m_lobes) {
        for (size_t i = 0; i < batch.size(); ++i) before[i] = luminance(overlay[i]);
        add_light(probes, batch, overlay, bend);
        for (size_t i = 0; i < batch.size(); ++i) {
            const float cos_o = batch.n[i].dot(batch.wo[i]);
            view_bend[i] += 0.25f * (luminance(overlay[i]) - before[i]) * probes.albedo_curvature(cos_o);
        }
        add_suns(probes, batch, bend);
        set_reach(probes, batch, out);
    }
    for (size_t i = 0; i < batch.size(); ++i) {
        const float root = std::sqrt(bend[i]) + std::sqrt(std::max(view_bend[i], 0.0f));
        const float shown = std::max(luminance(overlay[i]) * m_exposure, kDarkest);
        out[i].nu_a = m_safety * root * std::sqrt(m_exposure / std::sqrt(shown)) / (2 * kPi);
    }
}

void CurvaturePrediction::add_light(const LobeProbes& probes, const SurfaceBatch& batch, std::span<Color3f> overlay,
                                    std::span<float> bend) const {
    const GaussianStack& stack = m_light.gaussian_stack();
    if (probes.table.tap_count() > 0) {
        std::vector<float> lookups(batch.size());
        return add_table_shading({probes.lobe, probes.table, stack.stack(), 0, m_light.world_to_light(), m_light.gain()}, batch,
                                 {overlay, lookups, bend});
    }
    const float side = probes.lobe.side == Side::transmission ? -1.0f : 1.0f;
    for (size_t i = 0; i < batch.size(); ++i) {
        const ShadingPoint point = shading_point(batch, i, probes.lobe, m_light.world_to_light());
        const Vec3f wi = point.frame.to_world({-point.wo.x, -point.wo.y, point.wo.z * side});
        const float level = stack.level(image_width({point.mx, point.my}, point.wo.z));
        const std::array<float, 4> light = stack.stack().lookup_rgba(wi, level);
        const Color3f scale = point.scale * m_light.gain() * probes.typical_albedo;
        overlay[i] += scale * Color3f(light[0], light[1], light[2]);
        bend[i] += luminance(scale) * light[3];
    }
}

/// A sun is seen as the lobe's own peak: D about the sun's direction. The sharpest bend within reach of the pixel's direction.
void CurvaturePrediction::add_suns(const LobeProbes& probes, const SurfaceBatch& batch, std::span<float> bend) const {
    if (m_light.discs().empty()) return;
    visit_lobe(probes.lobe, [&](const auto& prototype) {
        for (size_t i = 0; i < batch.size(); ++i) {
            const ShadingPoint point = shading_point(batch, i, probes.lobe, m_light.world_to_light());
            const auto lobe = prototype.with_widths(point.mx, point.my);
            const float width = image_width({point.mx, point.my}, point.wo.z);
            const float reach = kCurvatureReach * std::sqrt(2.0f) * std::min(point.mx, point.my);
            for (const BrightDisc& disc : m_light.discs()) {
                const float spread = std::hypot(width, disc.radius()), step = 0.25f * spread;
                const float angle = narrow_angle(point, disc.direction, prototype.side_sign);
                const float nearest = std::max(angle - reach, 0.0f) * width / spread;
                const auto density = [&](float theta) {
                    const float sine = std::sin(0.5f * std::fabs(theta)), cosine = std::cos(0.5f * theta);
                    return lobe.D(point.mx < point.my ? Vec3f(sine, 0, cosine) : Vec3f(0, sine, cosine));
                };
                const float here = density(nearest), below = density(nearest - step), above = density(nearest + step);
                const float along = std::fabs(below - 2 * here + above) / (step * step);
                const float across = std::fabs(above - below) / (2 * step * std::max(nearest, step));
                const float shrink = width * width / (spread * spread);  // a disc blurs the peak that it makes
                bend[i] += luminance(disc.flux * point.scale * m_light.gain()) * std::max(along, across) * shrink *
                           probes.typical_albedo / (4 * std::max(point.wo.z, kSteepest));
            }
        }
    });
}

void CurvaturePrediction::set_reach(const LobeProbes& probes, const SurfaceBatch& batch,
                                    std::span<AngularPrediction> out) const {
    for (size_t i = 0; i < batch.size(); ++i) {
        const Vec2f widths = lobe_widths(batch, i, probes.lobe);
        const float width = std::sqrt(2.0f) * std::min(widths.x, widths.y);
        out[i].reach = std::min(out[i].reach, kCurvatureReach * width);
        if (widths.x != widths.y) out[i].length = std::max(out[i].length, std::sqrt(2.0f) * std::max(widths.x, widths.y));
    }
}

}  // namespace burnish
