// Some pixels of a material as the exact integral has them, and how far an estimate of them is off.
//
// The reference has noise of its own, which is known and taken out of the figure: so it may be as large as the error that is looked for,
// and a few hundred lookups a pixel do.
#pragma once

#include <burnish/plan/check_sample.h>

#include <span>
#include <vector>

namespace burnish {

/// How far an estimate is from the truth, over the material's pixels, at their own exposure: their mean is shown at 0.18.
struct Closeness {
    double psnr_db = 0;  // of the display signal; infinite where the difference is below the truth's noise
    double low_db = 0;   // it is at least so much, in nine of ten draws of pixels
    double largest = 0;  // of the display signal, over pixels and channels, the truth's noise there taken off
    size_t pixels = 0;
};

class Truth {
public:
    /// `reference`: the pixels' material under the estimator `reference`.
    Truth(const Surfaces& surfaces, CheckSample sample, const MaterialShader& reference);

    /// Of an estimator that shades the pixels, of an overlay that holds them, of values in the order of the pixels.
    Closeness closeness(const MaterialShader& estimator) const { return closeness(shade(estimator)); }
    Closeness closeness(const Image& overlay) const;
    Closeness closeness(std::span<const Color3f> estimate) const;

    /// The pixels by an estimator; and how far two such pictures are apart, dB.
    std::vector<Color3f> shade(const MaterialShader& estimator) const { return shade_all(m_batches, estimator).overlay; }
    double distance_db(std::span<const Color3f> a, std::span<const Color3f> b) const;

    size_t pixel_count() const { return m_sample.pixels.size(); }
    /// That the reference spent, all pixels.
    double lookups() const { return m_lookups; }

private:
    CheckSample m_sample;
    std::vector<SurfaceBatch> m_batches;
    std::vector<Color3f> m_radiance;
    std::vector<float> m_relative_error;  // standard error over luminance
    double m_lookups = 0;
};

}  // namespace burnish
