// What `burnish info` says about a frame.
#include <burnish/input/info.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace burnish {
namespace {

AovFrame frame_with(std::initializer_list<Role> roles) {
    AovFrame frame;
    frame.file = "shot.exr";
    frame.data_window = frame.display_window = {0, 0, 2, 2};
    for (const Role role : roles) frame.layers[role] = Image(2, 2, role_info(role).channels);
    return frame;
}

std::vector<std::string> missing_for(const AovFrame& frame, const std::string& job) {
    for (const Possibility& possibility : possibilities(frame))
        if (possibility.name == job) return possibility.missing;
    ADD_FAILURE() << "no job " << job;
    return {};
}

using Strings = std::vector<std::string>;

TEST(Info, ListsWhatIsMissingForEachJob) {
    AovFrame frame = frame_with({Role::normal});
    EXPECT_EQ(missing_for(frame, "add"), (Strings{"position", "camera"}));
    EXPECT_EQ(missing_for(frame, "difference"), (Strings{"position", "camera", "beauty"}));
    EXPECT_EQ(missing_for(frame, "cryptomatte"), (Strings{"a cryptomatte"}));
    frame = frame_with({Role::normal, Role::position, Role::beauty, Role::tangent, Role::material_id});
    frame.camera = Camera{};
    for (const char* job : {"add", "difference", "objects", "anisotropy"}) EXPECT_TRUE(missing_for(frame, job).empty()) << job;
    EXPECT_EQ(missing_for(frame, "replace"), (Strings{"specular_direct or specular_indirect"}));
}

TEST(Info, AsksForTheSpecularColourWhereTheRendererDividesByIt) {
    AovFrame frame = frame_with({Role::normal, Role::position, Role::beauty, Role::specular_direct});
    frame.camera = Camera{};
    EXPECT_TRUE(missing_for(frame, "replace").empty());
    frame.divided_by_albedo = true;
    EXPECT_EQ(missing_for(frame, "replace"), (Strings{"specular_albedo"}));
}

TEST(Info, SaysTheSameToPeopleAndMachines) {
    AovFrame frame = frame_with({Role::normal, Role::beauty});
    frame.notes = {"normal: N (XYZ, float)"};
    frame.warnings = {"something odd"};
    const std::string text = describe(frame);
    for (const char* part :
         {"shot.exr", "2x2 at 0,0", "normal: N (XYZ, float)", "warning: something odd", "needs position, camera"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    const nlohmann::json json = describe_json(frame);
    EXPECT_EQ(json["roles"], (Strings{"beauty", "normal"}));
    EXPECT_EQ(json["notes"], frame.notes);
    EXPECT_EQ(json["warnings"], frame.warnings);
    EXPECT_EQ(json["jobs"]["add"]["missing"], (Strings{"position", "camera"}));
    EXPECT_FALSE(json["jobs"]["add"]["possible"]);
    EXPECT_TRUE(json["camera"].is_null());
}

TEST(Info, WritesJsonWhateverBytesTheNamesHave) {
    AovFrame frame = frame_with({});
    frame.notes = {"layer \xff\xfe"};
    EXPECT_NO_THROW(describe_json(frame).dump());
}

}  // namespace
}  // namespace burnish
