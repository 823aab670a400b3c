// Dense shading: every valid pixel of the frame, tile by tile.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/shading/material_shader.h>
#include <burnish/surface/surfaces.h>

#include <vector>

namespace burnish {

/// What shading leaves behind; all images have the frame's size.
struct ShadedFrame {
    Image overlay;         // linear RGB; 0 where nothing was shaded; coverage not yet applied
    Image standard_error;  // 1 channel, `reference` only, else empty
    Image samples;         // 1 channel: lookups per pixel; empty unless asked for
    double lookups = 0;    // total
};

/// Shades pixels of rule i with shaders[i]. Bit-identical for any thread count.
ShadedFrame shade_dense(const Surfaces& surfaces, const Assignment& assignment, const std::vector<MaterialShader>& shaders,
                        const Progress& progress, bool with_samples = false);

}  // namespace burnish
