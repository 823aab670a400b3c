#include <burnish/shading/predictor.h>

#include <burnish/shading/curvature_prediction.h>
#include <burnish/shading/wavelet_prediction.h>

#include <variant>

namespace burnish {

struct BandwidthPredictor::Variant {
    std::variant<CurvaturePrediction, WaveletPrediction> prediction;

    static Variant of(const Material& material, const Environment& light, const DensitySettings& settings) {
        if (settings.prediction == PredictionKind::curvature) return {CurvaturePrediction(material, light, settings)};
        return {WaveletPrediction(material, light, settings)};
    }
};

BandwidthPredictor::BandwidthPredictor(const Material& material, const Environment& light, const DensitySettings& settings)
    : m_variant(std::make_shared<Variant>(Variant::of(material, light, settings))) {}

void BandwidthPredictor::predict(const SurfaceBatch& batch, std::span<AngularPrediction> out) const {
    std::visit([&](const auto& prediction) { prediction.predict(batch, out); }, m_variant->prediction);
}

}  // namespace burnish
