// Angular bandwidth of a reflectance lobe: which frequencies of the light it lets through, view by view.
//
// For a view wo the lobe f(wo, wi) |cos_i| is an image over the incident directions. It is analysed by wavelets in a window that
// is laid around the lobe's own image (lobe_window.h), so that a sharp lobe is resolved as well as a wide one: nu goes like
// 1 / m. Analytic and tabulated lobes are alike, both are functions of two directions.
#pragma once

#include <burnish/frequency/lobe_window.h>
#include <burnish/material/parameters.h>

#include <functional>
#include <vector>

namespace burnish {

/// f(wo, wi) in 1/sr, unit vectors in the local frame (z = normal); finite and >= 0. Called by several threads.
using LobeFunction = std::function<float(const Vec3f& wo, const Vec3f& wi)>;

/// What turns leave it as it is: any about the normal; half a turn and both mirrorings, at t and at b; or none.
enum class LobeSymmetry { isotropic, orthotropic, none };

class LobeBandwidth {
public:
    static constexpr int kViews = 16;  // of theta_o, and of phi_o unless the lobe's symmetry makes them alike
    static constexpr int kSlice = 16;  // results a side of a view's window

    LobeBandwidth() = default;
    /// Luminance of a lobe, Fresnel included; tint and strength do not matter.
    explicit LobeBandwidth(const LobeParameters& lobe);
    LobeBandwidth(const LobeFunction& f, LobeSymmetry symmetry);

    /// nu_rho, cycles per radian of wi: 95 % of the lobe's spectrum seen from theta_o lies below. The largest over the azimuths.
    float nu_rho(float cos_o) const;
    /// Local bandwidth of the lobe around wi, cycles per radian; beyond the window that of its border. Unit vectors.
    float at(const Vec3f& wo, const Vec3f& wi) const;

    struct View {
        LobeWindow window;
        float nu_rho = 0;
        std::vector<float> nu;  // kSlice x kSlice, row by row along `across`: the largest of what each covers
    };
    /// Row by row: all azimuths of the first theta_o, then the next.
    const std::vector<View>& views() const { return m_views; }
    /// The direction a view is taken from: the middle of its range of angles.
    Vec3f view_direction(int view) const;

private:
    int nearest_view(const Vec3f& wo) const;

    LobeSymmetry m_symmetry = LobeSymmetry::isotropic;
    int m_azimuths = 0;
    std::vector<View> m_views;
    std::vector<float> m_nu_rho;  // by theta_o, the largest over the azimuths
};

}  // namespace burnish
