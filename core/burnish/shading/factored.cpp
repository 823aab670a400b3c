#include <burnish/shading/factored.h>

#include <burnish/base/error.h>
#include <burnish/factor/factorise.h>
#include <burnish/shading/lighting_samples.h>
#include <burnish/shading/material_shader.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kGrid =
    20;  // texels a side of the discs of normals and views: 26 makes no better pictures, and takes twice as long

bool is_same(const PerPixel& a, const PerPixel& b) { return a.tint == b.tint && a.weight == b.weight; }

}  // namespace

void require_factored(const Material& material) {
    require_factorable(material);
    for (const LobeParameters& lobe : material.lobes)
        if (!is_same(lobe.per_pixel, material.lobes[0].per_pixel))
            throw Error(ErrorCode::bad_argument,
                        "material '" + material.name +
                            "': layers tint or weigh some of its lobes alone, and maps hold all lobes together; use another "
                            "estimator, or let all lobes take tint and weight (--per-pixel)");
}

bool can_be_factored(const Material& material) try {
    require_factored(material);
    return true;
} catch (const Error&) {
    return false;
}

Factors factored_light(const Material& material, const Environment& light, const EstimatorSettings& settings,
                       const Progress& progress) {
    require_factored(material);
    constexpr float kSampled = 0.3f;  // of the time, about
    const Parametrization& parametrization = parametrization_by_name(settings.parametrization);
    LightingSampling sampling;
    sampling.size = kGrid;
    const std::vector<FactorSample> samples = lighting_samples(material, light, sampling, part_of(progress, 0, kSampled));
    FactorGuide guide = FactorGuide::of(material);
    if (parametrization.needs_dominant()) guide.dominant = dominant_direction(light);
    FactoriseSettings how;
    how.size = settings.map_size, how.measure = FactorMeasure::display;
    return factorise(parametrization, samples, guide, how, part_of(progress, kSampled, 1));
}

FactoredShader::FactoredShader(const Material& material, const Environment& light, const Factors& factors)
    : m_shading(factors), m_light(light) {
    require_factored(material);
    if (!material.lobes.empty()) m_layers = material.lobes[0].per_pixel;
}

void FactoredShader::shade(const SurfaceBatch& batch, ShadedBatch& out) const {
    std::vector<Color3f>& overlay = out.overlay;
    m_shading.shade(batch, m_light.world_to_light(), overlay);
    const bool tinted = m_layers.tint && !batch.tint.x.empty(), weighed = m_layers.weight && !batch.weight.empty();
    for (size_t i = 0; i < batch.size(); ++i) {
        overlay[i] *= m_light.gain();
        if (tinted) overlay[i] *= Color3f(batch.tint[i]);
        if (weighed) overlay[i] *= batch.weight[i];
    }
    std::ranges::fill(out.samples, static_cast<float>(m_shading.lookup_count()));
}

}  // namespace burnish
