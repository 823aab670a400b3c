// The error model: its table, what lies between its entries, and whether it has the order of configurations right.
#include <burnish/plan/error_model.h>

#include "core/room_light.h"
#include "core/scenes.h"

#include <burnish/error_table_json.h>
#include <burnish/plan/truth.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace burnish;

namespace {

LobeParameters ggx(float mx, float my) { return scenes::lobe_of(ModelId::ggx, mx, my); }

/// That the table has for lobe `entry`.
LobeParameters lobe_of(const nlohmann::json& entry) {
    const float half = std::sqrt(entry.at("aspect").get<float>()), m = entry.at("m").get<float>();
    return scenes::lobe_of(entry.at("tail") == "long" ? ModelId::ggx : ModelId::beckmann, m * half, m / half);
}

}  // namespace

TEST(ErrorModel, GivesTheTablesOwnEntriesBack) {
    const nlohmann::json table = nlohmann::json::parse(kErrorTableJson);
    const size_t count = table.at("configurations").size();
    ASSERT_LE(count, configurations().size());
    for (const nlohmann::json& entry : table.at("lobes"))
        for (size_t i = 0; i < count; ++i) {
            const PredictedGain gain = predicted_gain(lobe_of(entry), configurations()[i]);
            EXPECT_NEAR(gain.mean, entry.at("gain")[i].get<float>(), 1e-3) << entry << i;
            EXPECT_NEAR(gain.deviation, entry.at("deviation")[i].get<float>(), 1e-3) << entry << i;
        }
}

TEST(ErrorModel, TheProbeGainsNothingOverItself) {
    for (const float m : {0.003f, 0.03f, 0.3f, 1.0f})
        for (const float aspect : {1.0f, 2.0f, 30.0f}) {
            const PredictedGain gain = predicted_gain(ggx(m, m / aspect), kProbe);
            EXPECT_EQ(gain.mean, 0);
            EXPECT_EQ(gain.deviation, 0);
        }
}

TEST(ErrorModel, BetweenEntriesGainsLieBetweenTheirs) {
    const Configuration most{EstimatorKind::fitted, 12};
    const float low = predicted_gain(ggx(0.05f, 0.05f), most).mean, high = predicted_gain(ggx(0.1f, 0.1f), most).mean;
    const float half = predicted_gain(ggx(std::sqrt(0.005f), std::sqrt(0.005f)), most).mean;
    EXPECT_NEAR(half, (low + high) / 2, 1e-3);
    EXPECT_EQ(predicted_gain(ggx(0.001f, 0.001f), most).mean, predicted_gain(ggx(0.005f, 0.005f), most).mean);
}

TEST(ErrorModel, MeansTheSameWhicheverWayALobeIsLong) {
    const Configuration fits{EstimatorKind::fitted, 6};
    EXPECT_EQ(predicted_gain(ggx(0.3f, 0.05f), fits).mean, predicted_gain(ggx(0.05f, 0.3f), fits).mean);
}

TEST(ErrorModel, MoreSafetyKeepsMore) {
    float last = 0;
    for (const float safety : {0.1f, 0.25f, 0.4f, 0.7f, 1.0f, 1.7f, 2.0f, 3.0f, 4.0f}) {
        EXPECT_GE(predicted_sparse(safety).mean, last);
        last = predicted_sparse(safety).mean;
    }
}

/// Under a light that the table was not made from: configurations that it holds 6 dB apart have that order.
TEST(ErrorModel, HasTheOrderOfMeasuredErrors) {
    const AovFrame frame = scenes::sphere_frame(32);
    const Assignment assignment = scenes::whole_frame(frame);
    const Surfaces surfaces(frame, assignment, {});
    EnvironmentSettings lit;
    lit.face_size = 64;
    const Environment light = Environment::from_image(scenes::room_light(7, 128), lit, "room");
    const LobeParameters lobe = ggx(0.2f, 0.2f);
    const Material material{"test", Color3f(0, 0, 0), {lobe}};
    EstimatorSettings exact;
    exact.kind = EstimatorKind::reference, exact.tolerance = 0.02f;
    const MaterialShader one(material, light, with({}, kProbe)), other(material, light, other_probe({}));
    const Truth truth(surfaces, check_sample(surfaces, assignment, 0, 120, {one, other}),
                      MaterialShader(material, light, exact));
    using enum EstimatorKind;
    const Configuration chosen[] = {
        {fitted, 1}, {fitted, 6}, {regular, 19}, {filtered_importance, 16}, {filtered_importance, 256}};
    const auto measured = [&](const Configuration& c) {
        return truth.closeness(MaterialShader(material, light, with({}, c))).psnr_db;
    };
    int compared = 0;
    for (const Configuration& a : chosen)
        for (const Configuration& b : chosen) {
            if (predicted_gain(lobe, a).mean < predicted_gain(lobe, b).mean + 6) continue;
            EXPECT_GT(measured(a), measured(b)) << a.samples << " over " << b.samples;
            ++compared;
        }
    EXPECT_GE(compared, 2);
}
