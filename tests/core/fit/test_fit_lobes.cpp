#include <burnish/base/parallel.h>
#include <burnish/fit/search/fit_lobes.h>
#include <burnish/fit/search/lobe_space.h>
#include <burnish/fit/search/transfer_samples.h>
#include <burnish/material/albedo.h>
#include <burnish/material/library.h>
#include <burnish/material/model.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "synthetic_table.h"

namespace burnish::testing {
namespace {

const GonioGrid kGrid{{0, 5, 35, 65}, {0, 45, 90}, 5};
const Faults kFaults{0.02f, 3e-4f, 10};

Material scattergloss(bool second_lobe) {
    Material material;
    material.kd = Color3f(0.05f);
    material.lobes = {kurt_lobe(0.9f, 0.11f, 0.07f, 0.87f, 0.45f)};
    if (second_lobe) material.lobes.push_back(kurt_lobe(0.12f, 0.3f, 0.2f, 0.89f, 0.6f));
    return material;
}

FitSettings kurt_settings(int max_lobes = 2) {
    FitSettings settings;
    settings.model = ModelId::kurt;
    settings.max_lobes = max_lobes;
    return settings;
}

FitResult fit(const Material& material, const FitSettings& settings, const Faults& faults = kFaults) {
    return fit_lobes(measure_grey(material, kGrid, faults), false, settings, {});
}

void expect_near_ratio(float found, float known, float tolerance, const char* what) {
    EXPECT_NEAR(found / known, 1, tolerance) << what;
}

void expect_lobe(const LobeParameters& found, const LobeParameters& known, float tolerance) {
    expect_near_ratio(found.mx, known.mx, tolerance, "mx");
    expect_near_ratio(found.my, known.my, tolerance, "my");
    expect_near_ratio(found.strength * found.fresnel.eta.x, known.strength * known.fresnel.eta.x, tolerance, "ks r0");
    EXPECT_NEAR(found.extra[0], known.extra[0], 0.02f) << "alpha";
}

bool has_note(const FitResult& result, const std::string& words) {
    return std::ranges::any_of(result.notes, [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

TEST(FitLobes, GivesOneLobeWhereThereIsOne) {
    const Material known = scattergloss(false);
    const FitResult result = fit(known, kurt_settings());
    ASSERT_EQ(result.material.lobes.size(), 1u);
    expect_lobe(result.material.lobes[0], known.lobes[0], 0.02f);
    expect_near_ratio(result.material.kd.x, known.kd.x, 0.02f, "kd");
    const Vec3f wo = direction(35, 20);
    expect_near_ratio(directional_albedo(result.material.lobes[0], wo).x, directional_albedo(known.lobes[0], wo).x, 0.01f,
                      "albedo");
    EXPECT_EQ(result.parameters, 6);
    EXPECT_TRUE(has_note(result, "does not pay"));
}

TEST(FitLobes, GivesTwoLobesWhereThereAreTwo) {
    const Material known = scattergloss(true);
    const FitResult result = fit(known, kurt_settings(3), {});
    ASSERT_EQ(result.material.lobes.size(), 2u);
    for (int n : {0, 1}) {
        expect_lobe(result.material.lobes[n], known.lobes[n], 0.01f);
        expect_near_ratio(result.material.lobes[n].fresnel.eta.x, known.lobes[n].fresnel.eta.x, 0.01f, "r0");
    }
    const FitResult noisy = fit(known, kurt_settings(3));
    ASSERT_EQ(noisy.material.lobes.size(), 2u);
    for (int n : {0, 1}) expect_lobe(noisy.material.lobes[n], known.lobes[n], 0.02f);
}

TEST(FitLobes, SaysWhichNumbersTheTableHardlyTells) {
    Faults faults = kFaults;
    faults.ratio = 0.1f;
    EXPECT_TRUE(has_note(fit(scattergloss(false), kurt_settings(1), faults), "r0"));
    EXPECT_FALSE(has_note(fit(scattergloss(false), kurt_settings(1), {}), "hardly"));
}

TEST(FitLobes, KeepsBoundsAndFixedNumbers) {
    FitSettings settings = kurt_settings();
    settings.fixed_lobes = true;
    settings.bounds = {
        {"alpha", {0.3, 0.3}}, {"2.mx", {0.4, 0.5}}, {"2.my", {0.4, 0.5}}, {"r0", {0.5, 0.6}}, {"kd", {0.07, 0.07}}};
    const FitResult result = fit(scattergloss(true), settings);
    ASSERT_EQ(result.material.lobes.size(), 2u);
    EXPECT_EQ(result.material.kd.x, 0.07f);
    EXPECT_EQ(result.parameters, 8);
    for (const LobeParameters& lobe : result.material.lobes) {
        EXPECT_EQ(lobe.extra[0], 0.3f);
        EXPECT_GE(lobe.fresnel.eta.x, 0.5f - 1e-6f);
        EXPECT_LE(lobe.fresnel.eta.x, 0.6f + 1e-6f);
    }
    EXPECT_GE(result.material.lobes[1].mx, 0.4f - 1e-6f);
    EXPECT_LT(result.material.lobes[0].mx, 0.2f);
}

TEST(FitLobes, RefusesBoundsThatCannotBe) {
    for (const ParameterBounds& bounds : {ParameterBounds{{"alhpa", {0, 1}}}, {{"alpha", {0.5, 0.2}}}, {{"mx", {0.1, 2}}}}) {
        FitSettings settings = kurt_settings();
        settings.bounds = bounds;
        EXPECT_THROW(fit(scattergloss(false), settings), Error);
    }
    EXPECT_THROW(fit_lobes(std::span<const BrdfSample>(), true, kurt_settings(), {}), Error);
}

TEST(FitLobes, TurnsTheFrameWhereBoundsFreeIt) {
    Material known = scattergloss(false);
    known.lobes[0].rotation = 30 * kPi / 180;
    FitSettings settings = kurt_settings(1);
    settings.bounds = {{"rotation_deg", {0, 80}}};
    std::vector<BrdfSample> samples = measure_grey(scattergloss(false), kGrid, {});
    for (BrdfSample& sample : samples)
        for (Vec3f* w : {&sample.wo, &sample.wi})
            *w = Frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}.turned(known.lobes[0].rotation).to_world(*w);
    const FitResult result = fit_lobes(samples, false, settings, {});
    EXPECT_NEAR(result.material.lobes.at(0).rotation * 180 / kPi, 30, 0.5);
    expect_lobe(result.material.lobes.at(0), known.lobes[0], 0.02f);
}

TEST(FitLobes, FindsTransmissionUnderTheSurface) {
    Material known;
    known.kd = Color3f(0.5f);
    known.lobes = {kurt_lobe(0.8f, 0.1f, 0.1f, 0.06f, 0.4f), through(kurt_lobe(0.67f, 0.2f, 0.2f, 0.3f, 0.5f))};
    const GonioGrid grid{{0, 10, 30, 50, 70}, {0}, 5, true};
    const FitResult result = fit_lobes(measure_grey(known, grid, {0.02f}), true, kurt_settings(), {});
    ASSERT_EQ(result.material.lobes.size(), 2u);
    EXPECT_EQ(result.material.lobes[1].side, Side::transmission);
    EXPECT_TRUE(result.material.lobes[1].fresnel.complement);
    expect_near_ratio(result.material.lobes[1].mx, 0.2f, 0.02f, "m");
    EXPECT_EQ(result.material.lobes[1].mx, result.material.lobes[1].my);
    expect_near_ratio(result.material.lobes[1].strength * (1 - result.material.lobes[1].fresnel.eta.x), 0.67f * 0.7f, 0.02f,
                      "kt (1 - r0)");
    EXPECT_TRUE(has_note(result, "kt (1 - r0)"));
}

TEST(FitLobes, TintsLobes) {
    Material known = scattergloss(false);
    known.kd = {0.2f, 0.1f, 0.05f};
    known.lobes[0].tint = {1.2f, 1.0f, 0.8f};
    const FitResult result = fit_lobes(measure(known, kGrid, {0.02f}), false, kurt_settings(1), {});
    for (int c = 0; c < 3; ++c) {
        expect_near_ratio(result.material.kd[c], known.kd[c], 0.02f, "kd");
        expect_near_ratio(result.material.lobes[0].tint[c], known.lobes[0].tint[c], 0.02f, "tint");
    }
}

TEST(FitLobes, RecognisesWhatNoModelDoes) {
    std::vector<BrdfSample> samples = measure_grey(scattergloss(false), kGrid, {0.02f});
    for (BrdfSample& sample : samples) sample.wo = {-sample.wo.x, -sample.wo.y, sample.wo.z};
    EXPECT_TRUE(has_note(fit_lobes(samples, false, kurt_settings(1), {}), "reflects back towards the light"));
    EXPECT_FALSE(has_note(fit(scattergloss(false), kurt_settings(1)), "reflects back"));
}

TEST(FitLobes, IsTheSameForAnyNumberOfThreads) {
    const auto as_text = [&](int threads) {
        const ThreadLimit limit(threads);
        return material_to_json(fit(scattergloss(true), kurt_settings()).material).dump();
    };
    EXPECT_EQ(as_text(1), as_text(4));
}

TEST(FitLobes, StopsWhenAsked) {
    int reports = 0;
    const Progress progress([&](const std::string&, float) { return ++reports < 20; });
    try {
        fit_lobes(measure_grey(scattergloss(true), kGrid, {}), false, kurt_settings(), progress);
        FAIL() << "went on";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::cancelled);
    }
    EXPECT_EQ(reports, 20);
}

/// Every model is fitted by the same machinery: a table of one of its lobes is met.
class FitModel : public ::testing::TestWithParam<ModelId> {};

/// All but the one that shows a measurement and the one that is fitted by slices (slice_fit.h).
std::vector<ModelId> searched_models() {
    std::vector<ModelId> ids;
    for (size_t i = 0; i < models().size(); ++i)
        if (models()[i].name != "table" && models()[i].name != "sgd") ids.push_back(static_cast<ModelId>(i));
    return ids;
}

TEST_P(FitModel, MeetsATableOfItsOwn) {
    const ModelId model = GetParam();
    const LobeSpace space = lobe_space(model, Side::reflection, 1, true, {});
    std::vector<double> units;
    for (size_t i = 0; i < space.shape.size(); ++i) units.push_back(0.62 - 0.07 * static_cast<double>(i));
    Material known;
    known.kd = Color3f(0.1f);
    known.lobes = {space.at(units)};
    known.lobes[0].strength = 0.7f;
    if (space.has_fresnel) known.lobes[0].fresnel.eta = Color3f(0.3f);
    const std::vector<BrdfSample> samples = measure_grey(known, {{0, 20, 40, 60, 75}, {0}, 5}, {});
    FitSettings settings;
    settings.model = model;
    settings.max_lobes = 1;
    const FitResult result = fit_lobes(samples, true, settings, {});
    double light = 0;
    for (const IncidentAlbedo& incident : measured_albedo(samples, Side::reflection))
        light += incident.albedo.x / (2 * kPi) / 5;
    EXPECT_LT(result.l1, 0.01 * light) << material_to_json(known).dump() << " became "
                                       << material_to_json(result.material).dump();
}

INSTANTIATE_TEST_SUITE_P(All, FitModel, ::testing::ValuesIn(searched_models()), [](const auto& info) {
    std::string name(model_info(info.param).name);
    std::ranges::replace(name, '-', '_');
    return name;
});

}  // namespace
}  // namespace burnish::testing
