// Curves of data and fit: where lobes point, and what stands beside what.
#include <burnish/fit/fit_curves.h>
#include <burnish/material/material_brdf.h>
#include <burnish/material/measured/gonio_table.h>
#include <burnish/material/measured/merl_table.h>
#include <core/material/lobe_cases.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace burnish {
namespace {

Material satin() {
    Material material;
    material.kd = Color3f(0.1f);
    material.lobes = {make_lobe(ModelId::ggx, 0.15f, 0.15f)};
    return material;
}

const FitCurve& curve(const std::vector<FitCurve>& curves, const std::string& kind, float theta_i_deg = 0) {
    return *std::ranges::find_if(curves, [&](const FitCurve& c) { return c.kind == kind && c.theta_i_deg == theta_i_deg; });
}

float brightest_deg(const std::vector<float>& angles, const std::vector<Color3f>& values) {
    const auto brightest = std::ranges::max_element(values, {}, [](const Color3f& f) { return f.y; });
    return angles[static_cast<size_t>(brightest - values.begin())];
}

TEST(FitCurves, OfDenseTablesPointToTheMirrorDirection) {
    const std::vector<FitCurve> curves = fit_curves(MerlTable(MaterialBrdf(satin())), satin());
    for (const float theta_i : {10.0f, 30.0f, 50.0f}) {
        const FitCurve& lobe = curve(curves, "lobe", theta_i);
        EXPECT_NEAR(brightest_deg(lobe.data_deg, lobe.data), theta_i, 6);
        EXPECT_NEAR(brightest_deg(lobe.fit_deg, lobe.fit), theta_i, 6);
    }
    const FitCurve &half = curve(curves, "half"), &difference = curve(curves, "difference");
    EXPECT_LT(half.data.back().y, 0.1f * half.data.front().y);
    EXPECT_GT(difference.data.back().y, half.data.back().y);
    for (size_t i = 0; i < half.data.size(); ++i) EXPECT_NEAR(half.data[i].y / half.fit[i].y, 1, 0.04) << half.data_deg[i];
}

TEST(FitCurves, OfSparseTablesAreTheirPairs) {
    const MaterialBrdf f(satin());
    std::vector<BrdfSample> pairs;
    for (const double theta_i : {20.0, 40.0})
        for (double theta_o = 0; theta_o < 85; theta_o += 5)
            for (double phi = 0; phi < 360; phi += 45)
                pairs.push_back({direction_deg(theta_o, phi), direction_deg(theta_i, 0),
                                 f(direction_deg(theta_o, phi), direction_deg(theta_i, 0))});
    const std::vector<FitCurve> curves = fit_curves(GonioTable(pairs, true), satin());
    for (const float theta_i : {20.0f, 40.0f}) {
        const FitCurve &all = curve(curves, "pairs", theta_i), &lobe = curve(curves, "lobe", theta_i);
        EXPECT_EQ(all.data.size(), pairs.size() / 2);
        EXPECT_EQ(all.data, all.fit);
        EXPECT_TRUE(std::ranges::is_sorted(all.data_deg));
        EXPECT_NEAR(brightest_deg(lobe.data_deg, lobe.data), theta_i, 6);
        EXPECT_NEAR(brightest_deg(lobe.fit_deg, lobe.fit), theta_i, 6);
    }
    for (const AngleResidual& residual : angle_residuals(GonioTable(pairs, true), satin()))
        EXPECT_LT(residual.relative.y, 1e-5f) << residual.theta_i_deg;
}

}  // namespace
}  // namespace burnish
