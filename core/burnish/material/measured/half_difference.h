// Half and difference angles: a pair of directions as its half vector and as what is left when that is turned to the normal.
//
// In these coordinates highlights stay in one place: theta_h is small in them whatever the view, theta_d carries Fresnel, phi_d
// the rest. Source: Rusinkiewicz 1998, "A new change of variables for efficient BRDF representation".
#pragma once

#include <burnish/base/types.h>

namespace burnish {

struct DirectionPair {
    Vec3f wo, wi;
};

/// Angles in radians: theta_h, theta_d in [0, pi/2], phi_h and phi_d in (-pi, pi]. Exchanging wo and wi adds pi to phi_d.
struct HalfDifference {
    float theta_h, phi_h, theta_d, phi_d;
};

/// Of unit vectors; exact to float near theta_h = 0 and theta_d = 0 as well, where the azimuths of a zero vector are 0.
inline HalfDifference half_difference(const Vec3f& wo, const Vec3f& wi) {
    const Vec3f sum = wo + wi, apart = wi - wo;  // 2 cos(theta_d) h and 2 sin(theta_d) times the difference's direction
    const float across = std::sqrt(sum.x * sum.x + sum.y * sum.y), length = std::sqrt(across * across + sum.z * sum.z);
    HalfDifference angles{std::atan2(across, sum.z), 0, std::atan2(std::sqrt(apart.length2()), length), 0};
    const Vec2f phi_h = across > 0 ? Vec2f(sum.x, sum.y) / across : Vec2f(1, 0);
    const float cos_h = length > 0 ? sum.z / length : 0.0f, sin_h = length > 0 ? across / length : 1.0f;
    const float along = phi_h.x * apart.x + phi_h.y * apart.y;
    angles.phi_h = across > 0 ? std::atan2(sum.y, sum.x) : 0.0f;
    angles.phi_d = std::atan2(phi_h.x * apart.y - phi_h.y * apart.x, cos_h * along - sin_h * apart.z);
    return angles;
}

/// The pair of these angles; either may lie below the surface.
inline DirectionPair directions(const HalfDifference& angles) {
    const float sin_h = std::sin(angles.theta_h), cos_h = std::cos(angles.theta_h), sin_d = std::sin(angles.theta_d);
    const float x = sin_d * std::cos(angles.phi_d), y = sin_d * std::sin(angles.phi_d), z = std::cos(angles.theta_d);
    const float cos_phi = std::cos(angles.phi_h), sin_phi = std::sin(angles.phi_h);
    const auto turned = [&](float dx, float dy) {
        const float along = cos_h * dx + sin_h * z;
        return Vec3f(cos_phi * along - sin_phi * dy, sin_phi * along + cos_phi * dy, cos_h * z - sin_h * dx);
    };
    return {turned(-x, -y), turned(x, y)};
}

}  // namespace burnish
