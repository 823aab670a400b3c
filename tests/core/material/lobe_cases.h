// What the tests of all models share: a grid of lobes and views, and a chart of the incident directions for brute force.
#pragma once

#include <burnish/material/lobe.h>
#include <core/chi_square.h>

#include <sstream>
#include <string>
#include <vector>

namespace burnish {

inline Vec3f direction_deg(double theta_deg, double phi_deg) {
    const double t = theta_deg * M_PI / 180, p = phi_deg * M_PI / 180;
    return {static_cast<float>(std::sin(t) * std::cos(p)), static_cast<float>(std::sin(t) * std::sin(p)),
            static_cast<float>(std::cos(t))};
}

inline LobeParameters make_lobe(ModelId model, float mx, float my, Side side = Side::reflection) {
    LobeParameters lobe;
    lobe.model = model;
    lobe.side = side;
    lobe.mx = mx, lobe.my = my;
    lobe.extra = default_parameters(model_info(model));
    return lobe;
}

inline std::string label(const LobeParameters& lobe, double theta_deg) {
    std::ostringstream text;
    text << model_info(lobe.model).name << " mx " << lobe.mx << " my " << lobe.my << " theta " << theta_deg
         << (lobe.side == Side::transmission ? " transmission" : "");
    return text.str();
}

/// Every model, widths from 0.01 to 1, round and stretched, on the given sides.
inline std::vector<LobeParameters> lobe_grid(std::initializer_list<Side> sides) {
    std::vector<LobeParameters> grid;
    for (size_t model = 0; model < models().size(); ++model)
        for (const float m : {0.01f, 0.03f, 0.1f, 0.3f, 1.0f})
            for (const float anisotropy : {0.0f, 0.7f, -0.7f})
                for (const Side side : sides) {
                    if (anisotropy != 0 && !models()[model].anisotropic) continue;
                    const Vec2f widths = anisotropic_widths(m, anisotropy);
                    grid.push_back(make_lobe(static_cast<ModelId>(model), widths.x, widths.y, side));
                }
    return grid;
}

/// Unit square <-> directions wi that reflect wo off a microfacet: slopes (mx tan, my tan) of pi (a - 1/2). Built on geometry
/// alone, so it is independent of the models' own sampling; it resolves narrow and wide lobes alike. All in double.
class HalfVectorChart {
public:
    HalfVectorChart(const LobeParameters& lobe, const Vec3f& wo)
        : m_mx(lobe.mx), m_my(lobe.my), m_side(lobe.side == Side::transmission ? -1 : 1), m_wo(wo) {}

    /// wi and its solid angle per unit area of the square; 0 where the microfacet faces away from wo.
    Vec3f direction(const SquarePoint& s, double& solid_angle) const {
        const double ta = std::tan(M_PI * (s.a - 0.5)), tb = std::tan(M_PI * (s.b - 0.5));
        const Imath::V3d slope(m_mx * ta, m_my * tb, 1), h = slope / slope.length();
        const double cos_d = h.dot(m_wo), cos3 = h.z * h.z * h.z;
        solid_angle = cos_d > 0 ? 4 * cos_d * cos3 * m_mx * m_my * M_PI * M_PI * (1 + ta * ta) * (1 + tb * tb) : 0;
        const Imath::V3d wi = h * (2 * cos_d) - m_wo;
        return Vec3f(Imath::V3d(wi.x, wi.y, wi.z * m_side));
    }

    std::optional<SquarePoint> square(const Vec3f& wi) const {
        if (wi.z * m_side <= kMinCosine) return std::nullopt;
        const Imath::V3d h = m_wo + Imath::V3d(wi.x, wi.y, wi.z * m_side);
        return SquarePoint{0.5 + std::atan(h.x / h.z / m_mx) / M_PI, 0.5 + std::atan(h.y / h.z / m_my) / M_PI};
    }

    /// Brute-force integral of f(wi) dwi over the lobe's side, steps x steps midpoints.
    template <class F>
    double integral(F f, int steps = 512) const {
        double sum = 0, solid_angle = 0;
        for (int i = 0; i < steps; ++i)
            for (int j = 0; j < steps; ++j) {
                const Vec3f wi = direction({(i + 0.5) / steps, (j + 0.5) / steps}, solid_angle);
                if (solid_angle > 0) sum += solid_angle * f(wi);
            }
        return sum / steps / steps;
    }

private:
    double m_mx, m_my, m_side;
    Imath::V3d m_wo;
};

}  // namespace burnish
