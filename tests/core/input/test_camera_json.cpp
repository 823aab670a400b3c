#include <burnish/base/error.h>
#include <burnish/input/camera_json.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace burnish;
using nlohmann::json;

namespace {

Camera parse(const char* text, float aspect = 2) { return camera_from_json(json::parse(text), "shot.json: camera", aspect); }

/// The message of the error that `text` gives, or "" when there is none.
std::string complaint(const char* text) {
    try {
        parse(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_argument);
        return error.what();
    }
    return {};
}

void expect_near(const Vec3f& found, const Vec3f& expected) {
    EXPECT_LT((found - expected).length(), 1e-6f) << found << " instead of " << expected;
}

}  // namespace

TEST(CameraJson, LooksFromPositionToTarget) {
    const Camera camera = parse(R"({"position": [1, -10, 2], "look_at": [1, 0, 2], "up": [0, 0, 1], "fov_x_deg": 90})");
    expect_near(camera.centre, {1, -10, 2});
    expect_near(camera.axis, {0, 1, 0});
    expect_near(camera.right, {1, 0, 0});
    expect_near(camera.up, {0, 0, 0.5f});
    EXPECT_TRUE(camera.has_rays);
    EXPECT_EQ(camera.source, "json");
}

TEST(CameraJson, ReadsTheMatrixBlenderWrites) {
    const Camera camera =
        parse(R"({"matrix_world": [[1,0,0,5],[0,0,-1,6],[0,1,0,7],[0,0,0,1]], "fov_x_deg": 90, "type": "PERSP",
                                    "lens_mm": 18, "sensor_width_mm": 36, "clip_start": 0.1, "clip_end": 100})");
    expect_near(camera.centre, {5, 6, 7});
    expect_near(camera.axis, {0, 1, 0});
    expect_near(camera.right, {1, 0, 0});
    expect_near(camera.up, {0, 0, 0.5f});
}

TEST(CameraJson, IgnoresTheScaleOfACameraObject) {
    const Camera camera = parse(R"({"matrix_world": [[3,0,0,0],[0,3,0,0],[0,0,3,0],[0,0,0,1]], "fov_x_deg": 90})");
    expect_near(camera.axis, {0, 0, -1});
    expect_near(camera.right, {1, 0, 0});
}

TEST(CameraJson, ShiftsByWidthsOfTheFittedSide) {
    const char* const identity = R"({"matrix_world": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]], "fov_x_deg": 90,
                                     "shift": [0.1, 0.2], "sensor_fit": "%s"})";
    char text[300];
    for (const char* fit : {"HORIZONTAL", "AUTO"}) {  // width 2 at depth 1
        std::snprintf(text, sizeof(text), identity, fit);
        expect_near(parse(text).axis, {0.2f, 0.4f, -1});
    }
    std::snprintf(text, sizeof(text), identity, "VERTICAL");  // height 1 at depth 1
    expect_near(parse(text).axis, {0.1f, 0.2f, -1});
    std::snprintf(text, sizeof(text), identity, "AUTO");  // a tall image is fitted by its height, here 4
    expect_near(parse(text, 0.5f).axis, {0.4f, 0.8f, -1});
}

TEST(CameraJson, TakesTheVerticalAngleOrBoth) {
    const char* const vertical = R"({"position": [0,0,0], "look_at": [0,0,-1], "up": [0,1,0], "fov_y_deg": 90})";
    expect_near(parse(vertical).right, {2, 0, 0});
    EXPECT_EQ(complaint(R"({"position": [0,0,0], "look_at": [0,0,-1], "up": [0,1,0], "fov_x_deg": 90, "fov_y_deg": 53.13})"),
              "");
    EXPECT_NE(complaint(R"({"position": [0,0,0], "look_at": [0,0,-1], "up": [0,1,0], "fov_x_deg": 90, "fov_y_deg": 90})")
                  .find("aspect"),
              std::string::npos);
}

TEST(CameraJson, IsContentWithAPosition) {
    const Camera camera = parse(R"({"position": [1, 2, 3]})");
    expect_near(camera.centre, {1, 2, 3});
    EXPECT_FALSE(camera.has_rays);
}

TEST(CameraJson, NamesTheFieldThatIsWrong) {
    const std::pair<const char*, const char*> cases[] = {
        {R"([1, 2])", "shot.json: camera: expected an object"},
        {R"({})", "camera: needs position"},
        {R"({"position": [1, 2]})", "camera.position: expected a list of 3 numbers"},
        {R"({"position": [1, 2, "3"]})", "camera.position: expected a list of 3 numbers"},
        {R"({"position": [1, 2, 1e300]})", "camera.position: expected a list of 3 numbers"},
        {R"({"position": [1, 2, 3], "fov_x_deg": 40})", "camera.look_at: missing"},
        {R"({"position": [0,0,0], "look_at": [0,0,0], "up": [0,1,0], "fov_x_deg": 40})", "camera.look_at: is the same point"},
        {R"({"position": [0,0,0], "look_at": [0,3,0], "up": [0,1,0], "fov_x_deg": 40})", "camera.up: is parallel"},
        {R"({"position": [0,0,0], "look_at": [0,0,3], "fov_x_deg": 40})", "camera.up: missing"},
        {R"({"position": [0,0,0], "look_at": [0,0,3], "up": [0,1,0]})", "camera.fov_x_deg: missing"},
        {R"({"position": [0,0,0], "look_at": [0,0,3], "up": [0,1,0], "fov_x_deg": 180})",
         "camera.fov_x_deg: expected a number from"},
        {R"({"position": [0,0,0], "fov_x": 40})", "unknown field \"fov_x\" (did you mean \"fov\"?)"},
        {R"({"matrix_world": [[1,0,0,0],[0,1,0,0],[0,0,1,0]], "fov_x_deg": 40})", "camera.matrix_world: expected 4 rows"},
        {R"({"matrix_world": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[1,2,3,1]], "fov_x_deg": 40})", "last column"},
        {R"({"matrix_world": [[1,0.5,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]], "fov_x_deg": 40})", "not perpendicular"},
        {R"({"matrix_world": [[0,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]], "fov_x_deg": 40})", "is zero"},
        {R"({"position": [0,0,0], "matrix_world": [], "fov_x_deg": 40})", "both \"position\" and \"matrix_world\""},
        {R"({"position": [0,0,0], "type": "ORTHO"})", "camera.type: unknown name \"ORTHO\"; known: PERSP"},
        {R"({"position": [0,0,0], "look_at": [0,0,3], "up": [0,1,0], "fov_x_deg": 40, "shift": [0,0], "sensor_fit": 3})",
         "camera.sensor_fit"},
    };
    for (const auto& [text, expected] : cases) EXPECT_NE(complaint(text).find(expected), std::string::npos) << complaint(text);
}
