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
constexpr int kSlicePoints = 180;
constexpr float kStep_deg = 10;     // incident angles are gathered to
constexpr float kInPlane_deg = 10;  // azimuth of a pair that still counts as in the plane of incidence

/// In the plane of incidence, y = 0: positive angles on the side that light is mirrored to.
Vec3f in_plane(float theta_deg) { return {std::sin(theta_deg * kDegree), 0, std::cos(theta_deg * kDegree)}; }

float theta_deg(float cosine) { return std::acos(std::clamp(cosine, -1.0f, 1.0f)) / kDegree; }
float incident_deg(const BrdfSample& sample) { return kStep_deg * std::round(theta_deg(std::fabs(sample.wi.z)) / kStep_deg); }

using Pair = std::pair<Vec3f, Vec3f>;  // wo, wi

/// Dense towards 0, where lobes are sharp: steps grow as their square roots' do, as MERL's do.
std::vector<float> slice_angles(float last_deg) {
    std::vector<float> angles;
    for (int i = 0; i < kSlicePoints; ++i) {
        const float part = (static_cast<float>(i) + 0.5f) / kSlicePoints;
        angles.push_back(last_deg * part * part);
    }
    return angles;
}

std::vector<float> lobe_angles() {
    std::vector<float> angles;
    for (int a = -89; a <= 89; ++a) angles.push_back(static_cast<float>(a));
    return angles;
}

Pair lobe_pair(float theta_i_deg, float angle, float side) {
    const Vec3f wi = in_plane(-theta_i_deg);
    return {in_plane(angle), Vec3f(wi.x, wi.y, side * wi.z)};
}

struct Curves {
    const MeasuredBrdf& data;
    MaterialBrdf fit;
    std::vector<FitCurve> all = {};

    void add_dense(const std::string& kind, float theta_i_deg, const std::vector<float>& angles,
                   const std::function<Pair(float)>& pair) {
        FitCurve curve{kind, theta_i_deg, angles, angles};
        for (const float angle : angles) {
            const auto [wo, wi] = pair(angle);
            curve.data.push_back(data.eval(wo, wi));
            curve.fit.push_back(fit(wo, wi));
        }
        all.push_back(std::move(curve));
    }

    void add_lobe(const std::string& kind, float theta_i_deg, float side) {
        add_dense(kind, theta_i_deg, lobe_angles(), [&](float angle) { return lobe_pair(theta_i_deg, angle, side); });
    }

    void add_pairs(float theta_i_deg, std::vector<const BrdfSample*> samples) {
        FitCurve curve{"pairs", theta_i_deg};
        const auto half_z = [](const BrdfSample* s) {
            return (s->wo + Vec3f(s->wi.x, s->wi.y, std::fabs(s->wi.z))).normalized().z;
        };
        std::ranges::sort(samples, std::ranges::greater(), half_z);
        for (const BrdfSample* sample : samples) {
            curve.data_deg.push_back(theta_deg(half_z(sample)));
            curve.data.push_back(sample->f);
            curve.fit.push_back(fit(sample->wo, sample->wi));
        }
        curve.fit_deg = curve.data_deg;
        all.push_back(std::move(curve));
    }

    void add_sparse_lobe(const std::string& kind, float theta_i_deg, float side,
                         const std::vector<const BrdfSample*>& samples) {
        FitCurve curve{kind, theta_i_deg, {}, lobe_angles()};
        for (const float angle : curve.fit_deg) {
            const auto [wo, wi] = lobe_pair(theta_i_deg, angle, side);
            curve.fit.push_back(fit(wo, wi));
        }
        for (const BrdfSample* sample : samples) {
            const Vec3f &wo = sample->wo, &wi = sample->wi;
            const float across = std::fabs(wo.x * wi.y - wo.y * wi.x), along = -(wo.x * wi.x + wo.y * wi.y);
            if (across > std::tan(kInPlane_deg * kDegree) * std::fabs(along) + 1e-6f) continue;
            curve.data_deg.push_back(std::copysign(theta_deg(wo.z), along));
            curve.data.push_back(sample->f);
        }
        all.push_back(std::move(curve));
    }
};

void add_slices(Curves& curves) {
    curves.add_dense("half", 0, slice_angles(89), [](float angle) { return Pair(in_plane(angle), in_plane(angle)); });
    curves.add_dense("difference", 0, slice_angles(85), [](float angle) { return Pair(in_plane(angle), in_plane(-angle)); });
    for (const float theta_i : kIncident_deg) curves.add_lobe("lobe", theta_i, 1);
    if (curves.data.transmits())
        for (const float theta_i : kIncident_deg) curves.add_lobe("through", theta_i, -1);
}

/// Of the incident angles with most pairs.
void add_measured(Curves& curves, const std::vector<BrdfSample>& samples) {
    std::map<float, std::vector<const BrdfSample*>> by_angle;
    for (const BrdfSample& sample : samples) by_angle[incident_deg(sample)].push_back(&sample);
    std::vector<std::pair<float, std::vector<const BrdfSample*>>> angles(by_angle.begin(), by_angle.end());
    std::ranges::stable_sort(angles, std::ranges::greater(), [](const auto& angle) { return angle.second.size(); });
    angles.resize(std::min(angles.size(), kIncident_deg.size()));
    std::ranges::sort(angles, {}, [](const auto& angle) { return angle.first; });
    for (const auto& [angle, own] : angles) {
        curves.add_pairs(angle, own);
        for (const float side : {1.0f, -1.0f}) {
            std::vector<const BrdfSample*> on_side;
            std::ranges::copy_if(own, std::back_inserter(on_side), [&](const BrdfSample* s) { return s->wi.z * side > 0; });
            if (!on_side.empty()) curves.add_sparse_lobe(side > 0 ? "lobe" : "through", angle, side, on_side);
        }
    }
}

}  // namespace

std::vector<FitCurve> fit_curves(const MeasuredBrdf& data, const Material& fit) {
    Curves curves{data, MaterialBrdf(fit)};
    if (data.is_dense())
        add_slices(curves);
    else
        add_measured(curves, data.samples());
    return std::move(curves.all);
}

std::vector<AngleResidual> angle_residuals(const MeasuredBrdf& data, const Material& fit) {
    struct Sums {
        Color3f off{0, 0, 0}, all{0, 0, 0};
        int pairs = 0;
    };
    const MaterialBrdf model(fit);
    std::map<float, Sums> by_angle;
    for (const BrdfSample& sample : data.samples()) {
        Sums& sums = by_angle[incident_deg(sample)];
        const Color3f difference = sample.f - model(sample.wo, sample.wi);
        const Color3f distance(std::fabs(difference.x), std::fabs(difference.y), std::fabs(difference.z));
        sums.off += distance * sample.wo.z, sums.all += sample.f * sample.wo.z, ++sums.pairs;
    }
    std::vector<AngleResidual> residuals;
    for (const auto& [angle, sums] : by_angle) {
        Color3f relative(0);
        for (int k = 0; k < 3; ++k) relative[k] = sums.all[k] > 0 ? sums.off[k] / sums.all[k] : 0.0f;
        residuals.push_back({angle, sums.pairs, relative});
    }
    return residuals;
}

}  // namespace burnish
