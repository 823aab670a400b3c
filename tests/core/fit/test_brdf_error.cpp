#include "grid_cases.h"

#include <burnish/fit/brdf_error.h>
#include <burnish/material/measured/half_difference.h>
#include <burnish/material/measured/merl_table.h>

#include <gtest/gtest.h>

using namespace burnish;
using namespace grid_cases;

namespace {

constexpr double kPiD = std::numbers::pi;

/// The integral of cos_i cos_o over all trusted pairs, in elevations and azimuth, without half vectors.
double trusted_integral() {
    constexpr int kSteps = 160;
    const double step = kTrustedElevation / kSteps;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i)
        for (int o = 0; o < kSteps; ++o)
            for (int k = 0; k < kSteps; ++k) {
                const double ti = (i + 0.5) * step, to = (o + 0.5) * step, phi = (k + 0.5) * kPiD / kSteps;
                const double between = std::cos(ti) * std::cos(to) + std::sin(ti) * std::sin(to) * std::cos(phi);
                if (std::acos(std::min(1.0, between)) >= 2 * kTrustedDifference) continue;
                sum += std::sin(ti) * std::cos(ti) * std::sin(to) * std::cos(to);
            }
    return sum * step * step * (2 * kPiD / kSteps) * 2 * kPiD;
}

Material diffuse(float kd) {
    Material material;
    material.kd = Color3f(kd);
    return material;
}

}  // namespace

TEST(BrdfError, OfDiffuseMaterialsIsTheirDifference) {
    const BrdfGrid grid = grey_grid({90, 90, 36, 2}, [](const GridAngles&) { return 0.5 / kPiD; });
    const double expected = 0.1 / kPiD * std::sqrt(trusted_integral());
    const BrdfError error = brdf_error(grid, diffuse(0.4f));
    EXPECT_NEAR(error.absolute[0], expected, 0.004 * expected);
    EXPECT_NEAR(error.albedo[0], 0.5, 0.02);
    EXPECT_NEAR(error.overall(), error.channel(1), 1e-12);
    EXPECT_LT(brdf_error(grid, diffuse(0.5f)).worst_channel(), 1e-6);
}

TEST(BrdfError, ResolvesPeaksOfTheNarrowestLobes) {
    // f = D / sqrt(cos_i cos_o), D Gaussian: integral f^2 cos_i cos_o = 1 / (2 pi m^2) times 4 pi sin^2 of the trusted theta_d.
    for (const double m : {1e-5, 1e-3, 1e-2}) {
        const BrdfGrid grid = grey_grid({180, 30, 12, 4}, [&](const GridAngles& a) {
            const auto [cos_i, cos_o] = cosines(a);
            return std::exp(-std::pow(std::tan(a.theta_h) / m, 2)) / (kPiD * m * m) / std::sqrt(cos_i * cos_o);
        });
        const double expected = std::sqrt(2.0) * std::sin(kTrustedDifference) / m;
        EXPECT_NEAR(brdf_error(grid, diffuse(0)).absolute[0] / expected, 1, 0.02) << m;
    }
}

TEST(BrdfError, AlbedoIsOfTheBrightestDirection) {
    // f = 1 / (cos_i + cos_o): the albedo seen from a direction of cosine c is 2 pi (L - c ln((c + 1) / (c + l))) over [l, 1].
    const BrdfGrid grid = grey_grid({90, 90, 36, 2}, [](const GridAngles& a) {
        const auto [cos_i, cos_o] = cosines(a);
        return 1 / (cos_i + cos_o);
    });
    const double l = std::cos(kTrustedElevation), c = std::cos(60 * kPiD / 180);
    const double at_60 = 2 * kPiD * ((1 - l) - c * std::log((c + 1) / (c + l)));
    EXPECT_GT(grid.max_albedo(0), at_60);
    EXPECT_LT(grid.max_albedo(0), 2 * kPiD * (1 - l));
}

TEST(BrdfGrid, ReadsTheCellsOfATable) {
    const MerlTable table([](const Vec3f& wo, const Vec3f& wi) {
        const HalfDifference a = half_difference(wo, wi);
        return Color3f(a.theta_h, a.theta_d, wo.z * wi.z);
    });
    const BrdfGrid grid({90, 30, 36, 2}, table);
    for (size_t j = 0; j < grid.cells().size(); j += 97) {
        const auto [h, d, p, cos_i, cos_o, weight] = grid.cells()[j];
        const Color3f f = *table.at({h, 3 * d + 1, 5 * p + 2});
        EXPECT_EQ(grid.f(0)[j], f.x);
        EXPECT_EQ(grid.f(1)[j], f.y);
        EXPECT_NEAR(grid.f(1)[j], grid.theta_d(d), 1e-5);
        EXPECT_NEAR(grid.f(2)[j], cos_i * cos_o, 1e-5);
    }
}

TEST(BrdfGrid, LeavesOutWhatWasNotMeasured) {
    const BrdfGrid whole = grey_grid(kSmall, [](const GridAngles&) { return 1; });
    const BrdfGrid holed = grey_grid(kSmall, [](const GridAngles& a) { return a.phi_d < 1 ? -1 : 1; });
    EXPECT_LT(holed.cells().size(), 0.8 * whole.cells().size());
    for (const BrdfGrid::Cell& cell : holed.cells()) EXPECT_GE(holed.phi_d(cell.p), 1);
}
