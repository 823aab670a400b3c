#include <burnish/shading/predictor.h>

#include <burnish/shading/curvature_prediction.h>
#include <burnish/shading/local_prediction.h>
#include <burnish/shading/wavelet_prediction.h>

#include <variant>

namespace burnish {

struct BandwidthPredictor::Variant {
    std::variant<CurvaturePrediction, WaveletPrediction, LocalPrediction> prediction;

    static Variant of(const Material& material, const Environment& light, const DensitySettings& settings) {
        if (settings.prediction == PredictionKind::curvature) return {CurvaturePrediction(material, light, settings)};
        return {WaveletPrediction(material, light, settings)};
    }
};

namespace {

PerPixel operator|(const PerPixel& a, const PerPixel& b) {
    return {a.roughness || b.roughness, a.anisotropy || b.anisotropy, a.rotation || b.rotation, a.tint || b.tint,
            a.weight || b.weight};
}

}  // namespace

BandwidthPredictor::BandwidthPredictor(const Material& material, const Environment& light, const DensitySettings& settings)
    : m_safety(settings.safety), m_variant(std::make_shared<Variant>(Variant::of(material, light, settings))) {
    for (const LobeParameters& lobe : material.lobes) note(lobe);
}

BandwidthPredictor::BandwidthPredictor(std::shared_ptr<const MaterialProbes> probes, LightChain lights)
    : m_asks_rays(true), m_is_near(lights.is_near()), m_safety(probes->safety) {
    for (const MaterialProbes::Lobe& own : probes->lobes) note(own.lobe);
    m_variant = std::make_shared<Variant>(Variant{LocalPrediction(std::move(probes), std::move(lights))});
}

void BandwidthPredictor::note(const LobeParameters& lobe) {
    m_is_anisotropic |= lobe.is_anisotropic();
    m_used_layers = m_used_layers | lobe.per_pixel;
}

void BandwidthPredictor::predict(const SurfaceBatch& batch, std::span<AngularPrediction> out) const {
    std::visit([&](const auto& prediction) { prediction.predict(batch, out); }, m_variant->prediction);
}

PerPixel used_layers(std::span<const BandwidthPredictor> predictors) {
    PerPixel used;
    for (const BandwidthPredictor& predictor : predictors) used = used | predictor.used_layers();
    return used;
}

}  // namespace burnish
