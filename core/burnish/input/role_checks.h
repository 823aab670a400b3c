// Numbers that show whether a layer is what its name says.
#pragma once

#include <burnish/base/image.h>
#include <burnish/base/types.h>

#include <cstddef>

namespace burnish {

/// What a layer of directions turns out to hold.
enum class VectorKind {
    unit,     // length 1 where there is a surface
    encoded,  // (n + 1) / 2, as colour-coded normals are stored
    empty,    // zero or not finite everywhere
    neither,
};

struct VectorCheck {
    VectorKind kind = VectorKind::empty;
    float median_length = 0.0f;  // as stored, where not zero
};

/// Judges 3-channel vectors by the share of lengths within 5 % of 1, as stored and decoded: at least half must be.
VectorCheck check_vectors(const Image& vectors);

/// n <- 2n - 1; zero vectors (background) stay zero.
void decode_vectors(Image& vectors);

/// How many pixels see a surface (sightings.h), and how far from the origin it is.
struct PositionCheck {
    size_t pixels = 0;
    float median_size = 0.0f;  // median over pixels of max(|x|, |y|, |z|), scene units
};
PositionCheck check_positions(const Image& position);

/// Step between neighbouring half floats at `value`.
float half_step(float value);

/// What positions lose as half floats: half a step of the largest coordinate, and the largest angle by which that turns the direction
/// to a viewer at `centre`, of the nearest surface for instance.
struct HalfError {
    float step = 0.0f;  // at the median, scene units
    double turn_deg = 0.0;
};
HalfError half_error(const Image& position, const Vec3f& centre);

/// Share of interior pixels (not at silhouettes) whose normal faces the viewer at `centre`: dot(N, C - P) > 0.
struct Facing {
    size_t pixels = 0;  // looked at
    double share = 0.0;
};
Facing facing_share(const Image& normal, const Image& position, const Vec3f& centre);

/// 1 where position is a surface point and the normal (may be null) is not an average over an edge (length above 0.9), else 0.
Image surface_mask(const Image& position, const Image* normal);

/// Sets NaN and infinite values to 0; returns how many pixels had one, those of `above` rows at the top and `below` rows at the
/// bottom not counted.
size_t scrub(Image& image, int above = 0, int below = 0);

}  // namespace burnish
