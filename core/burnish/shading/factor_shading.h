// Shading by the maps of a factored light: a few lookups a pixel and their product, whatever the number of lobes and lamps.
//
// Maps are kept as RGBA, cubes with a border of their neighbours' texels and what is one row as two, so that every bilinear lookup
// reads two texels of two rows.
#pragma once

#include <burnish/factor/factors.h>
#include <burnish/surface/surface_batch.h>

#include <span>
#include <vector>

namespace burnish {

class FactorShading {
public:
    /// Of maps of lighting. Throws Error(bad_argument) for a BRDF's, and for more than kMostLookups factors.
    explicit FactorShading(const Factors& factors);

    /// A pixel's, all terms.
    int lookup_count() const { return static_cast<int>(m_lookups.size()) * m_terms; }

    /// Sets radiance[i] to what Factors::operator() gives for pixel i in light axes; world_to_light: row vector times matrix. The same
    /// pixel gives the same bits in whatever batch it comes. Thread-safe.
    void shade(const SurfaceBatch& batch, const Matrix33f& world_to_light, std::span<Color3f> radiance) const;

    static constexpr size_t kMostLookups = 8;  // factors of a parametrisation

    /// Directions that the kernel computes for a vector of pixels; others are left to ProjectedDirection::project, pixel by pixel.
    enum class Vectorised { normal, view, reflection, elevation, dominant_half, dominant_difference, none };

    /// One map of every term.
    struct Texture {
        Mapping mapping;
        int size, stride;         // texels along a side of a disc or face or of the row, and from row to row
        std::vector<float> rgba;  // term after term
        size_t term_floats;       // of each
    };
    struct Lookup {
        const ProjectedDirection* direction;
        Vectorised vectorised;
        int texture;
    };

    const std::vector<Texture>& textures() const { return m_textures; }
    const std::vector<Lookup>& lookups() const { return m_lookups; }
    int terms() const { return m_terms; }
    const FactorGuide& guide() const { return m_guide; }

private:
    std::vector<Texture> m_textures;
    std::vector<Lookup> m_lookups;
    FactorGuide m_guide;
    int m_terms;
};

}  // namespace burnish
