#include <burnish/shading/curvature_prediction.h>

#include <burnish/light/filter/gaussian_stack.h>
#include <burnish/light/light_mean.h>
#include <burnish/material/lobe.h>
#include <burnish/shading/disc_bend.h>
#include <burnish/shading/fitted.h>
#include <burnish/shading/table_shading.h>

#include <algorithm>

namespace burnish {

CurvaturePrediction::LobeProbes::LobeProbes(const LobeParameters& parameters, const Environment& light, int directions)
    : lobe(parameters), albedo(parameters) {
    if (TapTable::covers(lobe, directions)) table = fitted_table(lobe, directions, light.gaussian_stack());
    const bool is_tabulated = table.tap_count() > 0;
    stack = is_tabulated ? light.gaussian_stack().stack(table.level_ranges()) : light.gaussian_stack().stack();
}

CurvaturePrediction::CurvaturePrediction(const Material& material, const Environment& light, const DensitySettings& settings)
    : m_light(light), m_safety(settings.safety) {
    const int directions = settings.directions > 0 ? settings.directions : kPredictionTaps;
    float albedo = 0;
    for (const LobeParameters& lobe : material.lobes) {
        m_lobes.emplace_back(lobe, light, directions);
        albedo += m_lobes.back().albedo.typical();
    }
    m_exposure = kDisplayMean / std::max(albedo * luminance(light.gain()) * mean_luminance(light.gaussian_stack()), 1e-20f);
}

void CurvaturePrediction::predict(const SurfaceBatch& batch, std::span<AngularPrediction> out) const {
    BendSums sums(batch.size());
    std::fill(out.begin(), out.end(), AngularPrediction{0, 2 * kPi, 0, 0, 0});
    for (const LobeProbes& probes : m_lobes) {
        sums.add_lobe(batch, probes.albedo, [&] { add_light(probes, batch, sums.overlay, sums.bend); });
        add_suns(probes, batch, sums.bend);
        limit_reach(probes.lobe, batch, out);
    }
    sums.set_frequencies(m_exposure, m_safety, out);
}

void CurvaturePrediction::add_light(const LobeProbes& probes, const SurfaceBatch& batch, std::span<Color3f> overlay,
                                    std::span<float> bend) const {
    if (probes.table.tap_count() > 0) {
        std::vector<float> lookups(batch.size());
        return add_table_shading({{probes.lobe, probes.table, m_light.world_to_light()}, probes.stack, 0, m_light.gain()},
                                 batch, {overlay, lookups, bend, {}});
    }
    const float side = probes.lobe.side == Side::transmission ? -1.0f : 1.0f;
    for (size_t i = 0; i < batch.size(); ++i) {
        const ShadingPoint point = shading_point(batch, i, probes.lobe, m_light.world_to_light());
        const Vec3f wi = point.frame.to_world({-point.wo.x, -point.wo.y, point.wo.z * side});
        const float level = m_light.gaussian_stack().level(image_width({point.mx, point.my}, point.wo.z));
        const std::array<float, 4> light = probes.stack.lookup_rgba(wi, level);
        const Color3f scale = point.scale * m_light.gain() * probes.albedo.typical();
        overlay[i] += scale * Color3f(light[0], light[1], light[2]);
        bend[i] += luminance(scale) * light[3];
    }
}

void CurvaturePrediction::add_suns(const LobeProbes& probes, const SurfaceBatch& batch, std::span<float> bend) const {
    if (m_light.discs().empty()) return;
    visit_lobe(probes.lobe, [&](const auto& prototype) {
        for (size_t i = 0; i < batch.size(); ++i) {
            const ShadingPoint point = shading_point(batch, i, probes.lobe, m_light.world_to_light());
            const auto lobe = prototype.with_widths(point.mx, point.my);
            for (const BrightDisc& disc : m_light.discs()) {
                const float flux = luminance(disc.flux * point.scale * m_light.gain());
                bend[i] += disc_bend(lobe, probes.albedo.typical(), point, disc, flux);
            }
        }
    });
}

}  // namespace burnish
