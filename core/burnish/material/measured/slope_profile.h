// How the slopes of a measured lobe are distributed over their size: D and its border, where no formula gives them.
//
//     D(h) = q(s) / (pi mx my (1 + rho^2) cos^4 theta_h),   rho^2 = x^2 / mx^2 + y^2 / my^2,   s = ln(1 + rho^2)
//
// (x, y) are the slopes of h. q is the density of s, piecewise linear; GGX has q = exp(-s). The measure s is even in area near the
// centre and even in log rho in the tail, so that sharp peaks and wide hazes are resolved alike.
#pragma once

#include <array>
#include <functional>

namespace burnish {

class SlopeProfile {
public:
    static constexpr int kNodes = 97;
    static constexpr float kLast = 20;  // s of the last node: rho = 22,000

    /// GGX's.
    SlopeProfile();
    /// From any function of rho that is proportional to the slopes' density (an area density); GGX's where that holds nothing.
    explicit SlopeProfile(const std::function<double(double rho)>& density);

    /// q(s); integrates to 1.
    float q(float s) const;
    /// rho beyond which the share xi of the slopes lies.
    float border(float xi) const;

private:
    void integrate();

    std::array<float, kNodes> m_q;
    std::array<double, kNodes> m_below;  // share of the slopes below each node
};

}  // namespace burnish
