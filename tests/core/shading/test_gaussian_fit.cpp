// The fit of a lobe by spherical Gaussians, against sums over the whole sphere that share nothing with the fit's own quadrature.
#include "core/scenes.h"

#include <burnish/material/lobe.h>
#include <burnish/shading/lobe_fit.h>

#include <gtest/gtest.h>

using namespace burnish;
using scenes::lobe_of;

namespace {

Vec3f view(float theta_deg, float phi_deg = 0) {
    const float theta = theta_deg * kPi / 180, phi = phi_deg * kPi / 180;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double gaussian(const Vec3f& d, const Vec3f& wi, double sigma) {
    const double k = 1 / (sigma * sigma);
    return std::exp(k * (static_cast<double>(d.dot(wi)) - 1)) * k / (2 * M_PI * (1 - std::exp(-2 * k)));
}

struct Sphere {
    double residual, energy_error;
};

/// Relative error of the Gaussians over a grid of the sphere in equal areas, below the horizon too; green channel.
Sphere over_sphere(const LobeParameters& parameters, const Vec3f& wo, const GaussianTaps& taps) {
    return visit_lobe(parameters, [&](const auto& lobe) {
        constexpr int kRows = 1000, kColumns = 2000;
        double error = 0, power = 0, energy = 0, fitted = 0;
        for (int row = 0; row < kRows; ++row)
            for (int column = 0; column < kColumns; ++column) {
                const double z = 2 * (row + 0.5) / kRows - 1, phi = 2 * M_PI * (column + 0.5) / kColumns,
                             r = std::sqrt(1 - z * z);
                const Vec3f wi(static_cast<float>(r * std::cos(phi)), static_cast<float>(r * std::sin(phi)),
                               static_cast<float>(z));
                const double truth = wi.z > 0 ? lobe.eval(wo, lobe.mirrored(wi)).y * wi.z : 0;
                double sum = 0;
                for (const GaussianTap& tap : taps)
                    sum += tap.weight.y * gaussian(tap_direction(wo, tap.sx, tap.sy), wi, std::exp(tap.log_sigma));
                error += (sum - truth) * (sum - truth), power += truth * truth, energy += truth, fitted += sum;
            }
        return Sphere{std::sqrt(error / power), fitted / energy - 1};
    });
}

class FittedLobe : public testing::TestWithParam<ModelId> {};

TEST_P(FittedLobe, ResidualIsTheErrorOverTheSphere) {
    const LobeParameters lobe = lobe_of(GetParam(), 0.2f, 0.2f);
    for (const float theta : {0.0f, 40.0f, 70.0f}) {
        const Vec3f wo = view(theta);
        GaussianTaps taps = fit_view(lobe, wo, true, 4, {});
        const float residual = fit_gaussians(lobe_quadrature(lobe, wo, true, 4), wo, true, 0, taps);
        const Sphere truth = over_sphere(lobe, wo, taps);
        EXPECT_NEAR(residual, truth.residual, 0.1 * truth.residual + 0.004) << theta;
        EXPECT_NEAR(truth.energy_error, 0, 4e-3) << theta;
    }
}

TEST_P(FittedLobe, MoreGaussiansFitBetter) {
    const LobeParameters lobe = lobe_of(GetParam(), 0.1f, 0.1f);
    const Vec3f wo = view(65);
    const LobeQuadrature quadrature = lobe_quadrature(lobe, wo, true, 7);
    float before = 1;
    for (const int n : {1, 2, 4, 7}) {
        GaussianTaps taps = fit_view(lobe, wo, true, n, {});
        const float residual = fit_gaussians(quadrature, wo, true, 0, taps);
        EXPECT_LT(residual, 0.8f * before) << n;
        before = residual;
    }
    EXPECT_LT(before, 0.07f);
}

INSTANTIATE_TEST_SUITE_P(Models, FittedLobe, testing::Values(ModelId::kurt, ModelId::beckmann, ModelId::ggx),
                         [](const auto& info) { return std::string(model_info(info.param).name); });

TEST(GaussianFit, OneGaussianFromAboveIsTheLobeItself) {
    const LobeParameters lobe = lobe_of(ModelId::beckmann, 0.05f, 0.05f);
    const GaussianTaps taps = fit_view(lobe, view(0), true, 1, {});
    EXPECT_LT(over_sphere(lobe, view(0), taps).residual, 0.01);
    EXPECT_NEAR(std::exp(taps[0].log_sigma), std::sqrt(2.0f) * 0.05f, 0.002f);  // slopes of m / sqrt 2 turn wi twice as far
}

TEST(GaussianFit, FollowsAnAnisotropicLobeThroughTheAzimuth) {
    const LobeParameters lobe = lobe_of(ModelId::beckmann, 0.2f, 0.075f);
    for (const float phi : {0.0f, 35.0f, 90.0f}) {
        const Vec3f wo = view(50, phi);
        EXPECT_LT(over_sphere(lobe, wo, fit_view(lobe, wo, false, 8, {})).residual, 0.05) << phi;
    }
}

TEST(GaussianFit, NeighbouringViewsHaveNeighbouringTaps) {
    const LobeParameters lobe = lobe_of(ModelId::ggx, 0.15f, 0.15f);
    std::vector<Vec3f> views;
    for (int i = 0; i <= 80; ++i) views.push_back(view(static_cast<float>(i)));
    const auto fits = fit_path(lobe, views, true, 60, fit_view(lobe, views[60], true, 5, {}));
    for (size_t i = 1; i < views.size(); ++i)
        for (size_t k = 0; k < fits[i].size(); ++k) {
            EXPECT_NEAR(fits[i][k].sx, fits[i - 1][k].sx, 0.6f * lobe.mx) << i;
            EXPECT_NEAR(fits[i][k].log_sigma, fits[i - 1][k].log_sigma, 0.6f) << i;
        }
}

/// A coloured Fresnel term has its own weights in every channel, all of the right sum.
TEST(GaussianFit, KeepsTheColourOfFresnel) {
    LobeParameters lobe = lobe_of(ModelId::ggx, 0.2f, 0.2f);
    lobe.fresnel.kind = FresnelKind::schlick, lobe.fresnel.eta = Color3f(0.9f, 0.5f, 0.04f);
    const LobeQuadrature quadrature = lobe_quadrature(lobe, view(70), true, 5);
    const GaussianTaps taps = fit_view(lobe, view(70), true, 5, {});
    Color3f sum(0);
    for (const GaussianTap& tap : taps) sum += tap.weight;
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(sum[k], quadrature.albedo[k], 5e-3f * quadrature.albedo[k]) << k;
}

}  // namespace
