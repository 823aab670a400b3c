#include <burnish/shading/predictor.h>

#include <burnish/shading/curvature_prediction.h>

namespace burnish {

struct BandwidthPredictor::Variant : CurvaturePrediction {
    using CurvaturePrediction::CurvaturePrediction;
};

BandwidthPredictor::BandwidthPredictor(const Material& material, const Environment& light, const DensitySettings& settings)
    : m_variant(std::make_shared<Variant>(material, light, settings)) {}

void BandwidthPredictor::predict(const SurfaceBatch& batch, std::span<AngularPrediction> out) const {
    m_variant->predict(batch, out);
}

}  // namespace burnish
