// How fast one material's overlay varies with the direction of reflection: the angular half of the bandwidth prediction.
//
// Under distant light the transport operators come down to one product (frequency/operators.h),
//
//     b = nu_a * |change of the reflected direction per pixel|   cycles per pixel,
//
// of which the second factor is geometry and this is the first.
#pragma once

#include <burnish/light/environment.h>
#include <burnish/material/parameters.h>
#include <burnish/sampling/density.h>
#include <burnish/surface/surface_batch.h>

#include <memory>
#include <span>

namespace burnish {

class BandwidthPredictor {
public:
    /// The environment must outlive the predictor.
    BandwidthPredictor(const Material& material, const Environment& light, const DensitySettings& settings);

    /// nu_a of the overlay at each pixel of the batch, cycles per radian of the reflected direction, safety included.
    /// Thread-safe; the same pixel gives the same bits in whatever batch it comes.
    void predict(const SurfaceBatch& batch, std::span<float> nu_a) const;

    struct Variant;  // one kind of prediction

private:
    std::shared_ptr<const Variant> m_variant;
};

}  // namespace burnish
