// Anti-aliasing: what was shaded at finer samples becomes pixels, each sample by its weight in the pixel's filter.
//
//     overlay of a pixel = sum of weight x coverage x overlay over its samples
//
// Samples without surface add nothing, so that edges come out premultiplied, as they are in the beauty.
#pragma once

#include <burnish/composite/composite.h>
#include <burnish/composite/pixel_filter.h>
#include <burnish/composite/sample_grid.h>
#include <burnish/surface/surfaces.h>

namespace burnish {

class Resolver {
public:
    /// `filter` must be settled. `samples`: what images of samples hold, in the finer frame; `pixels`: what comes out.
    Resolver(const SampleGrid& grid, const PixelFilter& filter, const Window& samples, const Window& pixels);

    /// Mean of an image of samples, 1 or 3 channels, over what `coverage` gives of each; 0 where that is nothing.
    Image mean(const Image& samples, const PixelVector<float>& coverage) const;
    /// The shares of pixels that are shaded, which is `coverage`, and of what the pixel shows of surfaces at all, the part that
    /// is shaded: as large a part of the rendered specular is theirs.
    Cover cover(const Surfaces& surfaces, const PixelVector<float>& coverage) const;
    /// Sum of a number, 1 channel, over the samples that are a pixel's own.
    Image sum(const Image& samples) const;
    /// The same for the least of them; `none` where there are none.
    Image least(const Image& samples, float none) const;

private:
    template <int kChannels, class IsEmpty, class Sample>
    Image filtered(const IsEmpty& is_empty, const Sample& sample) const;
    template <int kChannels>
    Image mean_of(const Image& samples, const PixelVector<float>& coverage) const;
    template <class Fold>
    Image folded(const Image& samples, float first, const Fold& fold) const;

    FilterTaps m_taps;
    Window m_samples, m_pixels;
    int m_factor, m_left, m_top;  // own samples of the first pixel begin in this column and row of the images
};

}  // namespace burnish
