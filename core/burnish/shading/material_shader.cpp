#include <burnish/shading/material_shader.h>

#include <burnish/material/lobe.h>
#include <burnish/shading/albedo_ratio.h>
#include <burnish/shading/disc_light.h>
#include <burnish/shading/filtered_importance.h>
#include <burnish/shading/pattern_bank.h>
#include <burnish/shading/reference.h>
#include <burnish/shading/regular.h>

namespace burnish {

struct MaterialShader::LobeShader {
    LobeShader(const LobeParameters& parameters, const Environment& environment, const EstimatorSettings& estimator)
        : lobe(parameters), settings(estimator), light(environment), patterns(parameters, estimator) {
        if (!settings.albedo_correction || settings.kind == EstimatorKind::reference) return;
        const auto constant_light = [](const Vec3f&, float) { return Color3f(1, 1, 1); };
        ratio = AlbedoRatio(lobe, [&](const ShadingPoint& point) {
            return visit_lobe(
                lobe, [&](const auto& own) { return few_samples(own.with_widths(point.mx, point.my), point, constant_light); });
        });
    }

    /// The two few-sample estimators differ in nothing but this call.
    template <class LobeType, class Look>
    Color3f few_samples(const LobeType& own, const ShadingPoint& point, const Look& look) const {
        if (settings.kind == EstimatorKind::filtered_importance)
            return filtered_importance_estimate(own, settings.samples, point, look);
        return regular_estimate(own, patterns.at(point.mx, point.my), settings.quadrature, point, look);
    }

    int lookups_at(const ShadingPoint& point) const {
        if (settings.kind == EstimatorKind::filtered_importance) return settings.samples;
        return static_cast<int>(patterns.at(point.mx, point.my).size());
    }

    template <class LobeType>
    void add_filtered(const LobeType& prototype, const SurfaceBatch& batch, ShadedBatch& out) const {
        const CubePyramid& pyramid = light.pyramid();
        for (size_t i = 0; i < batch.size(); ++i) {
            const ShadingPoint point = shading_point(batch, i, lobe, light.world_to_light());
            const auto look = [&](const Vec3f& wi, float omega) {
                const Vec3f d = point.frame.to_world(wi);
                return pyramid.lookup(d, pyramid.level(d, omega) + settings.level_bias);
            };
            const auto own = prototype.with_widths(point.mx, point.my);
            const Color3f map = few_samples(own, point, look) * ratio.at(point), suns = disc_light(own, light.discs(), point);
            out.overlay[i] += (map + suns) * point.scale * light.gain();
            out.samples[i] += static_cast<float>(lookups_at(point));
        }
    }

    template <class LobeType>
    void add_reference(const LobeType& prototype, const SurfaceBatch& batch, ShadedBatch& out, uint32_t lobe_index) const {
        for (size_t i = 0; i < batch.size(); ++i) {
            const ShadingPoint point = shading_point(batch, i, lobe, light.world_to_light());
            const uint32_t seed = hash_bits(batch.pixel[i] ^ lobe_index * 0xc2b2ae35u);
            const ReferenceEstimate estimate =
                reference_estimate(prototype.with_widths(point.mx, point.my), light, settings, point, seed);
            const Color3f scale = point.scale * light.gain();
            out.overlay[i] += estimate.mean * scale;
            out.standard_error[i] = std::hypot(out.standard_error[i], estimate.standard_error * luminance(scale));
            out.samples[i] += static_cast<float>(estimate.lookups);
        }
    }

    LobeParameters lobe;
    EstimatorSettings settings;
    const Environment& light;
    PatternBank patterns;
    AlbedoRatio ratio;
};

MaterialShader::MaterialShader(const Material& material, const Environment& light, const EstimatorSettings& settings) {
    for (const LobeParameters& lobe : material.lobes) m_lobes.push_back(std::make_shared<LobeShader>(lobe, light, settings));
}

bool MaterialShader::estimates_error() const {
    return !m_lobes.empty() && m_lobes[0]->settings.kind == EstimatorKind::reference;
}

void MaterialShader::shade(const SurfaceBatch& batch, ShadedBatch& out) const {
    const bool reference = estimates_error();
    out.overlay.assign(batch.size(), Color3f(0, 0, 0));
    out.samples.assign(batch.size(), 0.0f);
    out.standard_error.assign(reference ? batch.size() : 0, 0.0f);
    for (uint32_t index = 0; index < m_lobes.size(); ++index) {
        const LobeShader& shader = *m_lobes[index];
        visit_lobe(shader.lobe, [&](const auto& lobe) {
            if (reference)
                shader.add_reference(lobe, batch, out, index);
            else
                shader.add_filtered(lobe, batch, out);
        });
    }
}

}  // namespace burnish
