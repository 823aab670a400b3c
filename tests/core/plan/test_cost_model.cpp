// The cost model's arithmetic, and the file that its constants are kept in. Times themselves are nothing to assert.
#include <burnish/plan/cost_model.h>

#include "core/scenes.h"
#include "core/scratch.h"

#include <burnish/base/error.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace burnish;

namespace {

using enum EstimatorKind;

Material round_lobe(ModelId model = ModelId::ggx) { return {"test", Color3f(0, 0, 0), {scenes::lobe_of(model, 0.1f, 0.1f)}}; }

const CostCase kFrame{.pixels = 100000, .frame_pixels = 400000, .face_texels = 6 * 256 * 256};

double seconds(const Configuration& configuration, float safety = 0, const CostCase& of = kFrame,
               const Material& material = round_lobe()) {
    return predicted_seconds(shipped_costs(), material, configuration, safety, of);
}

CostCase with_filtered_light(CostCase of) {
    of.has_pyramid = of.has_stack = true;
    return of;
}

std::string message_of(const nlohmann::json& document) {
    try {
        costs_from_json(document, "costs.json");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(CostModel, MoreLookupsCostMore) {
    for (size_t i = 1; i < configurations().size(); ++i) {
        const Configuration &less = configurations()[i - 1], &more = configurations()[i];
        if (less.estimator != more.estimator) continue;
        EXPECT_LT(seconds(less), seconds(more)) << i;
    }
}

TEST(CostModel, DenseShadingIsInProportionToPixels) {
    CostCase none = kFrame, twice = kFrame;
    none.pixels = 0, twice.pixels *= 2;
    const double once = seconds(kProbe, 0, none);
    EXPECT_NEAR(seconds(kProbe, 0, twice) - once, 2 * (seconds(kProbe) - once), 1e-12);
}

TEST(CostModel, LightThatIsFilteredCostsNothing) {
    const double texels = static_cast<double>(kFrame.face_texels);
    EXPECT_NEAR(seconds(kProbe) - seconds(kProbe, 0, with_filtered_light(kFrame)), texels * shipped_costs().pyramid_texel,
                1e-12);
    EXPECT_NEAR(seconds({fitted, 4}) - seconds({fitted, 4}, 0, with_filtered_light(kFrame)),
                texels * shipped_costs().stack_texel, 1e-12);
}

TEST(CostModel, FramesShareLightAndTables) {
    CostCase shot = kFrame;
    shot.frames = 10;
    const PredictedCost one = predicted_cost(shipped_costs(), round_lobe(), {fitted, 6}, 0, kFrame);
    const PredictedCost shared = predicted_cost(shipped_costs(), round_lobe(), {fitted, 6}, 0, shot);
    EXPECT_NEAR(shared.light, one.light / 10, 1e-12);
    EXPECT_NEAR(shared.tables, one.tables / 10, 1e-12);
    EXPECT_EQ(shared.shading, one.shading);
}

TEST(CostModel, SparseShadingReadsTheStackAndPaysOffOnLargeFrames) {
    EXPECT_GT(predicted_cost(shipped_costs(), round_lobe(), kProbe, 1, kFrame).light,
              predicted_cost(shipped_costs(), round_lobe(), kProbe, 0, kFrame).light);
    CostCase shot = with_filtered_light(kFrame);
    shot.frames = 100;
    EXPECT_LT(seconds({filtered_importance, 512}, 1, shot), seconds({filtered_importance, 512}, 0, shot));
    EXPECT_LT(seconds(kProbe, 0.5f, shot), seconds(kProbe, 4, shot));
}

TEST(CostModel, SharesGrowWithSafetyUpToAll) {
    EXPECT_LT(sparse_share(0.5f), sparse_share(1));
    EXPECT_DOUBLE_EQ(sparse_share(1, 0.2), 0.2);
    EXPECT_EQ(sparse_share(100), 1);
}

TEST(CostModel, LobesAreAddedUp) {
    const Material one = round_lobe();
    Material two = one;
    two.lobes.push_back(one.lobes[0]);
    const CostCase ready = with_filtered_light(kFrame);
    EXPECT_NEAR(seconds(kProbe, 0, ready, two), 2 * seconds(kProbe, 0, ready, one), 1e-12);
}

TEST(CostModel, DearModelsHaveDearTables) {
    MachineCosts machine = shipped_costs();
    machine.evaluation["ggx"] = 1e-8, machine.evaluation["beckmann"] = 4e-8;
    const auto tables = [&](ModelId model) { return predicted_cost(machine, round_lobe(model), kProbe, 0, kFrame).tables; };
    EXPECT_GT(tables(ModelId::beckmann), tables(ModelId::ggx));
    EXPECT_GT(tables(ModelId::table), tables(ModelId::beckmann));
}

TEST(CostModel, SunsAndNearLightsHaveTheirPrice) {
    CostCase sunny = kFrame, near = kFrame;
    sunny.suns = 2, near.is_near = true;
    EXPECT_NEAR(seconds(kProbe, 0, sunny) - seconds(kProbe), 2 * 100000 * shipped_costs().sun, 1e-12);
    const double rays = predicted_cost(shipped_costs(), round_lobe(), kProbe, 0, near).shading;
    EXPECT_NEAR(rays, 100000 * (shipped_costs().pixel + 19 * shipped_costs().near_ray), 1e-9);
}

TEST(MachineCosts, ComeBackFromTheirFile) {
    const nlohmann::json written = costs_to_json(shipped_costs());
    EXPECT_EQ(costs_to_json(costs_from_json(written, "costs.json")), written);
}

TEST(MachineCosts, ABrokenFileIsNamedWithFieldAndRemedy) {
    nlohmann::json broken = costs_to_json(shipped_costs());
    broken["nanoseconds"]["pixel"] = -1;
    EXPECT_NE(message_of(broken).find("costs.json.nanoseconds.pixel: expected a number from 0"), std::string::npos);
    EXPECT_NE(message_of(broken).find("run burnish calibrate again"), std::string::npos);
    broken = costs_to_json(shipped_costs());
    broken["nanoseconds"].erase("lookup");
    EXPECT_NE(message_of(broken).find("\"lookup\" is missing"), std::string::npos);
    broken = costs_to_json(shipped_costs());
    broken["nanosecond"] = 1;
    EXPECT_NE(message_of(broken).find("unknown field \"nanosecond\""), std::string::npos);
    broken = costs_to_json(shipped_costs());
    broken["cores"] = 0;
    EXPECT_NE(message_of(broken).find("costs.json.cores"), std::string::npos);
    EXPECT_NE(message_of(nlohmann::json::array()).find("run burnish calibrate again"), std::string::npos);
}
