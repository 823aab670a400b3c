#include <burnish/material/material_brdf.h>

namespace burnish {

MaterialBrdf::MaterialBrdf(const Material& material) : m_diffuse(material.kd / kPi) {
    for (const LobeParameters& lobe : material.lobes)
        m_lobes.push_back({AnyModel(lobe), lobe.tint * lobe.strength, lobe.side == Side::transmission ? -1.0f : 1.0f,
                           std::cos(lobe.rotation), std::sin(lobe.rotation)});
}

Color3f MaterialBrdf::operator()(const Vec3f& wo, const Vec3f& wi) const {
    if (wo.z <= 0) return Color3f(0);
    Color3f f = wi.z > 0 ? m_diffuse : Color3f(0);
    for (const OneLobe& lobe : m_lobes) {
        if (wi.z * lobe.side_sign <= 0) continue;
        const auto turned = [&](const Vec3f& w, float sign) {
            return Vec3f(lobe.cosine * w.x + lobe.sine * w.y, lobe.cosine * w.y - lobe.sine * w.x, w.z * sign);
        };
        f += lobe.weight * lobe.model.eval(turned(wo, 1), turned(wi, lobe.side_sign));
    }
    return f;
}

}  // namespace burnish
