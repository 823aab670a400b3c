// Unit vectors of listed pixels, from the interleaved layers of a frame to planes, with the widest vectors the processor has.
#pragma once

#include <burnish/surface/surface_batch.h>

#include <span>

namespace burnish {

/// unit[i] <- v / |v|, v the three channels of `layer` at pixels[i]. Neighbours in a row are read fastest. The same bits on
/// every processor and in whatever list a pixel comes.
void fetch_unit(const float* layer, std::span<const uint32_t> pixels, Vec3Planes& unit);

/// The same for v = eye - position: the directions to the viewer.
void fetch_views(const float* position, const Vec3f& eye, std::span<const uint32_t> pixels, Vec3Planes& wo);

}  // namespace burnish
