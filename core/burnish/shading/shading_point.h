// One pixel as a kernel sees it: the local frame of one lobe, in light axes, and the pixel's own lobe widths.
#pragma once

#include <burnish/material/parameters.h>
#include <burnish/surface/surface_batch.h>

namespace burnish {

struct ShadingPoint {
    Frame frame;             // light axes; t along the lobe's x axis
    Vec3f wo, ng;            // local
    float mx, my;
    Color3f scale;           // tint * strength * weight: multiplies the lobe

    /// Whether wi (local) lies on the lobe's side of the geometric surface; shading normals alone let light leak through.
    bool sees(const Vec3f& wi, float side_sign) const { return ng.dot(wi) * side_sign > 0; }
};

/// Point i of the batch for one lobe: per-pixel layers replace the lobe's numbers where the lobe says so.
/// world_to_light: row vector times matrix.
inline ShadingPoint shading_point(const SurfaceBatch& batch, size_t i, const LobeParameters& lobe, const Matrix33f& world_to_light) {
    const PerPixel& own = lobe.per_pixel;
    const bool turned = own.rotation && !batch.rotation.empty();
    const Frame world = Frame::along(batch.n[i], batch.t[i]).turned(turned ? batch.rotation[i] : lobe.rotation);
    ShadingPoint point;
    point.wo = world.to_local(batch.wo[i]);
    point.ng = world.to_local(batch.ng[i]);
    point.frame = {world.t * world_to_light, world.b * world_to_light, world.n * world_to_light};
    point.mx = lobe.mx, point.my = lobe.my;
    const bool rough = own.roughness && !batch.roughness.empty(), stretched = own.anisotropy && !batch.anisotropy.empty();
    if (rough || stretched) {
        const float m = rough ? batch.roughness[i] : std::sqrt(lobe.mx * lobe.my), ratio = std::sqrt(lobe.mx / lobe.my);
        const Vec2f widths = stretched ? anisotropic_widths(m, batch.anisotropy[i]) : Vec2f(m * ratio, m / ratio);
        point.mx = std::min(widths.x, 1.0f), point.my = std::min(widths.y, 1.0f);
    }
    point.scale = lobe.tint * lobe.strength;
    if (own.tint && !batch.tint.x.empty()) point.scale *= Color3f(batch.tint[i]);
    if (own.weight && !batch.weight.empty()) point.scale *= batch.weight[i];
    return point;
}

}  // namespace burnish
