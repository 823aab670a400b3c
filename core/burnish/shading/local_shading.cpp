#include <burnish/shading/local_shading.h>

#include <burnish/material/lobe.h>
#include <burnish/shading/area_shading.h>
#include <burnish/shading/disc_light.h>
#include <burnish/shading/reference.h>

#include <algorithm>

namespace burnish {
namespace {

const Matrix33f kWorld;  // lights of a chain know their own axes

/// The taps of some pixels as rays, one after the other.
struct TapRays {
    std::vector<LightRay> rays;
    std::vector<Color3f> weights;
    std::vector<uint32_t> ends;  // of each pixel's rays
    std::vector<Tap> taps = {};

    void add(const LobeTaps& lobe, const SurfaceBatch& batch, size_t i) {
        const float side = lobe.lobe().side == Side::transmission ? -1.0f : 1.0f;
        const ShadingPoint point = shading_point(batch, i, lobe.lobe(), kWorld);
        lobe.at(point, taps);
        for (const Tap& tap : taps) {
            const Vec3f wi = tap.wi.normalized();
            const Color3f weight = tap.weight * point.scale * visible_share(wi.z * side, point.ng.dot(wi) * side, tap.edge);
            if (weight == Color3f(0, 0, 0)) continue;
            rays.push_back({batch.p[i], batch.geometric_normal()[i], point.frame.to_world(wi), std::exp(tap.level), side});
            weights.push_back(weight);
        }
        ends.push_back(static_cast<uint32_t>(rays.size()));
    }

    /// kept: as of direct_light.
    bool is_looked_up(size_t ray, std::span<const float> kept) const {
        for (size_t i = ray; i < kept.size(); i += rays.size())
            if (kept[i] > 0) return true;
        return kept.empty();
    }
};

/// All light at one point, for reference_estimate.
struct LocalArrival {
    const LightChain& lights;
    Vec3f p, ng;

    ExactLight exact(const Vec3f& d) const { return lights.exact({p, ng, d, 0}); }
    LightDraw sample(const Vec2f& u) const { return lights.sample(p, u); }
};

}  // namespace

MaterialTaps::MaterialTaps(const Material& material, const EstimatorSettings& estimator)
    : lobes(material.lobes), settings(estimator) {
    if (settings.kind == EstimatorKind::reference) return;
    for (const LobeParameters& lobe : lobes) taps.emplace_back(lobe, settings);
}

void add_local_lobe(const LobeTaps& taps, const LightChain& lights, const SurfaceBatch& batch, const LocalSums& out) {
    TapRays asked;
    for (size_t i = 0; i < batch.size(); ++i) asked.add(taps, batch, i);
    std::vector<Incident> found(asked.rays.size());
    std::vector<float> kept;
    const std::vector<DirectLight> direct =
        direct_light(taps.lobe(), lights, batch, {asked.rays, asked.weights, asked.ends}, kept);
    lights.lookup(asked.rays, found, kept);
    for (size_t i = 0, k = 0; i < batch.size(); ++i) {
        const float before = luminance(out.overlay[i]);
        float bend = 0, nearness = 0, total = 0;
        for (; k < asked.ends[i]; ++k) {
            const Color3f light = asked.weights[k] * found[k].radiance;
            out.samples[i] += asked.is_looked_up(k, kept) ? 1.0f : 0.0f;
            const float shown = std::fabs(luminance(light));
            out.overlay[i] += light;
            bend += std::fabs(luminance(asked.weights[k])) * found[k].bend;
            nearness += shown * found[k].nearness, total += shown;
        }
        if (!direct.empty()) {
            out.overlay[i] += direct[i].radiance, out.samples[i] += direct[i].nodes;
            bend += direct[i].bend, nearness += direct[i].nearness, total += std::fabs(luminance(direct[i].radiance));
        }
        const float own = luminance(out.overlay[i]) - before, all = std::max(before + own, 1e-20f);
        if (!out.bend.empty()) out.bend[i] += bend;
        if (!out.nearness.empty())
            out.nearness[i] += (nearness / std::max(total, 1e-20f) - out.nearness[i]) * std::clamp(own / all, 0.0f, 1.0f);
    }
}

void add_local_reference(const LobeParameters& parameters, uint32_t index, const EstimatorSettings& settings,
                         const LightChain& lights, const SurfaceBatch& batch, const LocalSums& out) {
    visit_lobe(parameters, [&](const auto& prototype) {
        for (size_t i = 0; i < batch.size(); ++i) {
            const ShadingPoint point = shading_point(batch, i, parameters, kWorld);
            const LocalArrival light{lights, batch.p[i], batch.geometric_normal()[i]};
            const uint32_t seed = hash_bits((batch.pixel[i] + batch.band_start) ^ index * 0xc2b2ae35u);
            const ReferenceEstimate estimate =
                reference_estimate(prototype.with_widths(point.mx, point.my), light, settings, point, seed);
            out.overlay[i] += estimate.mean * point.scale;
            out.standard_error[i] = std::hypot(out.standard_error[i], estimate.standard_error * luminance(point.scale));
            out.samples[i] += static_cast<float>(estimate.lookups);
        }
    });
}

void add_local_discs(const LobeParameters& parameters, const LightChain& lights, const SurfaceBatch& batch,
                     const LocalSums& out) {
    for (size_t link = 0; link < lights.links().size(); ++link) {
        const auto* light = std::get_if<EnvironmentLight>(lights.links()[link].light.get());
        if (!light || light->environment().discs().empty()) continue;
        const Environment& sky = light->environment();
        const Matrix33f to_world = sky.world_to_light().transposed();
        visit_lobe(parameters, [&](const auto& prototype) {
            for (size_t i = 0; i < batch.size(); ++i) {
                const ShadingPoint point = shading_point(batch, i, parameters, sky.world_to_light());
                const auto lobe = prototype.with_widths(point.mx, point.my);
                for (const BrightDisc& disc : sky.discs()) {
                    const Color3f shown = disc_light(lobe, {&disc, 1}, point) * point.scale * sky.gain();
                    if (shown == Color3f(0, 0, 0)) continue;
                    const LightRay ray{batch.p[i], batch.geometric_normal()[i], disc.direction * to_world, disc.radius()};
                    out.overlay[i] += shown * lights.left_for(link, ray);
                }
            }
        });
    }
}

}  // namespace burnish
