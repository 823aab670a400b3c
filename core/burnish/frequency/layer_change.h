// What changes over a surface besides its normals: roughness, as if normals turned; and layers no interpolation may cross.
#pragma once

#include <burnish/input/frame.h>
#include <burnish/material/parameters.h>
#include <burnish/surface/surfaces.h>

#include <vector>

namespace burnish {

class LayerChange {
public:
    /// Of the layers that some lobe reads (`used`) and the frame has.
    LayerChange(const AovFrame& frame, const PerPixel& used, bool roughness_is_alpha);

    bool is_empty() const { return m_layers.empty(); }
    /// squares[i] = max(squares[i], change squared) from pixel (first + i, y), i in [0, count), to the one (dx, dy) further, of those
    /// in the frame.
    void add(int y, int first, int count, int dx, int dy, float* squares) const;

private:
    /// Of values a and b of neighbours, and the one before a: the turning that shows as much, infinite where one is too much to
    /// interpolate. Before is null where a may be the corner of every cell, at which a line may bend.
    struct Layer {
        const Image* image;
        float (*change)(const float* before, const float* a, const float* b);
    };
    std::vector<Layer> m_layers;
};

}  // namespace burnish
