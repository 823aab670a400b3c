// Lights as JSON: what goes in comes out, defaults are left out, and what cannot be meant is named with its path.
#include <burnish/base/error.h>
#include <burnish/light/light_json.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

using namespace burnish;
using nlohmann::json;

namespace {

json cube_map() { return {{"type", "cubemap"}, {"file", "vase.exr"}, {"centre", {1, 2, 3}}}; }

json with(json light, const char* field, const json& value) {
    light[field] = value;
    return light;
}

std::string message_of(const json& light) {
    try {
        light_from_json(light, "s.json: lights.it");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_argument);
        return error.what();
    }
    return "no error";
}

void expect_round_trip(const json& light) { EXPECT_EQ(light_to_json(light_from_json(light, "light")), light) << light; }

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const json kPlane = {{"point", {0, 0, 1}}, {"normal", {0, 0, 2}}};
const json kCorners = {{0, 0, 3}, {0, 1, 3}, {1, 1, 3}, {1, 0, 3}};

}  // namespace

TEST(LightJson, CubeMapsSurvive) {
    expect_round_trip(cube_map());
    json full = {{"depth", "depth.exr"}, {"convention", "openexr"}, {"distances", "ray"}, {"up", "z"},
                 {"rotate", 90},         {"proxy", "depth"},        {"scale", 2},         {"tint", {1, 0.5, 0.25}},
                 {"space", "ACEScg"},    {"blocks", false}};
    full.update(cube_map());
    expect_round_trip(full);
    expect_round_trip(with(cube_map(), "proxy", {{"mesh", "room.glb"}}));
    expect_round_trip(with(cube_map(), "proxy", {{"planes", {kPlane, kPlane}}}));
    const json box = {{"centre", {0, 0, 1}}, {"half", {3, 4, 1.5}}, {"x", {0, 1, 0}}, {"y", {1, 0, 0}}, {"z", {0, 0, 1}}};
    expect_round_trip(with(cube_map(), "proxy", {{"box", box}}));
}

TEST(LightJson, TheOthersSurvive) {
    const json mirror = {{"type", "mirror"}, {"file", "floor.####.exr"}, {"plane", kPlane}};
    expect_round_trip(mirror);
    expect_round_trip(with(with(mirror, "behind", true), "second_step", false));
    expect_round_trip(with(mirror, "camera", {{"position", {0, 0, 1}}}));
    expect_round_trip(with(mirror, "camera", "camera.json"));
    const json area = {{"type", "area"}, {"corners", kCorners}, {"radiance", 12}};
    expect_round_trip(area);
    expect_round_trip(with(with(with(area, "texture", "lamp.exr"), "two_sided", true), "blocks", true));
    const json traced = {{"type", "traced"}, {"scene", "room.glb"}};
    expect_round_trip(traced);
    expect_round_trip(with(with(with(with(traced, "radiance", "r.exr"), "irradiance", "e.exr"), "albedo", "a.exr"), "up", "y"));
    expect_round_trip(with(with(traced, "rays", 16), "texcoord", 1));
}

TEST(LightJson, ReadsEveryField) {
    const auto map = std::get<CubeMapSettings>(
        light_from_json(with(with(cube_map(), "rotate", 30), "proxy", {{"box", {{"min", {-3, -4, 0}}, {"max", {3, 4, 3}}}}}),
                        "")
            .kind);
    EXPECT_EQ(map.centre, Vec3f(1, 2, 3));
    EXPECT_EQ(map.picture.rotate_deg, 30.0f);
    EXPECT_EQ(map.proxy.kind, ProxyKind::box);
    EXPECT_EQ(map.proxy.box.centre, Vec3f(0, 0, 1.5f));
    EXPECT_EQ(map.proxy.box.half, Vec3f(3, 4, 1.5f));
    const json mirror = {{"type", "mirror"}, {"file", "floor.exr"}, {"plane", kPlane}, {"second_step", false}};
    const auto floor = std::get<MirrorSettings>(light_from_json(mirror, "").kind);
    EXPECT_EQ(floor.plane.normal, Vec3f(0, 0, 2));
    EXPECT_FALSE(floor.second_step || floor.behind);
    const json lamp = {{"type", "area"}, {"corners", kCorners}, {"radiance", {1, 2, 3}}, {"tint", 0.5}};
    const LightSettings area = light_from_json(lamp, "");
    EXPECT_EQ(std::get<AreaSettings>(area.kind).corners[1], Vec3f(0, 1, 3));
    EXPECT_EQ(std::get<AreaSettings>(area.kind).radiance, Color3f(1, 2, 3));
    EXPECT_EQ(area.tint, Color3f(0.5f, 0.5f, 0.5f));
}

TEST(LightJson, OnlyLampsLetThroughWhatLiesBehind) {
    EXPECT_TRUE(light_from_json(cube_map(), "").blocks);
    EXPECT_FALSE(light_from_json({{"type", "area"}, {"corners", kCorners}}, "").blocks);
}

TEST(LightJson, NamesThePathToWhatIsWrong) {
    EXPECT_TRUE(contains(message_of(with(cube_map(), "proxi", "depth")),
                         R"(s.json: lights.it: unknown field "proxi" (did you mean "proxy"?))"));
    EXPECT_TRUE(contains(message_of(with(cube_map(), "type", "cube")), R"(lights.it.type: unknown name "cube")"));
    EXPECT_TRUE(contains(message_of(with(cube_map(), "centre", {1, 2})), "lights.it.centre: expected [x, y, z], found [1,2]"));
    EXPECT_TRUE(contains(message_of(with(cube_map(), "file", 3)), "lights.it.file: expected text in quotes, found 3"));
    EXPECT_TRUE(
        contains(message_of({{"type", "cubemap"}, {"centre", {0, 0, 0}}}), "lights.it.file: missing; name the picture"));
    EXPECT_TRUE(contains(message_of({{"type", "mirror"}, {"file", "a.exr"}}), "field \"plane\" is missing"));
    EXPECT_TRUE(contains(message_of({{"type", "area"}, {"corners", {{0, 0, 0}, {0, 1, 0}}}}), "three or more places"));
    EXPECT_TRUE(contains(message_of(with(cube_map(), "blocks", 1)), "lights.it.blocks: expected true or false, found 1"));
    EXPECT_TRUE(contains(message_of(with(cube_map(), "scale", -1)), "lights.it.scale: expected a number from 0"));
}

TEST(LightJson, NamesWhatIsWrongWithAProxy) {
    const auto message = [](const json& proxy) { return message_of(with(cube_map(), "proxy", proxy)); };
    EXPECT_TRUE(contains(message("deph"), R"(lights.it.proxy: unknown name "deph" (did you mean "depth"?))"));
    EXPECT_TRUE(contains(message({{"planes", json::array()}}), "lights.it.proxy.planes: expected a list of planes"));
    const json flat = {{"point", {0, 0, 0}}, {"normal", {0, 0, 0}}};
    EXPECT_TRUE(
        contains(message({{"planes", {kPlane, flat}}}), "proxy.planes[1].normal: expected a direction other than zero"));
    EXPECT_TRUE(
        contains(message({{"box", {{"min", {0, 0, 0}}, {"max", {1, 0, 1}}}}}), "proxy.box.max: expected a corner beyond min"));
    EXPECT_TRUE(
        contains(message({{"box", {{"centre", {0, 0, 0}}, {"half", {1, 1, 1}}, {"x", {1, 1, 0}}}}}), "not perpendicular"));
    EXPECT_TRUE(
        contains(message({{"box", {{"centre", {0, 0, 0}}, {"half", {1, 0, 1}}}}}), "proxy.box.half: expected half the length"));
    EXPECT_TRUE(contains(message(json::object()), "expected a field planes, box or mesh"));
    EXPECT_TRUE(contains(message({{"mesh", "a.glb"}, {"box", json::object()}}), "both \"box\" and \"mesh\" are given"));
}

TEST(LightJson, FindsEveryFile) {
    const auto files = [](const json& value) {
        LightSettings light = light_from_json(value, "");
        std::string list;
        for_each_file(light, [&](std::string& file) { list += file + " ", file = "moved"; });
        return list + light_to_json(light).dump();
    };
    const json map = with(with(cube_map(), "depth", "d.exr"), "proxy", {{"mesh", "m.glb"}});
    EXPECT_TRUE(files(map).starts_with("vase.exr d.exr m.glb {"));
    EXPECT_EQ(files(map).find(".exr", files(map).find('{')), std::string::npos);
    const json mirror = {{"type", "mirror"}, {"file", "f.exr"}, {"plane", kPlane}, {"camera", {{"position", {0, 0, 1}}}}};
    EXPECT_TRUE(files(mirror).starts_with("f.exr {"));
    const json traced = {{"type", "traced"}, {"scene", "s.glb"}, {"radiance", "r.exr"}, {"albedo", "a.exr"}};
    EXPECT_TRUE(files(traced).starts_with("s.glb r.exr a.exr {"));
}
