// Reading frames: windows, parts, views, candidates that fail their check, and real renders.
#include <burnish/base/error.h>
#include <burnish/input/exr_file.h>
#include <burnish/input/exr_reader.h>

#include <core/data.h>
#include <core/input/synthetic_frame.h>
#include <core/read_layer.h>
#include <core/scratch.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace burnish {
namespace {

AovFrame round_trip(const std::vector<SyntheticPart>& parts, const ReadOptions& options = {}) {
    const Scratch scratch;
    return read_frame(write_synthetic(scratch.file("frame.exr"), parts), options);
}

bool says(const std::vector<std::string>& lines, const std::string& text) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(text) != std::string::npos; });
}

std::string message_of(const std::function<void()>& work, ErrorCode code) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "nothing was thrown";
    return "";
}

Image negated(const Image& image) {
    return SyntheticFrame::mapped(image, [](const Vec3f& v) { return -v; });
}

TEST(ExrReader, KeepsANegativeDataWindow) {
    SyntheticPart part{{{{"R", "G", "B"}, scene().beauty}}};
    Image ramp(7, 5, 3);
    for (size_t i = 0; i < ramp.data.size(); ++i) ramp.data[i] = static_cast<float>(i);
    part.layers[0].image = ramp;
    part.data = {-3, -2, 7, 5}, part.display = {0, 0, 4, 3};
    for (const int tile : {0, 4}) {
        part.tile = tile;
        const AovFrame frame = round_trip({part});
        EXPECT_EQ(frame.data_window, part.data);
        EXPECT_EQ(frame.display_window, part.display);
        EXPECT_EQ(frame.layer(Role::beauty).data, ramp.data) << "tile " << tile;
    }
}

TEST(ExrReader, FitsPartsOfOtherWindowsIntoTheBeautyWindow) {
    SyntheticPart beauty{{{{"R", "G", "B"}, Image(6, 4, 3, 1.0f)}}, "rgba"}, depth{{{{"Z"}, Image(4, 4, 1, 5.0f)}}, "depth"};
    beauty.data = {0, 0, 6, 4}, depth.data = {3, 1, 4, 4};
    beauty.display = depth.display = {0, 0, 8, 8};
    const AovFrame frame = round_trip({beauty, depth});
    EXPECT_EQ(frame.data_window, beauty.data);
    const Image& layer = frame.layer(Role::depth);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 6; ++x) EXPECT_EQ(*layer.at(x, y), x >= 3 && y >= 1 ? 5.0f : 0.0f) << x << "," << y;
    EXPECT_TRUE(says(frame.notes, "another data window"));
}

TEST(ExrReader, ReadsPartsNamedAfterTheirLayers) {
    const AovFrame frame = round_trip({{{{{"R", "G", "B"}, scene().constant(2)}}, "rgba"},
                                       {{{{"R", "G", "B"}, scene().normal}}, "N"},
                                       {{{{"R", "G", "B"}, scene().position}}, "P"}});
    EXPECT_EQ(frame.layer(Role::normal).data, scene().normal.data);
    EXPECT_EQ(frame.layer(Role::position).data, scene().position.data);
}

TEST(ExrReader, ReadsTheViewThatIsAskedFor) {
    SyntheticPart right{{{{"R", "G", "B"}, scene().constant(1)}}, "rgba_right", "right"};
    SyntheticPart left{{{{"R", "G", "B"}, scene().constant(2)}}, "rgba_left", "left"};
    ReadOptions options;
    EXPECT_EQ(round_trip({right, left}).layer(Role::beauty).data[0], 1.0f);
    options.view = "left";
    EXPECT_EQ(round_trip({right, left}, options).layer(Role::beauty).data[0], 2.0f);
    options.view = "middle";
    EXPECT_NE(message_of(
                  [&] {
                      round_trip({right, left}, options);
                  },
                  ErrorCode::bad_argument)
                  .find("right, left"),
              std::string::npos);
}

TEST(ExrReader, ReadsWholeNumbersAsTheyAre) {
    Image ids(5, 1, 1);
    ids.data = {0, 1, 2, 300, 70000};
    const AovFrame frame = round_trip({{{{{"R", "G", "B"}, Image(5, 1, 3, 0.5f)}, {{"id"}, ids, OIIO::TypeUInt32}}}});
    EXPECT_EQ(frame.layer(Role::object_id).data, ids.data);
    EXPECT_EQ(frame.layer(Role::beauty).data[0], 0.5f);
}

TEST(ExrReader, DecodesEncodedNormals) {
    const Image encoded = SyntheticFrame::mapped(scene().normal, [](const Vec3f& n) { return (n + Vec3f(1.0f)) * 0.5f; });
    const AovFrame frame = round_trip({{{{xyz("Normal"), encoded}, {xyz("Position"), scene().position}}}});
    for (size_t i = 0; i < encoded.data.size(); ++i)
        ASSERT_NEAR(frame.layer(Role::normal).data[i], scene().normal.data[i], 1e-6f);
    EXPECT_TRUE(says(frame.notes, "decoded as 2n - 1"));
    EXPECT_TRUE(says(frame.notes, "facing the camera on 100.0 %"));
}

TEST(ExrReader, SaysWhenNormalsAreFlipped) {
    const AovFrame frame = round_trip({{{{xyz("Normal"), negated(scene().normal)}, {xyz("Position"), scene().position}}}});
    EXPECT_EQ(frame.layer(Role::normal).data, negated(scene().normal).data) << "never changed silently";
    EXPECT_TRUE(says(frame.warnings, "points away from the camera on 100.0 %"));
}

TEST(ExrReader, WarnsOfCameraSpaceNormals) {
    const Image turned = scene().in_camera_space(scene().normal);
    const AovFrame frame = round_trip({{{{xyz("Normal"), turned}, {xyz("Position"), scene().position}}}});
    EXPECT_EQ(frame.layer(Role::normal).data, turned.data);
    EXPECT_TRUE(says(frame.warnings, "may be in camera space"));
}

TEST(ExrReader, PassesOverNormalsThatFaceAwayForOnesThatDoNot) {
    const AovFrame frame = round_trip({{{{xyz("Normal"), scene().in_camera_space(scene().normal)},
                                         {xyz("BumpNormals"), scene().normal},
                                         {xyz("Position"), scene().position}}}});
    EXPECT_EQ(frame.layer(Role::normal).data, scene().normal.data);
    EXPECT_TRUE(says(frame.notes, "passed over"));
    EXPECT_TRUE(frame.warnings.empty());
}

TEST(ExrReader, PassesOverLayersThatAreNotWhatTheyAreCalled) {
    Image black(96, 54, 3);
    const AovFrame frame = round_trip(
        {{{{xyz("Normal"), black}, {xyz("N"), scene().normal}, {xyz("Position"), black}, {xyz("Pworld"), scene().position}}}});
    EXPECT_EQ(frame.layer(Role::normal).data, scene().normal.data);
    EXPECT_EQ(frame.layer(Role::position).data, scene().position.data);
    EXPECT_TRUE(says(frame.notes, "normal: Normal is zero everywhere, passed over"));
}

TEST(ExrReader, LeavesOutARoleThatNoLayerFillsHonestly) {
    const AovFrame frame = round_trip({{{{rgb("Normal"), scene().constant(0.3f)}}}});
    EXPECT_FALSE(frame.has(Role::normal));
    EXPECT_TRUE(says(frame.warnings, "--channel normal=NAME"));
    const std::string message = message_of([&] { frame.layer(Role::normal); }, ErrorCode::missing_channel);
    for (const char* part : {"frame.exr", "no normal layer", "shnormal", "the file has Normal.RGB", "--channel normal=NAME"})
        EXPECT_NE(message.find(part), std::string::npos) << part << " in " << message;
}

TEST(ExrReader, ScrubsColourAndKeepsData) {
    Image colour = scene().constant(1), normal = scene().normal;
    colour.at(3, 3)[1] = kInfinity, colour.at(4, 3)[0] = kNaN;
    normal.at(3, 3)[1] = kNaN;
    const AovFrame frame = round_trip({{{{{"R", "G", "B"}, colour}, {xyz("Normal"), normal}}}});
    EXPECT_EQ(frame.layer(Role::beauty).at(3, 3)[1], 0.0f);
    EXPECT_EQ(frame.layer(Role::beauty).at(3, 3)[0], 1.0f);
    EXPECT_TRUE(std::isnan(frame.layer(Role::normal).at(3, 3)[1]));
    EXPECT_TRUE(says(frame.warnings, "beauty: 2 pixels are not finite"));
}

TEST(ExrReader, WarnsOfHalfPositionsWithTheirStep) {
    const AovFrame frame = round_trip({{{{xyz("Position"), scene().position, OIIO::TypeHalf}}}});
    EXPECT_TRUE(says(frame.warnings, "half floats, in steps of 0.00"));
}

TEST(ExrReader, MakesPositionFromDepthAndTheGivenCamera) {
    ReadOptions options;
    options.camera = [](const AovFrame&) { return scene().camera; };
    options.roles = {Role::position, Role::normal};
    const AovFrame frame = round_trip({{{{{"depth.Z"}, scene().depth}, {xyz("Normal"), scene().normal}}}}, options);
    for (size_t i = 0; i < scene().position.data.size(); ++i)
        ASSERT_NEAR(frame.layer(Role::position).data[i], scene().position.data[i], 1e-4f);
    EXPECT_TRUE(says(frame.notes, "facing the camera on 100.0 %"));
}

TEST(ExrReader, DoesNotUseADepthThatIsNoDistance) {
    const Image scaled = [] {
        Image layer = scene().depth;
        for (float& value : layer.data) value = std::min(value / 10, 1.0f);
        return layer;
    }();
    const AovFrame frame = round_trip({{{{xyz("Position"), scene().position}, {{"depth.Z"}, scaled}}}});
    EXPECT_FALSE(frame.has(Role::depth));
    EXPECT_TRUE(says(frame.notes, "neither planar nor ray length"));
}

TEST(ExrReader, ReadsOnlyTheRolesAskedFor) {
    const Scratch scratch;
    const std::string file = write_synthetic(
        scratch.file("frame.exr"), {{{{{"R", "G", "B"}, scene().constant(1)}}, "rgba"}, {{{xyz("N"), scene().normal}}, "N"}});
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - 100);  // the normals are cut off
    ReadOptions options;
    options.roles = {Role::beauty};
    const AovFrame frame = read_frame(file, options);
    EXPECT_EQ(frame.layers.size(), 1u);
    EXPECT_FALSE(message_of([&] { read_frame(file, {}); }, ErrorCode::read_failed).empty());
}

TEST(ExrReader, ReadsTheSameValuesForAnySetOfChannels) {
    Image ramp(130, 75, 6);
    for (size_t i = 0; i < ramp.data.size(); ++i) ramp.data[i] = static_cast<float>(i % 2048);
    SyntheticPart part{{{{"a.R", "a.G", "a.B", "b.X", "b.Y", "b.Z"}, ramp}}};
    for (const std::string compression : {"none", "rle", "zips", "zip", "piz", "pxr24"}) {
        for (const int tile : {0, 16, 50}) {
            part.compression = compression, part.tile = tile;
            const Scratch scratch;
            const ExrFile file(write_synthetic(scratch.file("frame.exr"), {part}), "");
            Image red(130, 75, 1), blue_and_y(130, 75, 2);
            const auto channel = [&](const char* layer, const char* component) {
                return *file.find_layer(layer)->find(component);
            };
            file.read({{channel("b", "y"), &blue_and_y, 1}, {channel("a", "r"), &red, 0}, {channel("a", "b"), &blue_and_y, 0}},
                      {0, 0, 130, 75});
            for (size_t i = 0; i < ramp.pixel_count(); ++i) {
                ASSERT_EQ(red.data[i], ramp.at(i)[0]) << compression << " tile " << tile << " pixel " << i;
                ASSERT_EQ(blue_and_y.at(i)[0], ramp.at(i)[2]);
                ASSERT_EQ(blue_and_y.at(i)[1], ramp.at(i)[4]);
            }
        }
    }
}

TEST(ExrReader, FindsEveryRoleOfACyclesRender) {
    const auto file = data_path("cycles/spheres/spheres.exr");
    if (!file) GTEST_SKIP() << "no test data: set BURNISH_DATA";
    const AovFrame frame = read_frame(file->string(), {});
    for (const Role role : {Role::beauty, Role::alpha, Role::position, Role::normal, Role::depth, Role::tangent, Role::uv,
                            Role::roughness, Role::object_id, Role::material_id, Role::diffuse_direct, Role::diffuse_indirect,
                            Role::diffuse_albedo, Role::specular_direct, Role::specular_indirect, Role::specular_albedo})
        EXPECT_TRUE(frame.has(role)) << role_info(role).name;
    EXPECT_EQ(frame.layers.size(), 16u);
    EXPECT_TRUE(frame.warnings.empty());
    for (const auto& [role, layer] : {std::pair{Role::position, "Position"}, {Role::normal, "Normal"}})
        EXPECT_EQ(frame.layer(role).data, read_layer(*file, xyz(std::string("ViewLayer.") + layer)).data);
    EXPECT_EQ(frame.layer(Role::specular_direct).data, read_layer(*file, rgb("ViewLayer.GlossDir")).data);
    EXPECT_TRUE(says(frame.notes, "position: ViewLayer.Position (XYZ, float)"));
    EXPECT_TRUE(says(frame.notes, "specular_direct: ViewLayer.GlossDir (RGB, half)"));
    EXPECT_TRUE(says(frame.notes, "facing the camera on 100.0 %"));
    EXPECT_TRUE(says(frame.notes, "depth: planar"));
    ASSERT_TRUE(frame.camera);  // the scene's camera stands at (0, -10.5, 1)
    EXPECT_LT((frame.camera->centre - Vec3f(0, -10.5f, 1)).length(), 1e-4f);
}

TEST(ExrReader, ReadsTheCryptomattesOfARealRender) {
    const auto file = data_path("public/exr_aov/karma_cpu_solaris_one_crypto.exr");
    if (!file) GTEST_SKIP() << "no test data: set BURNISH_DATA";
    ReadOptions options;
    options.roles = {Role::beauty};
    options.cryptomattes = true;
    const AovFrame frame = read_frame(file->string(), options);
    ASSERT_EQ(frame.cryptomattes.size(), 1u);
    EXPECT_EQ(frame.cryptomattes[0].name, "CryptoObject");
    EXPECT_EQ(frame.cryptomattes[0].ranks.size(), 6u);
    EXPECT_EQ(frame.cryptomattes[0].manifest.size(), 3u);
}

}  // namespace
}  // namespace burnish
