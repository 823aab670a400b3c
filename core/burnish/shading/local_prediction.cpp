#include <burnish/shading/local_prediction.h>

#include <burnish/light/light_mean.h>
#include <burnish/material/lobe.h>
#include <burnish/shading/disc_bend.h>
#include <burnish/shading/fitted.h>
#include <burnish/shading/local_shading.h>

#include <algorithm>

namespace burnish {
namespace {

std::optional<LobeTaps> taps_of(const LobeParameters& lobe, const DensitySettings& settings) {
    EstimatorSettings estimator;
    estimator.samples = settings.directions > 0 ? settings.directions : kPredictionTaps;
    if (!TapTable::covers(lobe, estimator.samples)) return {};
    return LobeTaps(lobe, estimator, false);
}

/// One ray a pixel along the mirrored view, as wide as the lobe's image is across.
void add_by_mirrored_view(const MaterialProbes::Lobe& probes, const LightChain& lights, const SurfaceBatch& batch,
                          const LocalSums& out) {
    const float side = probes.lobe.side == Side::transmission ? -1.0f : 1.0f;
    std::vector<LightRay> rays;
    for (size_t i = 0; i < batch.size(); ++i) {
        const ShadingPoint point = shading_point(batch, i, probes.lobe, Matrix33f());
        const Vec3f d = point.frame.to_world({-point.wo.x, -point.wo.y, point.wo.z * side});
        rays.push_back({batch.p[i], batch.geometric_normal()[i], d, image_width({point.mx, point.my}, point.wo.z)});
    }
    std::vector<Incident> found(rays.size());
    lights.lookup(rays, found);
    for (size_t i = 0; i < batch.size(); ++i) {
        const Color3f scale = shading_point(batch, i, probes.lobe, Matrix33f()).scale * probes.albedo.typical();
        const Color3f light = scale * found[i].radiance;
        const float bend = luminance(scale) * found[i].bend;
        out.overlay[i] += light, out.bend[i] += bend;
        out.nearness[i] += found[i].nearness * nearness_weight(luminance(light), bend);
    }
}

}  // namespace

MaterialProbes::MaterialProbes(const Material& material, const DensitySettings& settings) : safety(settings.safety) {
    for (const LobeParameters& lobe : material.lobes) lobes.push_back({lobe, taps_of(lobe, settings), AlbedoCurve(lobe)});
}

LocalPrediction::LocalPrediction(std::shared_ptr<const MaterialProbes> probes, LightChain lights)
    : m_probes(std::move(probes)), m_lights(std::move(lights)) {
    float albedo = 0;
    for (const MaterialProbes::Lobe& lobe : m_probes->lobes) albedo += lobe.albedo.typical();
    m_exposure = kDisplayMean / std::max(albedo * mean_luminance(m_lights), 1e-20f);
}

void LocalPrediction::predict(const SurfaceBatch& batch, std::span<AngularPrediction> out) const {
    BendSums sums(batch.size());
    std::vector<float> nearness(batch.size(), 0.0f), samples(batch.size());
    const LocalSums local{sums.overlay, samples, {}, sums.bend, nearness};
    std::fill(out.begin(), out.end(), AngularPrediction{0, 2 * kPi, 0, 0, 0});
    for (const MaterialProbes::Lobe& probes : m_probes->lobes) {
        sums.add_lobe(batch, probes.albedo, [&] {
            if (probes.taps)
                add_local_lobe(*probes.taps, m_lights, batch, local);
            else
                add_by_mirrored_view(probes, m_lights, batch, local);
        });
        limit_reach(probes.lobe, batch, out);
    }
    for (size_t i = 0; i < batch.size(); ++i)
        out[i].nearness = nearness[i] / std::max(nearness_weight(luminance(sums.overlay[i]), sums.bend[i]), 1e-20f);
    for (const MaterialProbes::Lobe& probes : m_probes->lobes) add_discs(probes, batch, sums.bend);
    sums.set_frequencies(m_exposure, m_probes->safety, out);
}

void LocalPrediction::add_discs(const MaterialProbes::Lobe& probes, const SurfaceBatch& batch, std::span<float> bend) const {
    for (size_t link = 0; link < m_lights.links().size(); ++link) {
        const auto* light = std::get_if<EnvironmentLight>(m_lights.links()[link].light.get());
        if (!light || light->environment().discs().empty()) continue;
        const Environment& sky = light->environment();
        const Matrix33f to_world = sky.world_to_light().transposed();
        visit_lobe(probes.lobe, [&](const auto& prototype) {
            for (size_t i = 0; i < batch.size(); ++i) {
                const ShadingPoint point = shading_point(batch, i, probes.lobe, sky.world_to_light());
                const auto lobe = prototype.with_widths(point.mx, point.my);
                for (const BrightDisc& disc : sky.discs()) {
                    const LightRay ray{batch.p[i], batch.geometric_normal()[i], disc.direction * to_world, disc.radius()};
                    const float flux = luminance(disc.flux * point.scale * sky.gain()) * m_lights.left_for(link, ray);
                    if (flux > 0) bend[i] += disc_bend(lobe, probes.albedo.typical(), point, disc, flux);
                }
            }
        });
    }
}

}  // namespace burnish
