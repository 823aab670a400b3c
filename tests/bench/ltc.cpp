#include "ltc.h"

#include <burnish/base/parallel.h>
#include <burnish/material/albedo.h>
#include <burnish/material/lobe.h>

#include <algorithm>

namespace burnish {
namespace {

using Imath::V3d;
using Fit = LinearlyTransformedCosines::Fit;

constexpr int kViews = 48;
constexpr int kSteps = 40;  // of both samplings that the fit's error is measured with, a side

/// M and its inverse of a fit: columns turned by the tilt about y.
struct Transform {
    double a, b, c, sine, cosine;

    explicit Transform(const Fit& fit) : a(fit.a), b(fit.b), c(fit.c), sine(std::sin(fit.tilt)), cosine(std::cos(fit.tilt)) {}
    V3d forward(const V3d& v) const {
        const double x = a * v.x + c * v.z, z = v.z;
        return {cosine * x + sine * z, b * v.y, cosine * z - sine * x};
    }
    V3d back(const V3d& v) const {
        const double x = cosine * v.x - sine * v.z, z = cosine * v.z + sine * v.x;
        return {(x - c * z) / a, v.y / b, z};
    }
    /// Density of directions.
    double density(const V3d& wi) const {
        const V3d w = back(wi);
        const double length2 = w.length2();
        return std::max(w.z, 0.0) / (std::numbers::pi * length2 * length2 * a * b);
    }
};

/// The paper's error, integral of |difference|^3, by samples of lobe and fit with equal shares.
template <class LobeType>
double error_of(const LobeType& lobe, const Vec3f& wo, const Fit& fit) {
    const Transform transform(fit);
    double sum = 0;
    const auto add = [&](const V3d& wi) {
        const Vec3f w(wi);
        const double value = w.z > 0 ? luminance(lobe.eval(wo, w)) * w.z : 0.0, fitted = fit.albedo * transform.density(wi);
        const double density = transform.density(wi) + (w.z > 0 ? lobe.pdf(wo, w) : 0.0);
        if (density > 0) sum += std::pow(std::fabs(value - fitted), 3) / density;
    };
    for (int y = 0; y < kSteps; ++y)
        for (int x = 0; x < kSteps; ++x) {
            const Vec2f u((static_cast<float>(x) + 0.5f) / kSteps, (static_cast<float>(y) + 0.5f) / kSteps);
            const double r = std::sqrt(u.x), phi = 2 * std::numbers::pi * u.y;
            add(transform.forward({r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u.x)}).normalized());
            add(V3d(lobe.sample(wo, u)));
        }
    return sum / (kSteps * kSteps);
}

using Simplex = std::array<std::array<double, 3>, 4>;  // ln a, ln b, c

/// Nelder & Mead 1965.
template <class Error>
std::array<double, 3> minimise(std::array<double, 3> start, Error&& error) {
    Simplex points{start, start, start, start};
    for (int i = 0; i < 3; ++i) points[static_cast<size_t>(i) + 1][static_cast<size_t>(i)] += i < 2 ? 0.2 : 0.05;
    std::array<double, 4> values;
    for (size_t i = 0; i < 4; ++i) values[i] = error(points[i]);
    for (int step = 0; step < 120; ++step) {
        std::array<size_t, 4> order{0, 1, 2, 3};
        std::sort(order.begin(), order.end(), [&](size_t i, size_t j) { return values[i] < values[j]; });
        const size_t best = order[0], worst = order[3];
        const auto along = [&](double t) {
            std::array<double, 3> place{};
            for (size_t c = 0; c < 3; ++c) {
                const double centre = (points[order[0]][c] + points[order[1]][c] + points[order[2]][c]) / 3;
                place[c] = centre + t * (points[worst][c] - centre);
            }
            return place;
        };
        auto next = along(-1);
        double value = error(next);
        if (value < values[best]) {
            const auto farther = along(-2);
            if (const double there = error(farther); there < value) next = farther, value = there;
        } else if (value >= values[order[2]]) {
            next = along(value < values[worst] ? -0.5 : 0.5), value = error(next);
        }
        if (value < values[worst]) {
            points[worst] = next, values[worst] = value;
            continue;
        }
        for (size_t i = 0; i < 4; ++i)
            if (i != best) {
                for (size_t c = 0; c < 3; ++c) points[i][c] = 0.5 * (points[i][c] + points[best][c]);
                values[i] = error(points[i]);
            }
    }
    return points[static_cast<size_t>(std::min_element(values.begin(), values.end()) - values.begin())];
}

template <class LobeType>
Fit fit_view(const LobeType& lobe, const LobeParameters& parameters, float angle, const Fit& near) {
    const Vec3f wo(std::sin(angle), 0, std::cos(angle));
    V3d mean(0, 0, 0);
    for (int y = 0; y < kSteps; ++y)
        for (int x = 0; x < kSteps; ++x) {
            const Vec3f wi =
                lobe.sample(wo, {(static_cast<float>(x) + 0.5f) / kSteps, (static_cast<float>(y) + 0.5f) / kSteps});
            const float pdf = lobe.pdf(wo, wi);
            if (wi.z > 0 && pdf > 0) mean += V3d(wi) * static_cast<double>(luminance(lobe.eval(wo, wi)) * wi.z / pdf);
        }
    Fit fit = near;
    fit.tilt = static_cast<float>(std::atan2(mean.x, mean.z));
    fit.albedo = luminance(directional_albedo(parameters, wo));
    const auto with = [&](const std::array<double, 3>& p) {
        Fit other = fit;
        other.a = static_cast<float>(std::exp(p[0])), other.b = static_cast<float>(std::exp(p[1])),
        other.c = static_cast<float>(p[2]);
        return other;
    };
    return with(
        minimise({std::log(near.a), std::log(near.b), near.c}, [&](const auto& p) { return error_of(lobe, wo, with(p)); }));
}

/// Irradiance under unit radiance of what of a polygon lies above z = 0.
float irradiance(std::span<const Vec3f> corners) {
    std::array<Vec3f, 16> above;
    size_t count = 0;
    for (size_t i = 0; i < corners.size(); ++i) {
        const Vec3f &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if (a.z > 0) above[count++] = a.normalized();
        if ((a.z > 0) != (b.z > 0)) above[count++] = (a + (b - a) * (a.z / (a.z - b.z))).normalized();
    }
    float sum = 0;
    for (size_t i = 0; i < count; ++i) {
        const Vec3f &a = above[i], &b = above[(i + 1) % count], across = a.cross(b);
        const float sine = across.length();
        if (sine > 0) sum += std::atan2(sine, a.dot(b)) * across.z / sine;
    }
    return std::fabs(sum) / (2 * kPi);
}

}  // namespace

LinearlyTransformedCosines::LinearlyTransformedCosines(const LobeParameters& parameters) : m_views(kViews) {
    visit_lobe(parameters, [&](const auto& lobe) {
        Fit near;
        near.a = near.b = 1.5f * parameters.mx;
        for (int i = 0; i < kViews; ++i) {
            const float angle = std::min(0.5f * kPi * static_cast<float>(i) / (kViews - 1), 1.55f);
            near = m_views[static_cast<size_t>(i)] = fit_view(lobe, parameters, angle, near);
        }
    });
}

float LinearlyTransformedCosines::shade(const ConvexPolygon& lamp, const Vec3f& p, const Vec3f& n, const Vec3f& wo) const {
    const Frame view = Frame::along(n, wo);
    const float place = std::acos(std::clamp(wo.dot(n), 0.0f, 1.0f)) / (0.5f * kPi) * (kViews - 1);
    const int low = std::min(static_cast<int>(place), kViews - 2);
    const float part = place - static_cast<float>(low);
    const Fit &one = m_views[static_cast<size_t>(low)], &other = m_views[static_cast<size_t>(low) + 1];
    const auto mixed = [&](float Fit::*field) { return one.*field + (other.*field - one.*field) * part; };
    const Fit fit{mixed(&Fit::a), mixed(&Fit::b), mixed(&Fit::c), mixed(&Fit::tilt), mixed(&Fit::albedo)};
    const Transform transform(fit);
    std::array<Vec3f, 8> corners;
    for (size_t i = 0; i < lamp.corners.size(); ++i)
        corners[i] = Vec3f(transform.back(V3d(view.to_local(lamp.corners[i] - p))));
    return fit.albedo * irradiance({corners.data(), lamp.corners.size()});
}

}  // namespace burnish
