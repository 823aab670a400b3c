// Scenes written are the scenes read: places, texture coordinates, names, indices, colours; in Y-up and Z-up worlds.
#include <burnish/base/error.h>
#include <burnish/output/scene_writer.h>
#include <burnish/scene/demo_room.h>
#include <burnish/scene/load_scene.h>
#include <burnish/scene/trace.h>

#include <core/scratch.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(SceneWriter, WhatIsReadBackIsTheSceneWritten) {
    const Scene written = make_demo_room();
    for (const UpAxis up : {UpAxis::y, UpAxis::z}) {
        const Scratch scratch;
        write_scene(scratch.file("room.glb"), written, up);
        const Scene read = load_scene(scratch.file("room.glb"), {up, 0});
        ASSERT_EQ(read.objects.size(), written.objects.size());
        for (size_t i = 0; i < read.objects.size(); ++i) {
            const Object &a = written.objects[i], &b = read.objects[i];
            ASSERT_EQ(a.name, b.name);
            ASSERT_EQ(a.material, b.material);
            ASSERT_EQ(a.object_index, b.object_index);
            ASSERT_EQ(a.material_index, b.material_index);
            ASSERT_EQ(a.albedo, b.albedo);
            ASSERT_NEAR((a.emission - b.emission).length(), 0, 1e-5);
            ASSERT_EQ(a.mesh.triangles.size(), b.mesh.triangles.size());
            for (size_t t = 0; t < a.mesh.triangles.size(); ++t)
                for (size_t k = 0; k < 3; ++k) {
                    const Vertex& from = a.mesh.vertices[a.mesh.triangles[t][k]];
                    const Vertex& to = b.mesh.vertices[b.mesh.triangles[t][k]];
                    ASSERT_EQ(from.p, to.p);
                    ASSERT_NEAR((from.n - to.n).length(), 0, 1e-6);
                    ASSERT_NEAR((from.uv - to.uv).length(), 0, 1e-6);
                }
        }
    }
}

TEST(SceneWriter, RefusesOtherNames) { EXPECT_THROW(write_scene("room.obj", make_demo_room(), UpAxis::z), Error); }

}  // namespace
}  // namespace burnish
