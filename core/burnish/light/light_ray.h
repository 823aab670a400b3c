// The one question every light answers: what arrives at a point from about a direction?
//
// Distant light depends on the direction alone. Light of a room depends on the point too, so a lookup is a ray with the width of
// the cone around it, and besides radiance it brings what sparse shading must know: how sharply the light bends there and how near
// it is. Every light representation has
//
//     void lookup(std::span<const LightRay> rays, std::span<Incident> out) const;   filtered, a batch at a time
//     ExactLight exact(const LightRay& ray) const;                                  unfiltered, for the reference
//     bool can_sample() const;                                                      whether `sample` finds its bright parts
//     LightDraw sample(const Vec3f& p, const Vec2f& u) const;
//     float mean_luminance() const;                                                 may be left out, see light_mean.h
//
// all thread-safe, the same bits for a ray whatever batch it comes in. Radiance is linear RGB in the frame's colour space.
#pragma once

#include <burnish/base/types.h>

#include <cmath>

namespace burnish {

/// World space, scene units.
struct LightRay {
    Vec3f p;          // the shaded point
    Vec3f ng;         // unit geometric normal there, on the viewer's side; rays that pass through the surface have d . ng < 0
    Vec3f d;          // unit
    float sigma = 0;  // radian: the light is averaged with a spherical Gaussian exp((cos - 1) / sigma^2) about d
    float side = 1;   // 1: light that comes from where ng points is asked for; -1: from the other side, through the surface
};

struct Incident {
    Color3f radiance{0, 0, 0};  // mean over the cone, of those parts of it that the light answers for; 0 for the others
    float cover = 0;            // share of the cone that it answers for, [0, 1]; the rest is for the next light
    float bend = 0;             // bound of the second derivative of radiance's luminance along great circles of d, per radian^2
    float nearness = 0;         // 1 / distance from p to what is seen, per scene unit; 0 for distant light
};

/// How much the nearness of one of several sources counts: what moves past shows by how sharply it bends, or else by its light.
inline float nearness_weight(float luminance, float bend) { return std::fabs(luminance) + bend; }

/// Along one ray.
struct ExactLight {
    Color3f radiance{0, 0, 0};
    float cover = 0;
    float pdf = 0;  // density with which `sample` draws this direction from this point, per steradian; 0 if it cannot
};

struct LightDraw {
    Vec3f d{0, 0, 1};  // unit, world space
    float pdf = 0;     // per steradian; 0 = nothing to be drawn from that point
};

}  // namespace burnish
