#include <burnish/shading/local_shading.h>

#include <burnish/base/error.h>
#include <burnish/material/lobe.h>
#include <burnish/shading/area_shading.h>
#include <burnish/shading/disc_light.h>
#include <burnish/shading/reference.h>
#include <burnish/shading/running_reference.h>
#include <burnish/shading/tap_rays.h>

#include <algorithm>

namespace burnish {
namespace {

const Matrix33f kWorld;  // lights of a chain know their own axes

constexpr size_t kRaysAtOnce = 512;   // so that they and what comes back stay in the cache
constexpr size_t kFewestPixels = 32;  // at once, however many taps they have

/// Of pixels that make their own taps each.
void set_own_rays(const LobeTaps& lobe, const SurfaceBatch& batch, size_t begin, size_t end, std::vector<Tap>& taps,
                  TapRays& out) {
    const float side = lobe.lobe().side == Side::transmission ? -1.0f : 1.0f;
    out.rays.clear(), out.weights.clear(), out.ends.clear();
    for (size_t i = begin; i < end; ++i) {
        const ShadingPoint point = shading_point(batch, i, lobe.lobe(), kWorld);
        lobe.at(point, taps);
        for (const Tap& tap : taps) {
            const Vec3f wi = tap.wi.normalized();
            const Color3f weight = tap.weight * visible_share(wi.z * side, point.ng.dot(wi) * side, tap.edge);
            if (weight == Color3f(0, 0, 0)) continue;
            out.rays.push_back({batch.p[i], batch.geometric_normal()[i], point.frame.to_world(wi), std::exp(tap.level), side});
            out.weights.push_back({{weight.x, weight.y, weight.z, luminance(weight)}});
        }
        out.ends.push_back(static_cast<uint32_t>(out.rays.size()));
    }
}

/// What rays [first, end) bring to pixel i.
void add_pixel(const TapRays& asked, std::span<const Incident> found, size_t first, size_t end, const Color3f& scale, size_t i,
               const LocalSums& out) {
    Color3f sum(0, 0, 0);
    float bends = 0, nearness = 0;
    for (size_t k = first; k < end; ++k) {
        const float* weight = asked.weights[k].rgba;
        const Color3f light = Color3f(weight[0], weight[1], weight[2]) * found[k].radiance;
        sum += light;
        const float bend = std::fabs(weight[3]) * found[k].bend;
        bends += bend, nearness += found[k].nearness * nearness_weight(luminance(light), bend);
    }
    out.overlay[i] += reflected(sum) * scale;
    if (out.bend.empty()) return;
    out.bend[i] += bends * luminance(scale), out.nearness[i] += nearness * luminance(scale);
}

/// How many of rays [first, end) were looked up at all. kept: as of direct_light.
size_t looked_up(std::span<const float> kept, size_t rays, size_t first, size_t end) {
    if (kept.empty()) return end - first;
    size_t count = 0;
    for (size_t k = first; k < end; ++k) {
        bool is_kept = false;
        for (size_t i = k; i < kept.size(); i += rays) is_kept = is_kept || kept[i] > 0;
        count += is_kept;
    }
    return count;
}

void add_direct(const DirectLight& direct, size_t i, const LocalSums& out) {
    out.overlay[i] += direct.radiance, out.samples[i] += direct.nodes;
    if (!out.bend.empty()) out.bend[i] += direct.bend, out.nearness[i] += direct.nearness;
}

/// All light at one point, for reference_estimate.
struct LocalArrival {
    const LightChain& lights;
    Vec3f p, ng;
    float side;

    ExactLight exact(const Vec3f& d) const { return lights.exact({p, ng, d, 0, side}); }
    LightDraw sample(const Vec2f& u) const { return lights.sample(p, u); }
};

}  // namespace

MaterialTaps::MaterialTaps(const Material& material, const EstimatorSettings& estimator)
    : lobes(material.lobes), settings(estimator) {
    if (settings.kind == EstimatorKind::reference) return;
    if (settings.kind == EstimatorKind::factored)
        throw Error(ErrorCode::bad_argument,
                    "estimator: factored maps hold distant light alone, and some pixels of material '" + material.name +
                        "' see a light that is near; use another estimator, or leave them the environment alone (--chain)");
    for (const LobeParameters& lobe : lobes) taps.emplace_back(lobe, settings);
}

void add_local_lobe(const LobeTaps& taps, const LightChain& lights, const SurfaceBatch& batch, const LocalSums& out) {
    const TapTable* table = taps.table();
    const size_t at_once = std::max(kFewestPixels, table ? kRaysAtOnce / static_cast<size_t>(table->tap_count()) : 0);
    TapRays asked;
    std::vector<Tap> own;
    std::vector<Incident> found;
    std::vector<float> kept;
    for (size_t begin = 0; begin < batch.size(); begin += at_once) {
        const size_t end = std::min(begin + at_once, batch.size());
        if (table)
            set_table_rays({taps.lobe(), *table, kWorld}, batch, begin, end, asked);
        else
            set_own_rays(taps, batch, begin, end, own, asked);
        found.resize(std::max(found.size(), asked.count()));
        const std::vector<DirectLight> direct = direct_light(taps.lobe(), lights, batch, begin, end, asked, kept);
        lights.lookup(std::span(asked.rays).first(asked.count()), std::span(found).first(asked.count()), kept);
        for (size_t i = begin, first = 0; i < end; first = asked.ends[i++ - begin]) {
            const size_t last = asked.ends[i - begin];
            add_pixel(asked, found, first, last, lobe_scale(batch, i, taps.lobe()), i, out);
            out.samples[i] += static_cast<float>(looked_up(kept, asked.count(), first, last));
            if (!direct.empty()) add_direct(direct[i - begin], i, out);
        }
    }
}

void add_local_reference(const LobeParameters& parameters, uint32_t index, const EstimatorSettings& settings,
                         const LightChain& lights, const SurfaceBatch& batch, const LocalSums& out) {
    visit_lobe(parameters, [&](const auto& prototype) {
        for (size_t i = 0; i < batch.size(); ++i) {
            const ShadingPoint point = shading_point(batch, i, parameters, kWorld);
            const LocalArrival light{lights, batch.p[i], batch.geometric_normal()[i], prototype.side_sign};
            const uint32_t seed = reference_seed(batch, i, index);
            const ReferenceEstimate estimate =
                reference_estimate(prototype.with_widths(point.mx, point.my), light, settings, point, seed);
            out.overlay[i] += estimate.mean * point.scale;
            out.standard_error[i] = std::hypot(out.standard_error[i], estimate.standard_error * luminance(point.scale));
            out.samples[i] += static_cast<float>(estimate.lookups);
        }
    });
}

void add_local_pass(const LobeParameters& parameters, uint32_t index, const LightChain& lights, const SurfaceBatch& batch,
                    std::span<RunningReference> running) {
    visit_lobe(parameters, [&](const auto& prototype) {
        for (size_t i = 0; i < batch.size(); ++i) {
            const ShadingPoint point = shading_point(batch, i, parameters, kWorld);
            const LocalArrival light{lights, batch.p[i], batch.geometric_normal()[i], prototype.side_sign};
            add_reference_pass(prototype.with_widths(point.mx, point.my), light, point, reference_seed(batch, i, index),
                               point.scale, running[i]);
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
                    const LightRay ray{batch.p[i], batch.geometric_normal()[i], disc.direction * to_world, disc.radius(),
                                       lobe.side_sign};
                    out.overlay[i] += shown * lights.left_for(link, ray);
                }
            }
        });
    }
}

}  // namespace burnish
