// One frame, written with the names of each renderer: every role must be found, and mean what that renderer means.
#include <burnish/base/error.h>
#include <burnish/input/exr_reader.h>

#include <core/input/synthetic_frame.h>
#include <core/scratch.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace burnish {
namespace {

const std::vector<std::string> kRgba = {"R", "G", "B", "A"};

/// Position and normal come back exactly, the camera is recovered, and the normal faces it.
void expect_geometry(const AovFrame& frame) {
    ASSERT_TRUE(frame.has(Role::position) && frame.has(Role::normal));
    EXPECT_EQ(frame.layer(Role::position).data, scene().position.data);
    EXPECT_EQ(frame.layer(Role::normal).data, scene().normal.data);
    ASSERT_TRUE(frame.camera);
    EXPECT_LT((frame.camera->centre - scene().camera.centre).length(), 1e-3f);
}

/// The role is filled with the constant its layer was written with.
void expect_value(const AovFrame& frame, Role role, float value) {
    ASSERT_TRUE(frame.has(role)) << role_info(role).name;
    EXPECT_EQ(*frame.layer(role).at(10, 10), value) << role_info(role).name;
}

AovFrame round_trip(const std::vector<SyntheticPart>& parts) {
    const Scratch scratch;
    return read_frame(write_synthetic(scratch.file("frame.exr"), parts), {});
}

TEST(RendererNames, OfCyclesAreUnderstood) {
    SyntheticPart part{{{{"View Layer.Combined.R", "View Layer.Combined.G", "View Layer.Combined.B", "View Layer.Combined.A"},
                         scene().beauty,
                         OIIO::TypeHalf},
                        {{"View Layer.Denoising Normal.X", "View Layer.Denoising Normal.Y", "View Layer.Denoising Normal.Z"},
                         scene().constant(0.5f)},
                        {xyz("View Layer.Normal"), scene().normal},
                        {xyz("View Layer.Position"), scene().position},
                        {{"View Layer.Depth.Z"}, scene().depth},
                        {rgb("View Layer.GlossDir"), scene().constant(1)},
                        {rgb("View Layer.GlossInd"), scene().constant(2)},
                        {rgb("View Layer.GlossCol"), scene().constant(3)},
                        {rgb("View Layer.DiffDir"), scene().constant(4)},
                        {rgb("View Layer.DiffInd"), scene().constant(5)},
                        {rgb("View Layer.DiffCol"), scene().constant(6)},
                        {{"View Layer.IndexOB.X"}, scene().constant(7, 1)},
                        {{"View Layer.Roughness.X"}, scene().constant(0.5f, 1)}}};
    part.attributes = {{"cycles.View Layer.samples", "128"}};
    const AovFrame frame = round_trip({part});
    EXPECT_EQ(frame.renderer, Renderer::cycles);
    EXPECT_TRUE(frame.divided_by_albedo);
    expect_geometry(frame);
    const std::vector<Role> filled = {Role::specular_direct, Role::specular_indirect, Role::specular_albedo,
                                      Role::diffuse_direct,  Role::diffuse_indirect,  Role::diffuse_albedo,
                                      Role::object_id};
    for (size_t i = 0; i < filled.size(); ++i) expect_value(frame, filled[i], static_cast<float>(i + 1));
    expect_value(frame, Role::roughness, 0.5f);
    EXPECT_EQ(frame.layer(Role::depth).data, scene().depth.data);
    EXPECT_TRUE(frame.warnings.empty()) << frame.warnings.front();
}

TEST(RendererNames, OfArnoldAreUnderstoodWithSpecularAsDirectAndIndirectTogether) {
    SyntheticPart part{{{kRgba, scene().beauty, OIIO::TypeHalf},
                        {rgb("P"), scene().position},
                        {rgb("N"), scene().normal},
                        {{"Z"}, scene().depth},
                        {rgb("specular"), scene().constant(1)},
                        {rgb("specular_indirect"), scene().constant(2)},
                        {rgb("diffuse_albedo"), scene().constant(3)}}};
    part.attributes = {{"arnold/version", "Arnold 7.4"}};
    part.tile = 64;
    const AovFrame frame = round_trip({part});
    EXPECT_EQ(frame.renderer, Renderer::arnold);
    EXPECT_FALSE(frame.divided_by_albedo);
    expect_geometry(frame);
    expect_value(frame, Role::specular_direct, 1);
    EXPECT_FALSE(frame.has(Role::specular_indirect)) << "would be counted twice";
    expect_value(frame, Role::diffuse_albedo, 3);
}

TEST(RendererNames, OfArnoldPreferTheSeparatePassesToTheSum) {
    SyntheticPart part{{{rgb("specular"), scene().constant(1)},
                        {rgb("specular_direct"), scene().constant(2)},
                        {rgb("specular_indirect"), scene().constant(3)}}};
    part.attributes = {{"arnold/version", "Arnold 7.4"}};
    const AovFrame frame = round_trip({part});
    expect_value(frame, Role::specular_direct, 2);
    expect_value(frame, Role::specular_indirect, 3);
}

TEST(RendererNames, OfVRayAreUnderstoodWithSpecularAsDirectOnly) {
    SyntheticPart part{{{kRgba, scene().beauty, OIIO::TypeHalf},
                        {xyz("vrayRE_WorldPosition"), scene().position},
                        {xyz("normals"), scene().normal},
                        {rgb("lighting"), scene().constant(1)},
                        {rgb("GI"), scene().constant(2)},
                        {rgb("diffuse"), scene().constant(3)},
                        {rgb("specular"), scene().constant(4)},
                        {rgb("reflect"), scene().constant(5)},
                        {rgb("reflectionGlossiness"), scene().constant(0.75f)}}};
    part.attributes = {{"vrayInfo/camera", "RENDER_CAM"}};
    const AovFrame frame = round_trip({part});
    EXPECT_EQ(frame.renderer, Renderer::vray);
    expect_geometry(frame);
    const std::vector<Role> filled = {Role::diffuse_direct, Role::diffuse_indirect, Role::diffuse_albedo, Role::specular_direct,
                                      Role::specular_indirect};
    for (size_t i = 0; i < filled.size(); ++i) expect_value(frame, filled[i], static_cast<float>(i + 1));
    expect_value(frame, Role::roughness, 0.25f);
}

TEST(RendererNames, OfRenderManPreferWorldSpace) {
    SyntheticPart part{{{kRgba, scene().beauty, OIIO::TypeHalf},
                        {rgb("P"), scene().in_camera_space(scene().position)},
                        {rgb("Nn"), scene().in_camera_space(scene().normal)},
                        {rgb("__Pworld"), scene().position},
                        {rgb("__Nworld"), scene().normal},
                        {rgb("directSpecular"), scene().constant(1)},
                        {rgb("indirectSpecular"), scene().constant(2)},
                        {rgb("directDiffuse"), scene().constant(3)},
                        {rgb("indirectDiffuse"), scene().constant(4)},
                        {rgb("albedo"), scene().constant(5)}}};
    const AovFrame frame = round_trip({part});
    EXPECT_EQ(frame.renderer, Renderer::renderman);
    expect_geometry(frame);
    const std::vector<Role> filled = {Role::specular_direct, Role::specular_indirect, Role::diffuse_direct,
                                      Role::diffuse_indirect, Role::diffuse_albedo};
    for (size_t i = 0; i < filled.size(); ++i) expect_value(frame, filled[i], static_cast<float>(i + 1));
}

TEST(RendererNames, OfRenderManWarnWhenOnlyCameraSpaceIsThere) {
    SyntheticPart part{{{rgb("P"), scene().in_camera_space(scene().position)}, {rgb("directSpecular"), scene().constant(1)}}};
    const AovFrame frame = round_trip({part});
    ASSERT_FALSE(frame.warnings.empty());
    EXPECT_NE(frame.warnings.front().find("camera space"), std::string::npos) << frame.warnings.front();
}

TEST(RendererNames, OfKarmaAreUnderstood) {
    const AovFrame frame = round_trip({{{{rgb("C"), scene().constant(9)},
                                         {xyz("P"), scene().position},
                                         {xyz("N"), scene().normal},
                                         {{"depth"}, scene().depth},
                                         {rgb("directglossyreflection"), scene().constant(1)},
                                         {rgb("indirectglossyreflection"), scene().constant(2)},
                                         {rgb("directdiffuse"), scene().constant(3)},
                                         {rgb("indirectdiffuse"), scene().constant(4)}}}});
    EXPECT_EQ(frame.renderer, Renderer::karma);
    expect_geometry(frame);
    expect_value(frame, Role::beauty, 9);
    expect_value(frame, Role::specular_direct, 1);
    expect_value(frame, Role::specular_indirect, 2);
    expect_value(frame, Role::diffuse_direct, 3);
    expect_value(frame, Role::diffuse_indirect, 4);
    EXPECT_EQ(frame.layer(Role::depth).data, scene().depth.data);
}

TEST(RendererNames, OfMitsubaAreUnderstoodWithDepthAlongTheRay) {
    SyntheticPart part{{{{"R", "G", "B"}, scene().constant(9)},
                        {xyz("position"), scene().position},
                        {xyz("sh_normal"), scene().normal},
                        {{"depth.T"}, scene().distance},
                        {rgb("albedo"), scene().constant(1)},
                        {{"shape_index.I"}, scene().constant(3, 1)}}};
    part.attributes = {{"generatedBy", "Mitsuba version 3.5.0"}};
    const AovFrame frame = round_trip({part});
    EXPECT_EQ(frame.renderer, Renderer::mitsuba);
    expect_geometry(frame);
    expect_value(frame, Role::diffuse_albedo, 1);
    expect_value(frame, Role::object_id, 3);
    const auto says_ray = [](const std::string& note) { return note.find("depth: length of the ray") == 0; };
    EXPECT_TRUE(std::any_of(frame.notes.begin(), frame.notes.end(), says_ray));
}

TEST(RendererNames, GiveWayToWhatTheUserNames) {
    const Scratch scratch;
    const std::string file = write_synthetic(scratch.file("frame.exr"), {{{{xyz("Normal"), scene().normal},
                                                                           {xyz("bumped.Normal"), scene().constant(0.57735f)},
                                                                           {rgb("masks"), scene().constant(0.25f)}}}});
    ReadOptions options;
    options.channels = {{Role::normal, "bumped.Normal"}, {Role::roughness, "masks.G"}};
    const AovFrame frame = read_frame(file, options);
    expect_value(frame, Role::normal, 0.57735f);
    expect_value(frame, Role::roughness, 0.25f);
    options.channels = {{Role::normal, "Nrml"}};
    try {
        read_frame(file, options);
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::missing_channel);
        EXPECT_NE(std::string(error.what()).find("bumped.Normal"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace burnish
