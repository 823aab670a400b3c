// The floor of the room that Cycles rendered, in its mirrored render.
#include "core/data.h"
#include "core/light/cycles_floor.h"
#include "core/scenes.h"

#include <gtest/gtest.h>

using namespace burnish_test;

namespace {

double floor_psnr(const CyclesFloor& room, EstimatorKind kind, int samples, const LightChain& lights) {
    LobeParameters lobe = scenes::lobe_of(ModelId::ggx, 0.02f, 0.02f);
    lobe.tint = Color3f(0.5f);
    EstimatorSettings settings;
    settings.kind = kind, settings.samples = samples;
    return room.psnr(room.shaded({"floor", Color3f(0), {lobe}}, settings, lights), room.glossy);
}

}  // namespace

TEST(MirrorLight, ShowsTheFloorThatCyclesRendered) {
    const auto folder = data_path("cycles/room");
    if (!folder) GTEST_SKIP() << "no data";
    const CyclesFloor room(*folder, 3);
    const LightChain lights = room.chain(true);
    EXPECT_GT(floor_psnr(room, EstimatorKind::fitted, 0, lights), 34);
    EXPECT_GT(floor_psnr(room, EstimatorKind::regular, 0, lights), 34);
    const LightChain cube({lights.links()[1]});
    EXPECT_LT(floor_psnr(room, EstimatorKind::fitted, 0, cube), 20) << "no cube map knows the whole floor";
}
