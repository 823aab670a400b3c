// A few hundred pixels of a material as the exact integral has them, and how far an estimate of them is off.
//
// The reference has noise of its own, which is known and taken out of the figure: so it may be as large as the error that is looked for,
// and a few hundred lookups a pixel do.
#pragma once

#include <burnish/shading/material_shader.h>
#include <burnish/surface/surfaces.h>

#include <cstdint>
#include <span>
#include <vector>

namespace burnish {

/// How far an estimate is from a truth, over its pixels, at their own exposure: the mean of the truth is shown at 0.18.
struct Closeness {
    double psnr_db = 0;  // of the display signal; infinite where the difference is below the truth's noise
    double low_db = 0;   // it is at least so much, in nine of ten draws of pixels
    double largest = 0;  // of the display signal, over pixels and channels, the truth's noise there taken off
    size_t pixels = 0;
};

class Truth {
public:
    /// `batch`: of the pixels, with the fields that `reference` needs, whose estimator is `reference`.
    Truth(SurfaceBatch batch, const MaterialShader& reference);

    const SurfaceBatch& batch() const { return m_batch; }
    const std::vector<Color3f>& radiance() const { return m_radiance; }
    /// Lookups that were spent on all of it.
    double lookups() const { return m_lookups; }

    /// Entry i of `estimate` is for pixel i of the batch.
    Closeness closeness(std::span<const Color3f> estimate) const;
    Closeness closeness(const MaterialShader& estimator) const;

private:
    SurfaceBatch m_batch;
    std::vector<Color3f> m_radiance;
    std::vector<float> m_relative_error;  // standard error over the luminance
    double m_exposure = 1, m_lookups = 0;
};

/// About `count` valid pixels of `rule`, spread evenly over its part of the frame, at random within; the same for the same frame.
std::vector<uint32_t> check_pixels(const Surfaces& surfaces, const Assignment& assignment, int rule, size_t count);

}  // namespace burnish
