// From how sharply an overlay bends to how densely it has to be shaded.
//
// Bilinear interpolation over a step of D radians misses at most D^2 / 8 of a second derivative along each axis, so the second
// derivative of what a display shows is all that counts. With display ~ sqrt(x), x = the overlay L scaled to a mean of 0.18,
//
//     d2 display ~ L'' sqrt(s / L) / 2,     L'' = sum of taps' weight * curvature of the light filtered to the tap's width
//
// plus what suns and the lobe's own change with the view add. As a bandwidth: nu of a full-range sinusoid that bends as much.
#pragma once

#include <burnish/shading/albedo_curve.h>
#include <burnish/shading/predictor.h>

#include <span>
#include <vector>

namespace burnish {

inline constexpr int kPredictionTaps = 4;     // that stand for a lobe, by measurement
inline constexpr float kDisplayMean = 0.18f;  // of a picture as a display shows it

/// What the lobes of a material add up to at the pixels of a batch.
struct BendSums {
    explicit BendSums(size_t count);

    std::vector<Color3f> overlay;
    std::vector<float> bend;  // L'', per radian^2 of the reflected direction

    /// `add_light` adds one lobe to overlay and bend; how the lobe changes with the view comes to that.
    template <class AddLight>
    void add_lobe(const SurfaceBatch& batch, const AlbedoCurve& albedo, const AddLight& add_light) {
        note_luminance();
        add_light();
        add_view_bend(batch, albedo);
    }
    /// Sets nu_a, in periods of a display signal from black to white, and that signal; `exposure` scales overlays to kDisplayMean.
    void set_frequencies(float exposure, float safety, std::span<AngularPrediction> out) const;

private:
    void note_luminance();
    void add_view_bend(const SurfaceBatch& batch, const AlbedoCurve& albedo);

    std::vector<float> m_view_bend, m_before;
};

/// How far from a pixel's direction the prediction for its lobes holds, as far as this one lets it; and how far the lobe reaches.
void limit_reach(const LobeParameters& lobe, const SurfaceBatch& batch, std::span<AngularPrediction> out);

}  // namespace burnish
