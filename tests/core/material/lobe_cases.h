// What the tests of all models share: a grid of lobes and views, and a chart of the incident directions for brute force.
#pragma once

#include <burnish/material/lobe.h>
#include <burnish/material/measured/measured_lobe.h>
#include <burnish/material/measured/merl_table.h>
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

/// What the model `table` shows in these tests: a tabulated metal with a long tail.
inline std::shared_ptr<const LobeData> synthetic_table() {
    LobeParameters metal;
    metal.model = ModelId::ggx, metal.mx = metal.my = 0.2f, metal.fresnel = {FresnelKind::schlick, Color3f(0.9f, 0.7f, 0.4f)};
    static const auto measured =
        std::make_shared<const MerlTable>([metal](const Vec3f& wo, const Vec3f& wi) { return Ggx(metal).eval(wo, wi); });
    static const auto lobe = std::make_shared<const MeasuredLobe>(measured, Side::reflection, Color3f(0));
    return lobe;
}

inline LobeParameters make_lobe(ModelId model, float mx, float my, Side side = Side::reflection) {
    LobeParameters lobe;
    lobe.model = model;
    lobe.side = side;
    lobe.mx = mx, lobe.my = my;
    lobe.extra = default_parameters(model_info(model));
    if (model == ModelId::table) lobe.data = synthetic_table();
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

inline double side_sign(const LobeParameters& lobe) { return lobe.side == Side::transmission ? -1 : 1; }

/// Brute-force integral of f(wi) dwi over what a chart holds, steps x steps midpoints.
template <class Chart, class F>
double integral(const Chart& chart, F f, int steps = 512) {
    double sum = 0, solid_angle = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const Vec3f wi = chart.direction({(i + 0.5) / steps, (j + 0.5) / steps}, solid_angle);
            if (solid_angle > 0) sum += solid_angle * f(wi);
        }
    return sum / steps / steps;
}

/// Unit square <-> directions wi that reflect wo off a microfacet: slopes (mx tan, my tan) of pi (a - 1/2). Built on geometry
/// alone, so it is independent of the models' own sampling; it resolves narrow and wide lobes alike. All in double.
class HalfVectorChart {
public:
    HalfVectorChart(const LobeParameters& lobe, const Vec3f& wo, double scale = 1)
        : m_mx(scale * lobe.mx), m_my(scale * lobe.my), m_side(side_sign(lobe)), m_wo(wo) {}

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

private:
    double m_mx, m_my, m_side;
    Imath::V3d m_wo;
};

/// The same for lobes that are round about the mirror direction: slopes against it, over the hemisphere that it looks into.
class MirrorChart {
public:
    MirrorChart(const LobeParameters& lobe, const Vec3f& wo, double width)
        : m_frame(Frame::around({-wo.x, -wo.y, wo.z})), m_width(width), m_side(side_sign(lobe)) {}

    Vec3f direction(const SquarePoint& s, double& solid_angle) const {
        const double ta = std::tan(M_PI * (s.a - 0.5)), tb = std::tan(M_PI * (s.b - 0.5));
        const Imath::V3d slope(m_width * ta, m_width * tb, 1), w = slope / slope.length();
        solid_angle = w.z * w.z * w.z * m_width * m_width * M_PI * M_PI * (1 + ta * ta) * (1 + tb * tb);
        const Vec3f wi = m_frame.to_world(Vec3f(w));
        return {wi.x, wi.y, wi.z * static_cast<float>(m_side)};
    }

    std::optional<SquarePoint> square(const Vec3f& wi) const {
        const Vec3f w = m_frame.to_local({wi.x, wi.y, wi.z * static_cast<float>(m_side)});
        if (wi.z * m_side <= kMinCosine || w.z <= 0) return std::nullopt;
        return SquarePoint{0.5 + std::atan(w.x / w.z / m_width) / M_PI, 0.5 + std::atan(w.y / w.z / m_width) / M_PI};
    }

private:
    Frame m_frame;
    double m_width, m_side;
};

/// tan(theta) / m that holds all but 1 / e of the slopes, 1 for Beckmann's: what the charts scale with.
inline double slope_scale(const LobeParameters& lobe) {
    return visit_lobe(lobe, [](const auto& f) { return f.border(std::exp(-1.0f)); });
}

/// The chart that resolves a lobe at all views: about the half vector, or about the mirror direction where it is round there.
class LobeChart {
public:
    LobeChart(const LobeParameters& lobe, const Vec3f& wo)
        : m_is_about_mirror(lobe.model == ModelId::phong || lobe.model == ModelId::lewis || lobe.model == ModelId::lafortune),
          m_half(lobe, wo, slope_scale(lobe)),
          m_mirror(lobe, wo, 2 * slope_scale(lobe) * lobe.mx) {}

    Vec3f direction(const SquarePoint& s, double& solid_angle) const {
        return m_is_about_mirror ? m_mirror.direction(s, solid_angle) : m_half.direction(s, solid_angle);
    }
    std::optional<SquarePoint> square(const Vec3f& wi) const {
        return m_is_about_mirror ? m_mirror.square(wi) : m_half.square(wi);
    }

private:
    bool m_is_about_mirror;
    HalfVectorChart m_half;
    MirrorChart m_mirror;
};

}  // namespace burnish
