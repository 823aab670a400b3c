#include "core/data.h"
#include "core/input/synthetic_view.h"
#include "core/read_layer.h"

#include <burnish/input/camera_json.h>
#include <burnish/input/recover_camera.h>

#include <Imath/half.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <fstream>
#include <random>

using namespace burnish;

namespace {

const Window kFrame{0, 0, 320, 180};

void round_to_half(Image& image) {
    for (float& value : image.data) value = Imath::half(value);
}

void expect_same_camera(const Camera& found, const Camera& truth, float tolerance) {
    EXPECT_LT((found.centre - truth.centre).length(), tolerance);
    EXPECT_LT((found.axis - truth.axis).length(), tolerance);
    EXPECT_LT((found.right - truth.right).length(), tolerance);
    EXPECT_LT((found.up - truth.up).length(), tolerance);
}

Camera recovered(const Image& position, const Window& data, const Window& display) {
    std::string note;
    const auto camera = recover_camera(position, data, display, nullptr, note);
    if (!camera) throw std::runtime_error(note);
    return *camera;
}

std::string refusal(const Image& position) {
    std::string note;
    EXPECT_FALSE(recover_camera(position, kFrame, kFrame, nullptr, note)) << note;
    return note;
}

}  // namespace

TEST(RecoverCamera, FindsTheCameraThatMadeThePositions) {
    const Camera truth = camera_looking({4, -4.5f, 2.5f}, {0, 0, 1}, 0.6f, 16 / 9.0f);
    expect_same_camera(recovered(position_layer(truth, kFrame, kFrame, SyntheticScene::room_with_ball), kFrame, kFrame), truth,
                       2e-5f);
}

TEST(RecoverCamera, FindsLensShift) {
    const Camera truth = camera_looking({4, -4.5f, 2.5f}, {0, 0, 1}, 0.6f, 16 / 9.0f, 0.5f, -0.25f);
    expect_same_camera(recovered(position_layer(truth, kFrame, kFrame, SyntheticScene::room_with_ball), kFrame, kFrame), truth,
                       2e-5f);
}

TEST(RecoverCamera, UsesTheDisplayWindowWhenTheDataWindowIsAnother) {
    const Window data{-20, 30, 200, 100}, display{0, 0, 320, 180};
    const Camera truth = camera_looking({4, -4.5f, 2.5f}, {0, 0, 1}, 0.6f, 16 / 9.0f);
    expect_same_camera(recovered(position_layer(truth, data, display, SyntheticScene::room_with_ball), data, display), truth,
                       5e-5f);
}

TEST(RecoverCamera, NeedsNoMoreThanHalfFloatPositions) {
    const Camera truth = camera_looking({4, -4.5f, 2.5f}, {0, 0, 1}, 0.6f, 16 / 9.0f);
    Image position = position_layer(truth, kFrame, kFrame, SyntheticScene::room_with_ball);
    round_to_half(position);
    expect_same_camera(recovered(position, kFrame, kFrame), truth, 1e-3f);
}

TEST(RecoverCamera, IgnoresAFifthOfWrongPixels) {
    const Camera truth = camera_looking({4, -4.5f, 2.5f}, {0, 0, 1}, 0.6f, 16 / 9.0f);
    Image position = position_layer(truth, kFrame, kFrame, SyntheticScene::room_with_ball);
    std::mt19937 random(5);
    for (size_t i = 0; i < position.pixel_count(); ++i)
        if (random() % 5 == 0)
            for (int k = 0; k < 3; ++k) position.at(i)[k] = static_cast<float>(random() % 20000) / 1000 - 10;
    expect_same_camera(recovered(position, kFrame, kFrame), truth, 2e-5f);
}

TEST(RecoverCamera, IgnoresNansAndInfinities) {
    const Camera truth = camera_looking({4, -4.5f, 2.5f}, {0, 0, 1}, 0.6f, 16 / 9.0f);
    Image position = position_layer(truth, kFrame, kFrame, SyntheticScene::room_with_ball);
    const float wrong[] = {NAN, INFINITY, -INFINITY, 1e30f, 1e10f};
    for (size_t i = 0; i < position.pixel_count(); i += 37) position.at(i)[i % 3] = wrong[i % 5];
    expect_same_camera(recovered(position, kFrame, kFrame), truth, 2e-5f);
}

TEST(RecoverCamera, FindsTheCameraFromOneSmallObject) {
    const Camera truth = camera_looking({4, -4.5f, 2.5f}, {0, 0, 1}, 0.6f, 16 / 9.0f);
    const Image position = position_layer(truth, kFrame, kFrame, SyntheticScene::ball_only, 0.4);
    const Camera found = recovered(position, kFrame, kFrame);
    EXPECT_LT((found.centre - truth.centre).length(), 6e-3f * 6.3f);
    EXPECT_LT(largest_reprojection(found, position, kFrame, kFrame), 0.1f / 160) << "a tenth of a pixel";
}

TEST(RecoverCamera, FindsTheCameraWhereAFloorFillsMostOfTheFrame) {
    const Camera truth = camera_looking({4, -4.5f, 2.5f}, {0.3f, 0.5f, 0}, 0.35f, 16 / 9.0f);
    Image position = position_layer(truth, kFrame, kFrame, SyntheticScene::floor_only);
    const Image ball = position_layer(truth, kFrame, kFrame, SyntheticScene::ball_only, 0.5);
    size_t on_ball = 0;
    for (size_t i = 0; i < position.pixel_count(); ++i)
        if (ball.at(i)[2] != 0) std::copy_n(ball.at(i), 3, position.at(i)), ++on_ball;
    ASSERT_LT(on_ball, position.pixel_count() / 8);
    expect_same_camera(recovered(position, kFrame, kFrame), truth, 1e-4f);
}

TEST(RecoverCamera, HeedsTheValidityMask) {
    const Camera truth = camera_looking({4, -4.5f, 2.5f}, {0, 0, 1}, 0.6f, 16 / 9.0f);
    Image position = position_layer(truth, kFrame, kFrame, SyntheticScene::room_with_ball);
    Image valid(kFrame.width, kFrame.height, 1, 1.0f);
    for (int y = 0; y < kFrame.height; ++y)
        for (int x = 0; x < kFrame.width * 2 / 3; ++x) *valid.at(x, y) = 0, position.at(x, y)[0] += 3;
    std::string note;
    const auto found = recover_camera(position, kFrame, kFrame, &valid, note);
    ASSERT_TRUE(found) << note;
    expect_same_camera(*found, truth, 1e-3f);
}

TEST(RecoverCamera, RefusesPointsOnOnePlane) {
    const Camera truth = camera_looking({4, -4.5f, 2.5f}, {0, 0, 0}, 0.3f, 16 / 9.0f);
    Image position = position_layer(truth, kFrame, kFrame, SyntheticScene::floor_only);
    EXPECT_NE(refusal(position).find("one plane"), std::string::npos);
    round_to_half(position);
    EXPECT_NE(refusal(position).find("one plane"), std::string::npos);
}

TEST(RecoverCamera, RefusesASlantedPlaneWhoseHeightIsOnlyRoundingNoise) {
    const Camera truth = camera_looking({4, -4.5f, 2.5f}, {0, 0, 0}, 0.3f, 16 / 9.0f);
    Image position = position_layer(truth, kFrame, kFrame, SyntheticScene::floor_only);
    for (size_t i = 0; i < position.pixel_count(); ++i) {
        float* p = position.at(i);
        p[2] = 0.3f * p[0] - 0.7f * p[1] + 11;
    }
    refusal(position);
    round_to_half(position);
    refusal(position);
}

TEST(RecoverCamera, RefusesOrthographicViews) {
    Image position(kFrame.width, kFrame.height, 3);
    for (int y = 0; y < kFrame.height; ++y)
        for (int x = 0; x < kFrame.width; ++x) {
            const float u = static_cast<float>(x) * 0.01f, v = static_cast<float>(y) * 0.01f;
            float* p = position.at(x, y);
            p[0] = 1 + u, p[1] = std::sin(3 * u) + std::cos(2 * v), p[2] = 2 - v;
        }
    EXPECT_NE(refusal(position).find("orthographic"), std::string::npos);
    round_to_half(position);
    refusal(position);
}

TEST(RecoverCamera, RefusesWhatNoPerspectiveCameraSees) {
    Image noise(kFrame.width, kFrame.height, 3);
    std::mt19937 random(1);
    for (float& value : noise.data) value = static_cast<float>(random() % 1000) / 100 + 0.1f;
    refusal(noise);
    EXPECT_NE(refusal(Image(kFrame.width, kFrame.height, 3)).find("too few"), std::string::npos);
}

TEST(RecoverCamera, AgreesWithTheCamerasOfRealRenders) {
    if (!data_path("cycles/spheres/spheres.exr")) GTEST_SKIP() << "no test data; set BURNISH_DATA";
    for (const char* name : {"spheres/spheres", "room/room", "room/mirror", "room/cube_px", "room/cube_nz"}) {
        const std::string stem = data_path("cycles")->string() + "/" + name;
        const Image position =
            read_layer(stem + ".exr", {"ViewLayer.Position.X", "ViewLayer.Position.Y", "ViewLayer.Position.Z"});
        const Window window{0, 0, position.width, position.height};
        const auto json = nlohmann::json::parse(std::ifstream(stem + ".json"));
        const Camera truth = camera_from_json(json["camera"], name, static_cast<float>(window.width) / window.height);
        const Camera found = recovered(position, window, window);
        SCOPED_TRACE(name);
        EXPECT_LT((found.centre - truth.centre).length(), 1e-5f * 10) << "of a scene about 10 units large";
        EXPECT_LT((found.axis - truth.axis).length(), 1e-5f);
        EXPECT_LT((found.right - truth.right).length(), 1e-5f);
        EXPECT_LT((found.up - truth.up).length(), 1e-5f);
    }
}

TEST(RecoverCamera, RefusesACeilingWithAPanelWhoseHeightIsLostInHalfFloat) {
    const auto file = data_path("cycles/room/cube_pz.exr");
    if (!file) GTEST_SKIP() << "no test data; set BURNISH_DATA";
    Image position = read_layer(*file, {"ViewLayer.Position.X", "ViewLayer.Position.Y", "ViewLayer.Position.Z"});
    const Window window{0, 0, position.width, position.height};
    std::string note;
    EXPECT_TRUE(recover_camera(position, window, window, nullptr, note)) << "with 32 bits the panel is enough: " << note;
    round_to_half(position);
    EXPECT_FALSE(recover_camera(position, window, window, nullptr, note)) << "its centre would be off by 3 %: " << note;
}

TEST(RecoverCamera, RefusesPanoramas) {
    const auto file = data_path("cycles/room/equirect.exr");
    if (!file) GTEST_SKIP() << "no test data; set BURNISH_DATA";
    const Image position = read_layer(*file, {"ViewLayer.Position.X", "ViewLayer.Position.Y", "ViewLayer.Position.Z"});
    const Window window{0, 0, position.width, position.height};
    std::string note;
    EXPECT_FALSE(recover_camera(position, window, window, nullptr, note)) << note;
}

TEST(RecoverCamera, TakesLittleTimeOnALargeFrame) {
    const Window large{0, 0, 1920, 1080};
    const Camera truth = camera_looking({4, -4.5f, 2.5f}, {0, 0, 1}, 0.6f, 16 / 9.0f);
    const Image position = position_layer(truth, large, large, SyntheticScene::room_with_ball);
    double best_ms = 1e9;
    for (int repeat = 0; repeat < 5; ++repeat) {
        const auto start = std::chrono::steady_clock::now();
        recovered(position, large, large);
        best_ms =
            std::min(best_ms, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    RecordProperty("milliseconds", std::to_string(best_ms));
#ifdef __OPTIMIZE__
    EXPECT_LT(best_ms, 60) << "20 ms wanted; three times that on a busy machine";
#endif
}
