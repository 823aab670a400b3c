// Drawing directions from a measured lobe: numerical inversion of the distribution of half vectors, view by view.
//
// For each of a set of views the lobe f cos(theta_i) is tabulated over the half vector's slopes, in cells that are even in
// s = ln(1 + rho^2) and in azimuth (slope_profile.h); between views the tables are mixed, and the mixture inverted, so that draws
// move smoothly with the view. Lobes of isotropic tables are kept by the azimuth from the view's, and one half of them. A share of
// the draws is spread over the hemisphere by its cosine, for what the cells do not know of.
#pragma once

#include <burnish/base/types.h>

#include <array>
#include <functional>
#include <vector>

namespace burnish {

class HalfVectorSampler {
public:
    /// f cos(theta_i) as a luminance; wo and wi above the surface.
    using Lobe = std::function<double(const Vec3f& wo, const Vec3f& wi)>;

    /// `own`: the lobe's own widths. Calls `lobe` from several threads.
    HalfVectorSampler(const Lobe& lobe, const Vec2f& own, bool isotropic);

    /// A direction of the lobe stretched to these widths; may lie below the surface. wo.z > 0, u in [0, 1)^2.
    Vec3f sample(const Vec3f& wo, const Vec2f& u, const Vec2f& widths) const;
    /// Its density in solid angle of wi; both above the surface.
    float pdf(const Vec3f& wo, const Vec3f& wi, const Vec2f& widths) const;

private:
    static constexpr int kRings = 64;

    /// One row of cells, and one view: shares of the draws before each cell and each ring.
    struct View {
        std::vector<std::array<float, kRings + 1>> before_azimuth;  // [azimuth][ring], the last the whole ring
        std::array<float, kRings + 1> before_ring;                  // the last the whole lobe
    };
    /// Up to four views and their weights.
    struct Mixture {
        std::array<const View*, 4> view;
        std::array<double, 4> weight;
        int count = 0;

        double before_ring(int ring) const;
        double before_azimuth(int ring, int azimuth) const;
    };

    std::vector<double> lattice(const Lobe& lobe, const Vec3f& wo) const;
    View tabulated(const Lobe& lobe, const Vec3f& wo) const;
    Mixture mixture(const Vec3f& wo) const;
    Vec3f view_direction(int theta, int phi) const;

    bool m_isotropic;
    int m_thetas, m_phis, m_azimuths;
    Vec2f m_own;
    float m_step;  // of s, a ring
    std::vector<View> m_views;
};

}  // namespace burnish
