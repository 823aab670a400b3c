// One pixel as a kernel sees it: the local frame of one lobe, in light axes, and the pixel's own lobe widths.
#pragma once

#include <burnish/material/parameters.h>
#include <burnish/surface/surface_batch.h>

namespace burnish {

struct ShadingPoint {
    Frame frame;   // light axes; t along the lobe's x axis
    Vec3f wo, ng;  // local
    float mx, my;
    Color3f scale;  // lobe_scale

    /// Whether wi (local) lies on the lobe's side of the geometric surface; shading normals alone let light leak through.
    bool sees(const Vec3f& wi, float side_sign) const { return ng.dot(wi) * side_sign > 0; }
};

/// The pixel's own widths where the lobe takes them from layers, else the lobe's.
inline Vec2f lobe_widths(const SurfaceBatch& batch, size_t i, const LobeParameters& lobe) {
    const bool rough = lobe.per_pixel.roughness && !batch.roughness.empty();
    const bool stretched = lobe.per_pixel.anisotropy && !batch.anisotropy.empty();
    if (!rough && !stretched) return {lobe.mx, lobe.my};
    const float m = rough ? batch.roughness[i] : std::sqrt(lobe.mx * lobe.my), ratio = std::sqrt(lobe.mx / lobe.my);
    const Vec2f widths = stretched ? anisotropic_widths(m, batch.anisotropy[i]) : Vec2f(m * ratio, m / ratio);
    return {std::min(widths.x, 1.0f), std::min(widths.y, 1.0f)};
}

/// What multiplies the lobe at a pixel: tint * strength * weight.
inline Color3f lobe_scale(const SurfaceBatch& batch, size_t i, const LobeParameters& lobe) {
    Color3f scale = lobe.tint * lobe.strength;
    if (lobe.per_pixel.tint && !batch.tint.x.empty()) scale *= Color3f(batch.tint[i]);
    if (lobe.per_pixel.weight && !batch.weight.empty()) scale *= batch.weight[i];
    return scale;
}

/// The lobe's frame in the world. An isotropic lobe has no direction of its own, so its frame follows the view: what a
/// pattern of few samples misses then depends on the view angle alone, and the albedo table knows it.
inline Frame lobe_frame(const SurfaceBatch& batch, size_t i, const LobeParameters& lobe, bool isotropic) {
    if (isotropic) return Frame::along(batch.n[i], batch.wo[i]);
    const bool turned = lobe.per_pixel.rotation && !batch.rotation.empty();
    return Frame::along(batch.n[i], batch.t[i]).turned(turned ? batch.rotation[i] : lobe.rotation);
}

/// Point i of the batch for one lobe. world_to_light: row vector times matrix.
inline ShadingPoint shading_point(const SurfaceBatch& batch, size_t i, const LobeParameters& lobe,
                                  const Matrix33f& world_to_light) {
    const Vec2f widths = lobe_widths(batch, i, lobe);
    const Frame world = lobe_frame(batch, i, lobe, widths.x == widths.y);
    ShadingPoint point;
    point.wo = world.to_local(batch.wo[i]);
    point.ng = world.to_local(batch.geometric_normal()[i]);
    point.frame = {world.t * world_to_light, world.b * world_to_light, world.n * world_to_light};
    point.mx = widths.x, point.my = widths.y;
    point.scale = lobe_scale(batch, i, lobe);
    return point;
}

}  // namespace burnish
