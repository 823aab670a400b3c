#include <burnish/fit/fit_curves.h>

#include <burnish/material/material_brdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace burnish {
namespace {

constexpr float kDegree = kPi / 180;
constexpr std::array<float, 4> kIncident_deg{10, 30, 50, 70};
constexpr int kSlicePoints = 180, kLobeStep_deg = 1;

/// In the plane of incidence, y = 0: positive angles on the side that light is mirrored to.
Vec3f in_plane(float theta_deg) { return {std::sin(theta_deg * kDegree), 0, std::cos(theta_deg * kDegree)}; }

using Pair = std::pair<Vec3f, Vec3f>;  // wo, wi

struct Sides {
    const MeasuredBrdf& data;
    MaterialBrdf fit;

    FitCurve curve(const std::string& kind, const std::vector<float>& angles_deg,
                   const std::function<Pair(float)>& pair) const {
        FitCurve result{kind, 0, angles_deg, {}, {}};
        for (const float angle : angles_deg) {
            const auto [wo, wi] = pair(angle);
            result.data.push_back(data.eval(wo, wi));
            result.fit.push_back(fit(wo, wi));
        }
        return result;
    }

    FitCurve lobe(const std::string& kind, float theta_i_deg, float side) const {
        std::vector<float> angles;
        for (int a = -89; a <= 89; a += kLobeStep_deg) angles.push_back(static_cast<float>(a));
        const Vec3f wi = in_plane(-theta_i_deg);
        FitCurve result = curve(kind, angles, [&](float angle) {
            const Vec3f out = in_plane(angle);
            return Pair(out, Vec3f(wi.x, wi.y, side * wi.z));
        });
        result.theta_i_deg = theta_i_deg;
        return result;
    }
};

/// Dense towards 0, where lobes are sharp: steps grow as their square roots' do, as MERL's do.
std::vector<float> slice_angles(float last_deg) {
    std::vector<float> angles;
    for (int i = 0; i < kSlicePoints; ++i) {
        const float part = (static_cast<float>(i) + 0.5f) / kSlicePoints;
        angles.push_back(last_deg * part * part);
    }
    return angles;
}

}  // namespace

std::vector<FitCurve> fit_curves(const MeasuredBrdf& data, const Material& fit) {
    const Sides sides{data, MaterialBrdf(fit)};
    std::vector<FitCurve> curves{
        sides.curve("half", slice_angles(89), [](float angle) { return Pair(in_plane(angle), in_plane(angle)); }),
        sides.curve("difference", slice_angles(85), [](float angle) { return Pair(in_plane(angle), in_plane(-angle)); })};
    for (const float theta_i : kIncident_deg) curves.push_back(sides.lobe("lobe", theta_i, 1));
    if (data.transmits())
        for (const float theta_i : kIncident_deg) curves.push_back(sides.lobe("through", theta_i, -1));
    return curves;
}

std::vector<AngleResidual> angle_residuals(const MeasuredBrdf& data, const Material& fit) {
    struct Sums {
        Color3f off{0, 0, 0}, all{0, 0, 0};
        int pairs = 0;
    };
    constexpr float kStep_deg = 10;
    const MaterialBrdf model(fit);
    std::map<int, Sums> by_angle;
    for (const BrdfSample& sample : data.samples()) {
        const float theta = std::acos(std::min(std::fabs(sample.wi.z), 1.0f)) / kDegree;
        Sums& sums = by_angle[static_cast<int>(std::lround(theta / kStep_deg))];
        const Color3f difference = sample.f - model(sample.wo, sample.wi);
        const Color3f distance(std::fabs(difference.x), std::fabs(difference.y), std::fabs(difference.z));
        sums.off += distance * sample.wo.z, sums.all += sample.f * sample.wo.z, ++sums.pairs;
    }
    std::vector<AngleResidual> residuals;
    for (const auto& [angle, sums] : by_angle) {
        Color3f relative(0);
        for (int k = 0; k < 3; ++k) relative[k] = sums.all[k] > 0 ? sums.off[k] / sums.all[k] : 0.0f;
        residuals.push_back({kStep_deg * static_cast<float>(angle), sums.pairs, relative});
    }
    return residuals;
}

}  // namespace burnish
