// A ball of a material, to look at and to compare: the overlay by the shaders that shade frames, the diffuse part by the light's
// irradiance.
//
// Seen straight on along +Y, from far, Z up; its tangents run along the parallels. No light bounces, nothing casts a shadow.
#pragma once

#include <burnish/base/image.h>
#include <burnish/light/environment.h>
#include <burnish/material/parameters.h>
#include <burnish/sampling/estimator.h>

#include <string>

namespace burnish {

/// Distant light, Z up, and its irradiance. Prepared once, for any number of balls.
class BallLight {
public:
    /// The light of `burnish demo`, see procedural_sky.h.
    static BallLight sky();
    /// From a file, see Environment::load; a lat-long's middle is what +X sees. Throws Error(read_failed | bad_argument).
    static BallLight load(const std::string& file);
    explicit BallLight(Environment light);

    const Environment& environment() const { return m_light; }
    /// Irradiance / pi of a surface that faces n, world space.
    Color3f diffuse(const Vec3f& n) const;

private:
    Environment m_light, m_diffuse;  // irradiance / pi as a lat-long picture
};

struct BallSettings {
    int size = 256;               // pixels across and down; the ball leaves a margin of 3 %
    int samples = 4;              // across a pixel and down
    EstimatorSettings estimator;  // of the overlay
};

/// Linear RGBA, associated alpha: 0 around the ball. Same bits for any thread count.
Image render_ball(const Material& material, const BallLight& light, const BallSettings& settings);

/// The ball over a plain grey, RGB, as previews show it.
Image over_grey(const Image& ball);

}  // namespace burnish
