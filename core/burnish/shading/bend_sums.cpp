#include <burnish/shading/bend_sums.h>

#include <burnish/light/filter/light_curvature.h>
#include <burnish/shading/shading_point.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr float kDarkest = 0.0015f;  // of which a display shows no more detail than linearly

}  // namespace

BendSums::BendSums(size_t count)
    : overlay(count, Color3f(0, 0, 0)), bend(count, 0.0f), m_view_bend(count, 0.0f), m_before(count) {}

void BendSums::note_luminance() {
    for (size_t i = 0; i < overlay.size(); ++i) m_before[i] = luminance(overlay[i]);
}

void BendSums::add_view_bend(const SurfaceBatch& batch, const AlbedoCurve& albedo) {
    for (size_t i = 0; i < overlay.size(); ++i) {
        const float cos_o = batch.n[i].dot(batch.wo[i]);
        m_view_bend[i] += 0.25f * (luminance(overlay[i]) - m_before[i]) * albedo.curvature(cos_o);
    }
}

void BendSums::set_frequencies(float exposure, float safety, std::span<AngularPrediction> out) const {
    for (size_t i = 0; i < overlay.size(); ++i) {
        const float root = std::sqrt(bend[i]) + std::sqrt(std::max(m_view_bend[i], 0.0f));
        const float shown = std::max(luminance(overlay[i]) * exposure, kDarkest);
        out[i].shown = std::sqrt(shown);
        out[i].nu_a = safety * root * std::sqrt(exposure / out[i].shown) / (2 * kPi);
    }
}

void limit_reach(const LobeParameters& lobe, const SurfaceBatch& batch, std::span<AngularPrediction> out) {
    for (size_t i = 0; i < batch.size(); ++i) {
        const Vec2f widths = lobe_widths(batch, i, lobe);
        const float width = std::sqrt(2.0f) * std::min(widths.x, widths.y);
        out[i].reach = std::min(out[i].reach, kCurvatureReach * width);
        if (widths.x != widths.y) out[i].length = std::max(out[i].length, std::sqrt(2.0f) * std::max(widths.x, widths.y));
    }
}

}  // namespace burnish
