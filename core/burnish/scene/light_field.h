// Irradiance at every pixel of a G-buffer, coarse, and its smooth average around any point a camera sees.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/input/frame.h>
#include <burnish/scene/irradiance.h>

namespace burnish {

class LightField {
public:
    /// Gathers one run per pixel of a frame of trace_gbuffer. Frame, tracer and gatherer must outlive the field.
    LightField(const AovFrame& frame, const Tracer& tracer, const IrradianceGatherer& gatherer, const Progress& progress);

    /// Irradiance at a hit the camera sees at raster position (x, y), pixels: the average of the 4 x 4 pixels around it that
    /// lie on the same smooth surface, or all runs gathered at the hit itself where there is none.
    Irradiance around(const Hit& hit, float x, float y) const;

private:
    bool same_surface(const Hit& hit, size_t pixel) const;

    const AovFrame& m_frame;
    const Image &m_position, &m_normal;
    const IrradianceGatherer& m_gatherer;
    std::vector<int> m_object;  // index into the scene, -1 = none
    std::vector<Irradiance> m_light;
};

}  // namespace burnish
