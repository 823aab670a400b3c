#include "core/data.h"
#include "core/input/synthetic_view.h"

#include <burnish/input/header_camera.h>
#include <burnish/input/metadata_spec.h>

#include <gtest/gtest.h>

using namespace burnish;

namespace {

const Window kFrame{0, 0, 320, 180};
constexpr float kAspect = 16 / 9.0f;

/// Rows right, up, forward, centre: camera (left-handed, +Z forward) to world, row vectors.
Matrix44f camera_to_world(const Camera& camera, float up_sign = 1, float forward_sign = 1) {
    const Vec3f r = camera.right.normalized(), u = camera.up.normalized() * up_sign, f = camera.forward() * forward_sign;
    const Vec3f& c = camera.centre;
    return {r.x, r.y, r.z, 0, u.x, u.y, u.z, 0, f.x, f.y, f.z, 0, c.x, c.y, c.z, 1};
}

/// V-Ray's axes: right, backward, down.
Matrix44f vray_matrix(const Camera& camera) {
    const Vec3f r = camera.right.normalized(), b = -camera.forward(), d = -camera.up.normalized(), &c = camera.centre;
    return {r.x, r.y, r.z, 0, b.x, b.y, b.z, 0, d.x, d.y, d.z, 0, c.x, c.y, c.z, 1};
}

const Camera kTruth = camera_looking({4, -4.5f, 2.5f}, {0, 0, 1}, 0.6f, kAspect);
const double kFov = 360 / M_PI * std::atan(0.6);

void expect_camera(const std::optional<Camera>& found, const Camera& truth, float tolerance) {
    ASSERT_TRUE(found);
    EXPECT_LT((found->centre - truth.centre).length(), tolerance);
    EXPECT_LT((found->axis - truth.axis).length(), tolerance);
    EXPECT_LT((found->right - truth.right).length(), tolerance);
    EXPECT_LT((found->up - truth.up).length(), tolerance);
    EXPECT_EQ(found->source, "header");
}

Metadata header_of(const std::string& file) {
    const auto input = OIIO::ImageInput::open(file);
    if (!input) throw std::runtime_error(file + " does not open");
    return {input->spec()};
}

}  // namespace

TEST(HeaderCamera, ReadsEveryConventionWhenPositionsConfirmIt) {
    const Image position = position_layer(kTruth, kFrame, kFrame, SyntheticScene::room_with_ball);
    const std::pair<Matrix44f, bool> headers[] = {
        {camera_to_world(kTruth).inverse(), false},         // the standard
        {camera_to_world(kTruth, 1, -1).inverse(), false},  // Clarisse
        {vray_matrix(kTruth), true},                        // V-Ray
        {vray_matrix(kTruth), false},                       // V-Ray after other tools dropped its attributes
        {camera_to_world(kTruth, 1, -1), false},            // camera to world under the standard name
    };
    for (const auto& [matrix, vray] : headers)
        for (const std::optional<double> fov : {std::optional<double>(), std::optional(kFov)}) {
            std::string note;
            expect_camera(header_camera({matrix, vray, fov}, &position, nullptr, kFrame, kFrame, 1, note), kTruth, 2e-5f);
            EXPECT_NE(note.find("fits"), std::string::npos) << note;
        }
}

TEST(HeaderCamera, TakesLensShiftFromPositions) {
    const Camera truth = camera_looking({4, -4.5f, 2.5f}, {0, 0, 1}, 0.6f, kAspect, 0.4f, -0.2f);
    const Image position = position_layer(truth, kFrame, kFrame, SyntheticScene::room_with_ball);
    std::string note;
    expect_camera(header_camera({camera_to_world(truth).inverse(), false, {}}, &position, nullptr, kFrame, kFrame, 1, note),
                  truth, 2e-5f);
}

TEST(HeaderCamera, SeesAPlaneThatAloneWouldNotDetermineACamera) {
    const Camera truth = camera_looking({4, -4.5f, 2.5f}, {0, 0, 0}, 0.3f, kAspect);
    const Image position = position_layer(truth, kFrame, kFrame, SyntheticScene::floor_only);
    std::string note;
    expect_camera(header_camera({camera_to_world(truth).inverse(), false, {}}, &position, nullptr, kFrame, kFrame, 1, note),
                  truth, 2e-5f);
}

TEST(HeaderCamera, IsRefusedWhenPositionsContradictIt) {
    const Image position = position_layer(kTruth, kFrame, kFrame, SyntheticScene::room_with_ball);
    Camera moved = kTruth;
    moved.centre.x += 0.2f;
    std::string note;
    EXPECT_FALSE(header_camera({camera_to_world(moved).inverse(), false, {}}, &position, nullptr, kFrame, kFrame, 1, note));
    EXPECT_NE(note.find("does not fit"), std::string::npos) << note;
    const CameraHeader wrong_lens{camera_to_world(kTruth).inverse(), false, 30.0};
    EXPECT_FALSE(header_camera(wrong_lens, &position, nullptr, kFrame, kFrame, 1, note));
    EXPECT_NE(note.find("angle of view"), std::string::npos) << note;
}

TEST(HeaderCamera, IsTrustedWithAWordOfCautionWhenThereIsNoPosition) {
    std::string note;
    const CameraHeader header{camera_to_world(kTruth).inverse(), false, kFov};
    expect_camera(header_camera(header, nullptr, nullptr, kFrame, kFrame, 1, note), kTruth, 1e-5f);
    EXPECT_NE(note.find("not checked"), std::string::npos);
    const Image nothing(kFrame.width, kFrame.height, 3);
    expect_camera(header_camera(header, &nothing, nullptr, kFrame, kFrame, 1, note), kTruth, 1e-5f);
    EXPECT_NE(note.find("too few pixels"), std::string::npos);
    const auto blind = header_camera({header.matrix, false, {}}, nullptr, nullptr, kFrame, kFrame, 1, note);
    ASSERT_TRUE(blind);
    EXPECT_FALSE(blind->has_rays);
}

TEST(HeaderCamera, RefusesMatricesThatAreNoCamera) {
    Matrix44f projection = camera_to_world(kTruth).inverse();
    projection[2][3] = 1;
    Matrix44f sheared;
    sheared[0][1] = 0.3f;
    Matrix44f broken;
    broken[1][1] = NAN;
    for (const Matrix44f& matrix : {Matrix44f(0.0f), projection, sheared, broken}) {
        std::string note;
        EXPECT_FALSE(header_camera({matrix, false, {}}, nullptr, nullptr, kFrame, kFrame, 1, note));
        EXPECT_FALSE(note.empty());
    }
    std::string note = "old";
    EXPECT_FALSE(header_camera({}, nullptr, nullptr, kFrame, kFrame, 1, note));
    EXPECT_TRUE(note.empty());
}

TEST(HeaderCamera, ReadsTheHeadersOfRealRenderers) {
    const auto folder = data_path("public/exr_aov");
    if (!folder) GTEST_SKIP() << "no test data; set BURNISH_DATA";
    struct Expected {
        const char* file;
        bool vray;
        double fov_x_deg;  // 0: the header has none
        Vec3f centre, forward;
    };
    // Centres and directions worked out by hand from the matrices that oiiotool --info -v prints.
    const Expected files[] = {
        {"arnoldCombinedID.exr", false, 50, {0, 0, 2.18629f}, {0, 0, -1}},
        {"sidecar_manifest.exr", false, 54.4322, {0.289258f, 16.76036f, 18.43356f}, {-0.0193734f, -0.609292f, -0.792709f}},
        {"cornellBox_CryptoWildcard.0001.exr", true, 54.4322, {0, 5, 20}, {0, 0, -1}},
        {"clarisse_two_crypto.exr", false, 0, {-0.696655f, 9.75317f, 110.083f}, {0, 0, -1}},
        {"karma_cpu_solaris_one_crypto.exr", false, 0, {-23.8625f, 20.2083f, 21.3808f}, {0.612652f, -0.558692f, -0.559036f}},
    };
    for (const Expected& expected : files) {
        SCOPED_TRACE(expected.file);
        const CameraHeader header = camera_header(header_of((*folder / expected.file).string()));
        EXPECT_EQ(header.vray, expected.vray);
        EXPECT_NEAR(header.fov_x_deg.value_or(0), expected.fov_x_deg, 1e-3);
        std::string note;
        const auto camera = header_camera(header, nullptr, nullptr, kFrame, kFrame, 1, note);
        ASSERT_TRUE(camera) << note;
        EXPECT_LT((camera->centre - expected.centre).length(), 1e-3f) << camera->centre;
        EXPECT_LT((camera->forward() - expected.forward).length(), 1e-4f) << camera->forward();
    }
}
