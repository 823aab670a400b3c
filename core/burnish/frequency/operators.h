// What becomes of local bandwidth on its way from the light over one reflection to the camera (Bandwidth IV.3.2, figure IV.9).
//
//     nu_camera = T_d' R T_d nu_light,   R = P_x C_-c S B_t,rho C_c P_i
//
// One struct an operator, each as published; so one path is read from right to left:
//
//     T_d   free space      nu_a -= d nu_s            B    texture and lobe   (nu_s + t, min(rho, nu_a))
//     P_i   into the frame  nu_s *= cos_i             S    mirror             nu_a -> -nu_a
//     C_c   curvature       nu_s += c nu_a            P_x  out of the frame   nu_s /= cos_x
//
// Signs. A bandwidth is half the side of a rectangle, and where a rectangle is sheared its sides grow: magnitudes add, whatever the
// sign of the shear. From magnitudes and |c| the published chain does just that, and it is exact for convex surfaces. Taken
// literally it is not: T_d leaves nu_a < 0, and a convex surface would then cancel what it truly adds. So a reflection
// starts from magnitudes, and concave surfaces count as convex ones, which over-predicts where they focus.
//
// Space and angle. Light from one distance is no rectangle in the spectrum but a line, nu_s / nu_a = const. A lobe that clamps the angle
// cuts the line and so clamps the space with it. The published B keeps the whole space and over-predicts rough lobes under
// sharp light; `CorrelatedReflectance` scales both. Under distant light, with r the reflected direction:
//
//     reflected_correlated   min(rho, nu_l) |dr|
//     reflected_source       min(rho, nu_l) |dr| + (nu_l - min(rho, nu_l)) c d' / cos_x
//
// which is (nu_l + min(rho, nu_l)) / 2 |dr| where curvature turns r much more than the view does.
#pragma once

#include <burnish/frequency/bandwidth.h>

#include <algorithm>
#include <limits>

namespace burnish {

namespace transport {

constexpr float magnitude(float x) { return x < 0 ? -x : x; }
constexpr Bandwidth magnitude(const Bandwidth& nu) { return {magnitude(nu.nu_s), magnitude(nu.nu_a)}; }

/// T_d: over the distance d.
struct FreeSpace {
    float d;
    constexpr Bandwidth operator()(const Bandwidth& nu) const { return {nu.nu_s, nu.nu_a - d * nu.nu_s}; }
};

/// P_i: from across the ray to along the surface.
struct IntoSurface {
    float cos_i;
    constexpr Bandwidth operator()(const Bandwidth& nu) const { return {nu.nu_s * cos_i, nu.nu_a}; }
};

/// P_x: back, along the outgoing ray.
struct OutOfSurface {
    float cos_x;
    constexpr Bandwidth operator()(const Bandwidth& nu) const { return {nu.nu_s / cos_x, nu.nu_a}; }
};

/// C_c: into the frame that turns with the surface; c in 1/unit, positive where it is convex.
struct Curvature {
    float c;
    constexpr Bandwidth operator()(const Bandwidth& nu) const { return {nu.nu_s + c * nu.nu_a, nu.nu_a}; }
};

/// S: the outgoing angle runs against the incident one.
struct Mirror {
    constexpr Bandwidth operator()(const Bandwidth& nu) const { return {nu.nu_s, -nu.nu_a}; }
};

/// B_t,rho as published: the lobe limits the angle, the texture adds to the space. rho >= 0.
struct Reflectance {
    float t, rho;
    constexpr Bandwidth operator()(const Bandwidth& nu) const { return {nu.nu_s + t, std::clamp(nu.nu_a, -rho, rho)}; }
};

/// The same for light whose space and angle are one thing: both shrink by what the angle is clamped.
struct CorrelatedReflectance {
    float t, rho;
    constexpr Bandwidth operator()(const Bandwidth& nu) const {
        const float angle = magnitude(nu.nu_a), kept = angle > rho ? rho / angle : 1.0f;
        return {nu.nu_s * kept + t, nu.nu_a * kept};
    }
};

}  // namespace transport

/// One reflection: cosines of the light's and the view's angle to the normal, curvature in 1/unit (its sign plays no part), the
/// texture's bandwidth in cycles per unit and the lobe's in cycles per radian of the reflected direction.
struct Reflection {
    float cos_i = 1, cos_x = 1, curvature = 0, texture = 0, rho = std::numeric_limits<float>::infinity();
};

/// P_x C_-c S B C_c P_i |nu|. nu_a <= 0 <= nu_s: FreeSpace then adds up, as it has to.
template <class ReflectanceOperator>
constexpr Bandwidth reflected(const Bandwidth& nu, const Reflection& r) {
    using namespace transport;
    const float c = magnitude(r.curvature);
    const Bandwidth incident = Curvature{c}(IntoSurface{r.cos_i}(magnitude(nu)));
    return OutOfSurface{r.cos_x}(Curvature{-c}(Mirror{}(ReflectanceOperator{r.texture, r.rho}(incident))));
}

/// As published.
constexpr Bandwidth reflected_source(const Bandwidth& nu, const Reflection& r) {
    return reflected<transport::Reflectance>(nu, r);
}

/// Tighter: never more than reflected_source, and the same for a mirror.
constexpr Bandwidth reflected_correlated(const Bandwidth& nu, const Reflection& r) {
    return reflected<transport::CorrelatedReflectance>(nu, r);
}

/// What leaves the surface (`reflected_...`), seen from the distance d': magnitudes, nu_a in cycles per radian of the view.
constexpr Bandwidth at_camera(const Bandwidth& nu, float d) { return transport::magnitude(transport::FreeSpace{d}(nu)); }

/// How much faster than the view the reflected direction turns, 1 for a plane: what nu_a of the reflected direction is multiplied by.
constexpr float reflection_turn(float curvature, float cos_x, float d) {
    return at_camera(reflected_correlated({0, 1}, {1, cos_x, curvature}), d).nu_a;
}

}  // namespace burnish
