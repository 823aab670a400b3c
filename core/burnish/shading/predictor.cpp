#include <burnish/shading/predictor.h>

#include <burnish/shading/curvature_prediction.h>

namespace burnish {

struct BandwidthPredictor::Variant : CurvaturePrediction {
    using CurvaturePrediction::CurvaturePrediction;
};

namespace {

PerPixel operator|(const PerPixel& a, const PerPixel& b) {
    return {a.roughness || b.roughness, a.anisotropy || b.anisotropy, a.rotation || b.rotation, a.tint || b.tint,
            a.weight || b.weight};
}

}  // namespace

BandwidthPredictor::BandwidthPredictor(const Material& material, const Environment& light, const DensitySettings& settings)
    : m_variant(std::make_shared<Variant>(material, light, settings)) {
    for (const LobeParameters& lobe : material.lobes) {
        m_is_anisotropic |= lobe.is_anisotropic();
        m_used_layers = m_used_layers | lobe.per_pixel;
    }
}

void BandwidthPredictor::predict(const SurfaceBatch& batch, std::span<AngularPrediction> out) const {
    m_variant->predict(batch, out);
}

PerPixel used_layers(std::span<const BandwidthPredictor> predictors) {
    PerPixel used;
    for (const BandwidthPredictor& predictor : predictors) used = used | predictor.used_layers();
    return used;
}

}  // namespace burnish
