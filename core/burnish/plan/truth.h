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
    /// `reference`: the pixels' material under the estimator `reference`.
    Truth(const Surfaces& surfaces, std::span<const uint32_t> pixels, const MaterialShader& reference);

    /// Of an estimator that shades the pixels, of an overlay that holds them, of values in the order of the pixels.
    Closeness closeness(const MaterialShader& estimator) const;
    Closeness closeness(const Image& overlay) const;
    Closeness closeness(std::span<const Color3f> estimate) const;

    size_t pixel_count() const { return m_pixels.size(); }
    /// That the reference spent, all pixels.
    double lookups() const { return m_lookups; }

private:
    std::vector<ShadedBatch> shaded(const MaterialShader& shader) const;

    std::vector<uint32_t> m_pixels;
    std::vector<SurfaceBatch> m_batches;  // of a few pixels, for threads
    std::vector<Color3f> m_radiance;
    std::vector<float> m_relative_error;  // standard error over luminance
    double m_exposure = 1, m_lookups = 0;
};

/// About `count` valid pixels of `rule`, spread evenly over its part of the frame, at random within; the same for the same frame.
std::vector<uint32_t> check_pixels(const Surfaces& surfaces, const Assignment& assignment, int rule, size_t count);

}  // namespace burnish
