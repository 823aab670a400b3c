#include "grid_cases.h"

#include <burnish/base/parallel.h>
#include <burnish/fit/slices/slice_fit.h>
#include <burnish/material/library.h>
#include <burnish/material/material_brdf.h>
#include <burnish/material/measured/half_difference.h>
#include <burnish/material/measured/merl_table.h>
#include <burnish/material/model.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <random>

using namespace burnish;
using namespace grid_cases;

namespace {

constexpr Sgd kPolished{0.05, 200, 1.5e-4, 0.4, 0.06, 0}, kSatin{0.1, 3, 0.02, 0.3, 0.3, 0.1};

BrdfGrid grid_of(const Sgd& material) {
    return grey_grid(kSmall, [&](const GridAngles& a) { return material.f(a); });
}

FitSettings one_lobe(const std::string& model) {
    FitSettings settings;
    settings.model = model_by_name(model);
    settings.max_lobes = 1;
    return settings;
}

SliceFit fit(const BrdfGrid& grid, const FitSettings& settings) { return fit_slices(grid, settings, Progress()); }

float alpha_of(const SliceFit& fit) { return fit.result.material.lobes.at(0).extra.at(0); }

/// A lobe of a model with numbers of its own, as a table would show it, in float.
Material blunt_material(const std::string& model) {
    return material_from_json(
        {{"kd", {0.2, 0.1, 0.05}}, {"lobes", {{{"model", model}, {"ks", 0.3}, {"m", 0.25}, {"r0", 0.4}, {"f1", 0.1}}}}}, model,
        model);
}

}  // namespace

TEST(SliceFit, RecoversSgdFromThePeakToTheTail) {
    for (const Sgd& truth : {kPolished, kSatin}) {
        const SliceFit found = fit(grid_of(truth), one_lobe("sgd"));
        EXPECT_LT(found.error.worst_channel(), 1e-3);
        EXPECT_NEAR(alpha_of(found) / truth.alpha, 1, 2e-3);
        EXPECT_NEAR(found.result.material.lobes[0].extra[3], truth.p, 2e-3);
        EXPECT_NEAR(found.result.material.kd.x, truth.kd, 1e-4);
        EXPECT_NEAR(found.result.material.lobes[0].fresnel.eta.x, truth.f0, 2e-3);
        EXPECT_NEAR(found.result.material.lobes[0].fresnel.k.x, truth.f1, 2e-3);
    }
}

TEST(SliceFit, ChannelsAreTheirOwn) {
    const Sgd red{0.3, 0.5, 0.01, 0.2, 0.2, 0}, green{0.1, 0.2, 0.03, 0.6, 0.1, -0.1}, blue{0.02, 0, 0.1, 0, 0, 0};
    const BrdfGrid grid(kSmall, [&](const GridAngles& a) { return Channels{red.f(a), green.f(a), blue.f(a)}; });
    const SliceFit found = fit(grid, one_lobe("sgd"));
    EXPECT_LT(found.error.worst_channel(), 1e-3);
    const LobeParameters& lobe = found.result.material.lobes.at(0);
    EXPECT_NEAR(lobe.extra[0], red.alpha, 1e-4);
    EXPECT_NEAR(lobe.extra[1], green.alpha, 1e-3);
    EXPECT_NEAR(lobe.tint.z, 0, 1e-4);
    EXPECT_NEAR(found.result.material.kd.z, blue.kd, 1e-5);
}

TEST(SliceFit, TheMaterialIsTheFit) {
    for (const std::string model : {"sgd", "beckmann", "ggx", "abc"}) {
        const bool exact = model == "beckmann" || model == "ggx";
        const MaterialBrdf truth(blunt_material(exact ? model : "ggx"));
        const BrdfGrid grid(kSmall, [&](const GridAngles& a) -> std::optional<Channels> {
            const auto [wo, wi] = directions(
                HalfDifference{static_cast<float>(a.theta_h), 0, static_cast<float>(a.theta_d), static_cast<float>(a.phi_d)});
            const Color3f f = truth(wo, wi);
            return Channels{f.x, f.y, f.z};
        });
        const SliceFit found = fit(grid, one_lobe(model));
        const Material again = material_from_json(material_to_json(found.result.material), model, model);
        const double error = *found.result.normalised_l2;
        EXPECT_NEAR(brdf_error(grid, again).worst_channel(), error, 0.02 * error + 2e-4) << model;
        EXPECT_LT(error, exact ? 1e-3 : 0.05) << model;
    }
}

TEST(SliceFit, NoiseMovesItLittle) {
    std::mt19937 random(7);
    std::normal_distribution<double> noise(1, 0.02);
    const BrdfGrid grid = grey_grid(kSmall, [&](const GridAngles& a) { return kSatin.f(a) * std::max(0.1, noise(random)); });
    const SliceFit found = fit(grid, one_lobe("sgd"));
    EXPECT_NEAR(alpha_of(found) / kSatin.alpha, 1, 0.03);
    EXPECT_NEAR(found.result.material.kd.x, kSatin.kd, 0.003);
}

TEST(SliceFit, PeaksThatWereNotMeasuredOrClippedLeaveTheRest) {
    const double limit = 0.5 * kSatin.f({0, 0.1, 0});
    const BrdfGrid holed = grey_grid(kSmall, [&](const GridAngles& a) { return kSatin.f(a) > limit ? -1 : kSatin.f(a); });
    EXPECT_NEAR(alpha_of(fit(holed, one_lobe("sgd"))) / kSatin.alpha, 1, 0.02);
    const BrdfGrid clipped = grey_grid(kSmall, [&](const GridAngles& a) { return std::min(kSatin.f(a), limit); });
    const SliceFit found = fit(clipped, one_lobe("sgd"));
    EXPECT_NEAR(found.result.material.kd.x, kSatin.kd, 0.02);
    EXPECT_GT(found.error.worst_channel(), 1e-3);
}

TEST(SliceFit, KeepsToBounds) {
    FitSettings settings = one_lobe("sgd");
    settings.bounds = {{"p", {0, 0}}, {"alpha", {0.03, 0.05}}, {"kd", {0.08, 0.08}}, {"f1", {0, 0}}, {"ks", {0.2, 0.25}}};
    const SliceFit found = fit(grid_of(kSatin), settings);
    const LobeParameters& lobe = found.result.material.lobes.at(0);
    EXPECT_EQ(lobe.extra[3], 0);
    EXPECT_GE(lobe.extra[0], 0.03f);
    EXPECT_LE(lobe.extra[0], 0.05f);
    EXPECT_NEAR(found.result.material.kd.x, 0.08, 1e-6);
    EXPECT_NEAR(lobe.fresnel.k.x, 0, 1e-6);
    EXPECT_GE(lobe.strength, 0.2f - 1e-4f);
    EXPECT_LE(lobe.strength, 0.25f + 1e-4f);
    EXPECT_EQ(found.result.parameters % 3, 0);
    EXPECT_GE(found.result.parameters, 9);  // alpha, ks and r0 of three channels
}

TEST(SliceFit, RefusesWhatItDoesNotKnow) {
    EXPECT_THROW(fit(grid_of(kSatin), one_lobe("kurt")), Error);
    FitSettings settings = one_lobe("ggx");
    settings.bounds = {{"alpha", {0, 1}}};
    EXPECT_THROW(fit(grid_of(kSatin), settings), Error);
    settings.bounds = {{"m", {0.5, 0.2}}};
    EXPECT_THROW(fit(grid_of(kSatin), settings), Error);
    EXPECT_THROW(fit(grey_grid(kSmall, [](const GridAngles&) { return -1; }), one_lobe("sgd")), Error);
}

TEST(SliceFit, SecondLobesArePutInWhereTheyPay) {
    const Sgd wide{0, 0.6, 0.03, 0.1, 0.5, 0}, narrow{0.1, 8, 0.002, 0.3, 0.5, 0};
    FitSettings settings = one_lobe("sgd");
    settings.max_lobes = 2;
    const SliceFit two = fit(grey_grid(kSmall, [&](const GridAngles& a) { return narrow.f(a) + wide.f(a); }), settings);
    ASSERT_EQ(two.result.material.lobes.size(), 2u);
    EXPECT_NEAR(two.result.material.lobes[0].extra[0] / narrow.alpha, 1, 0.05);
    EXPECT_LT(two.error.worst_channel(), 1e-2);
    EXPECT_EQ(fit(grid_of(kSatin), settings).result.material.lobes.size(), 1u);
}

TEST(SliceFit, SaysWhatLiesOutsideTheModel) {
    const auto to_the_light = [](const GridAngles& a) {  // back to where it came from, from anywhere
        return 0.05 + 5 * std::exp(-std::pow(a.theta_d / 0.1, 2));
    };
    const SliceFit found = fit(grey_grid(kSmall, to_the_light), one_lobe("sgd"));
    ASSERT_FALSE(found.result.notes.empty());
    EXPECT_NE(found.result.notes[0].find("outside the model"), std::string::npos);
    for (const LobeParameters& lobe : found.result.material.lobes)
        EXPECT_TRUE(std::isfinite(lobe.strength) && lobe.strength >= 0);
}

TEST(SliceFit, BlackIsBlack) {
    const SliceFit found = fit(grey_grid(kSmall, [](const GridAngles&) { return 0; }), one_lobe("sgd"));
    EXPECT_NEAR(found.result.material.kd.x, 0, 1e-6);
    EXPECT_TRUE(found.result.material.lobes.empty());
    EXPECT_EQ(*found.result.normalised_l2, 0);
}

TEST(SliceFit, SameBitsForAnyNumberOfThreads) {
    const auto json = [](int threads) {
        const ThreadLimit limit(threads);
        return material_to_json(fit(grid_of(kSatin), one_lobe("sgd")).result.material);
    };
    EXPECT_EQ(json(1), json(4));
}

TEST(SliceFit, CanBeCancelled) {
    const Progress stop([](const std::string& stage, float) { return stage != "fitting the table"; });
    EXPECT_THROW(fit_slices(grid_of(kSatin), one_lobe("sgd"), stop), Error);
}

TEST(SliceFit, ReadsTablesCellByCell) {
    const MerlTable table(MaterialBrdf(blunt_material("ggx")));
    const SliceFit found = fit_slices(table, one_lobe("ggx"), Progress());
    EXPECT_LT(found.result.normalised_l2, 1e-3);
    EXPECT_NEAR(found.result.material.lobes.at(0).mx, 0.25, 1e-3);
}
