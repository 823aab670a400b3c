// What scene files say arrives: places, names, ids, colours, texture coordinates; and what is damaged is refused.
#include "scene_files.h"

#include <burnish/base/error.h>
#include <burnish/scene/load_scene.h>

#include <gtest/gtest.h>

#include <functional>

using namespace burnish;
using namespace burnish_test;
using nlohmann::json;

namespace {

void expect_near(const Vec3f& a, const Vec3f& b) { EXPECT_NEAR((a - b).length(), 0, 1e-6f) << a << " is not " << b; }

Scene load(const json& document, const SceneSettings& settings = {}) {
    const Scratch folder;
    return load_scene(written(folder, "scene.glb", glb(document.dump(), square_buffer())), settings);
}

/// The message with which a file is refused.
std::string refusal(const std::string& name, const std::string& bytes) {
    const Scratch folder;
    const std::string file = written(folder, name, bytes);
    try {
        load_scene(file);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::read_failed);
        EXPECT_TRUE(std::string(error.what()).starts_with(file + ": ")) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        return std::string(error.what()).substr(file.size() + 2);
    }
    return "";
}

}  // namespace

TEST(LoadScene, BringsNamesIdsAndColours) {
    const Scene scene = load(square_gltf());
    ASSERT_EQ(scene.objects.size(), 1u);
    const Object& object = scene.objects[0];
    EXPECT_EQ(object.name, "square");
    EXPECT_EQ(object.material, "lamp");
    EXPECT_EQ(object.object_index, 7);
    EXPECT_EQ(object.material_index, 4);
    expect_near(object.albedo, {0.1f, 0.2f, 0.3f});
    expect_near(object.emission, {8, 4, 2});
    EXPECT_EQ(object.mesh.triangles.size(), 2u);
}

TEST(LoadScene, CountsIndicesThatTheFileDoesNotGive) {
    json document = square_gltf();
    document["nodes"] = json::parse(R"([{"mesh": 0}, {"children": [2]}, {"mesh": 0}])");
    document["scenes"][0]["nodes"] = {0, 1};
    document["materials"][0].erase("extras");
    const Scene scene = load(document);
    ASSERT_EQ(scene.objects.size(), 2u);
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(scene.objects[static_cast<size_t>(i)].object_index, i + 1);
        EXPECT_EQ(scene.objects[static_cast<size_t>(i)].material_index, 1);
    }
}

TEST(LoadScene, TurnsGltfToTheWorldsUpAxis) {
    const Mesh y_up = load(square_gltf()).objects[0].mesh, z_up = load(square_gltf(), {.up = UpAxis::z}).objects[0].mesh;
    ASSERT_EQ(y_up.vertices.size(), z_up.vertices.size());
    for (size_t i = 0; i < y_up.vertices.size(); ++i) {
        const Vertex &a = y_up.vertices[i], &b = z_up.vertices[i];
        expect_near(b.p, {a.p.x, -a.p.z, a.p.y});
        expect_near(a.n, {0, 0, 1});
        expect_near(b.n, {0, -1, 0});
        expect_near(b.t, {1, 0, 0});
        EXPECT_NEAR(a.uv.x, a.p.x, 1e-6f);
        EXPECT_NEAR(a.uv.y, a.p.y, 1e-6f);
    }
}

TEST(LoadScene, MirroringTransformsKeepFrontsAndNormalsOutside) {
    json document = square_gltf();
    document["nodes"] =
        json::parse(R"([{"children": [1], "translation": [0, 0, 5]}, {"mesh": 0, "scale": [-2, 1, 1], "name": "mirrored"}])");
    const Mesh mesh = load(document).objects[0].mesh;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vertex &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
        expect_near((b.p - a.p).cross(c.p - a.p).normalized(), {0, 0, 1});
        expect_near(a.n, {0, 0, 1});
        expect_near(a.t, {-1, 0, 0});
        EXPECT_FLOAT_EQ(a.p.z, 5);
        EXPECT_FLOAT_EQ(a.p.x, -2 * a.uv.x);
    }
}

TEST(LoadScene, TakesTheTextureCoordinatesAskedFor) {
    const Mesh second = load(square_gltf(), {.texcoord = 1}).objects[0].mesh;
    for (const Vertex& vertex : second.vertices) {
        EXPECT_FLOAT_EQ(vertex.uv.x, 0.5f * vertex.p.x);
        EXPECT_FLOAT_EQ(vertex.uv.y, 0.5f + 0.5f * vertex.p.y);
    }
    try {
        load(square_gltf(), {.texcoord = 2});
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_argument);
        EXPECT_NE(std::string(error.what()).find("'square' has no TEXCOORD_2"), std::string::npos);
    }
}

TEST(LoadScene, ReadsObjFilesInTheirOwnAxes) {
    const Scratch folder;
    const std::string file = written(folder, "scene.obj", R"(mtllib scene.mtl
o roof
v 0 0 3
v 2 0 3
v 2 1 3
v 0 1 3
vt 0 0
vt 1 0
vt 1 0.5
vt 0 0.5
usemtl slate
f 1/1 2/2 3/3 4/4
o point
v 0 0 0
p 5
)");
    written(folder, "scene.mtl", "newmtl slate\nKd 0.2 0.3 0.4\nKe 1 2 3\n");
    const Scene scene = load_scene(file, {.up = UpAxis::z});
    ASSERT_EQ(scene.objects.size(), 1u);
    const Object& roof = scene.objects[0];
    EXPECT_EQ(roof.name, "roof");
    EXPECT_EQ(roof.material, "slate");
    EXPECT_EQ(roof.object_index, 1);
    expect_near(roof.albedo, {0.2f, 0.3f, 0.4f});
    expect_near(roof.emission, {1, 2, 3});
    ASSERT_EQ(roof.mesh.triangles.size(), 2u);
    for (const Vertex& vertex : roof.mesh.vertices) {
        EXPECT_FLOAT_EQ(vertex.p.z, 3);
        expect_near(vertex.n, {0, 0, 1});
        expect_near(vertex.t, {1, 0, 0});
        EXPECT_FLOAT_EQ(vertex.uv.x, vertex.p.x / 2);
        EXPECT_FLOAT_EQ(vertex.uv.y, vertex.p.y / 2);
    }
}

TEST(LoadScene, RefusesWhatIsNoScene) {
    EXPECT_EQ(refusal("scene.fbx", "x"), "expected a scene as .glb, .gltf or .obj; export it as one of these");
    EXPECT_NE(refusal("scene.obj", ""), "");
    EXPECT_NE(refusal("scene.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), "");
    EXPECT_NE(refusal("scene.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "");
    EXPECT_NE(refusal("scene.glb", std::string(1000, '\7')), "");
    EXPECT_NE(refusal("scene.gltf", "{}"), "");
    EXPECT_NE(refusal("scene.gltf", std::string(1 << 20, '[')), "");
    EXPECT_THROW(load_scene("/no/such/scene.glb"), Error);
    EXPECT_THROW(load_scene(std::filesystem::temp_directory_path().string() + "/."), Error);
}

TEST(LoadScene, RefusesEveryTruncation) {
    const std::string whole = square_glb();
    for (size_t size = 0; size < whole.size(); size += 13) EXPECT_NE(refusal("scene.glb", whole.substr(0, size)), "") << size;
}

TEST(LoadScene, RefusesDocumentsThatDoNotAddUp) {
    const auto damaged = [](const std::function<void(json&)>& damage) {
        json document = square_gltf();
        damage(document);
        return refusal("scene.glb", glb(document.dump(), square_buffer()));
    };
    const auto has = [](const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; };
    EXPECT_TRUE(has(damaged([](json& d) { d["asset"]["version"] = "1.0"; }), "glTF 2.0"));
    EXPECT_TRUE(has(damaged([](json& d) { d["nodes"][0]["children"] = {0}; }), "in a loop"));
    EXPECT_TRUE(has(damaged([](json& d) { d["nodes"][0]["children"] = {5}; }), "does not exist"));
    EXPECT_TRUE(has(damaged([](json& d) { d["scenes"][0]["nodes"] = {0, 0}; }), "twice"));
    EXPECT_TRUE(has(damaged([](json& d) {
                        d["nodes"].push_back({{"children", {2, 2}}}), d["nodes"].push_back(json::object());
                    }),
                    "two parents"));
    EXPECT_TRUE(has(damaged([](json& d) {
                        for (int i = 1; i < 3000; ++i) d["nodes"].push_back({{"children", {i + 1}}});
                        d["nodes"].push_back(json::object());
                    }),
                    "levels deep"));
    EXPECT_TRUE(has(damaged([](json& d) { d["accessors"][0]["count"] = 4000000000u; }), "more vertices"));
    EXPECT_TRUE(has(damaged([](json& d) { d["nodes"][0]["scale"] = {1e30, 1, 1}; }), "finite place"));
    EXPECT_NE(damaged([](json& d) { d["bufferViews"][0]["byteLength"] = 1000; }), "");
    EXPECT_NE(damaged([](json& d) { d["accessors"][0]["bufferView"] = 17; }), "");
    EXPECT_NE(damaged([](json& d) { d["nodes"][0]["mesh"] = 3; }), "");
    EXPECT_NE(damaged([](json& d) { d["materials"] = 3; }), "");
    json endless = square_gltf();
    endless["buffers"][0]["uri"] = "/dev/zero";
    EXPECT_NE(refusal("scene.gltf", endless.dump()), "");
}

TEST(LoadScene, SurvivesWrongBytes) {
    const std::string whole = square_glb();
    uint32_t state = 1;
    const auto random = [&] { return (state = state * 1664525u + 1013904223u) >> 8; };
    int refused = 0;
    for (int i = 0; i < 500; ++i) {
        std::string bytes = whole;
        for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
        refused += !refusal("scene.glb", bytes).empty();
    }
    EXPECT_GT(refused, 100);
}
