// Scene files and light maps against a render: what the maps say leaves a surface is what Cycles' camera saw there.
#include "../data.h"
#include "../read_layer.h"
#include "../scratch.h"

#include <burnish/scene/load_scene.h>
#include <burnish/scene/surface_light.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace burnish {
namespace {

Vec3f vec3(const Image& image, size_t i) { return {image.at(i)[0], image.at(i)[1], image.at(i)[2]}; }
Color3f rgb(const Image& image, size_t i) { return vec3(image, i); }

/// The render's passes and the maps, or nothing where the data is not there.
struct Room {
    Image position, normal, object, diffuse;
    LightMaps maps;

    static std::optional<Room> load() {
        const auto folder = data_path("cycles/room");
        if (!folder) return std::nullopt;
        const auto layer = [&](const std::string& name, const std::string& channels) {
            std::vector<std::string> names;
            for (const char c : channels) names.push_back("ViewLayer." + name + "." + c);
            return read_layer(*folder / "room.exr", names);
        };
        Room room{layer("Position", "XYZ"), layer("Normal", "XYZ"), layer("IndexOB", "X"), layer("DiffCol", "RGB"), {}};
        const Image direct = layer("DiffDir", "RGB"), indirect = layer("DiffInd", "RGB"), emission = layer("Emit", "RGB");
        for (size_t i = 0; i < direct.data.size(); ++i)
            room.diffuse.data[i] = room.diffuse.data[i] * (direct.data[i] + indirect.data[i]) + emission.data[i];
        room.maps.radiance = read_layer(*folder / "lightmap_radiance.exr", {"R", "G", "B"});
        return room;
    }
};

struct Agreement {
    float median_error;  // relative, of luminance
    double ratio;        // sum of luminance, map over render
    int pixels, other_objects;
};

/// Every 7th pixel, met along its normal from 1 mm above.
Agreement compare(const Room& room, const Scene& scene) {
    const Tracer tracer(scene);
    const SurfaceLight light(scene, room.maps);
    std::vector<float> errors;
    double sum = 0, expected = 0;
    int others = 0;
    for (size_t i = 0; i < room.position.pixel_count(); i += 7) {
        const Vec3f n = vec3(room.normal, i);
        const auto hit = tracer.closest(vec3(room.position, i) + n * 1e-3f, -n);
        if (!hit || hit->distance > 2e-3f) continue;
        others += scene.objects[static_cast<size_t>(hit->object)].object_index != static_cast<int>(*room.object.at(i));
        const float found = luminance(light.radiance(*hit)), rendered = luminance(rgb(room.diffuse, i));
        errors.push_back(std::abs(found - rendered) / std::max(rendered, 1e-3f));
        sum += found, expected += rendered;
    }
    std::ranges::nth_element(errors, errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2));
    return {errors[errors.size() / 2], sum / expected, static_cast<int>(errors.size()), others};
}

void expect_agreement(const Room& room, const Scene& scene) {
    ASSERT_EQ(scene.objects.size(), 12u);
    const Agreement found = compare(room, scene);
    EXPECT_GT(found.pixels, 32000);
    EXPECT_LT(found.other_objects, found.pixels / 1000);
    EXPECT_LT(found.median_error, 0.012f);
    EXPECT_NEAR(found.ratio, 1, 0.002);
}

}  // namespace

TEST(CyclesLightMaps, GltfShowsWhatTheCameraSaw) {
    const auto room = Room::load();
    if (!room) GTEST_SKIP() << "no data";
    const Scene scene = load_scene(data_path("cycles/room/room_lightmapped.glb")->string(), {.up = UpAxis::z});
    expect_agreement(*room, scene);
    EXPECT_EQ(scene.objects[11].name, "vase");
    EXPECT_EQ(scene.objects[11].material_index, 2);
    EXPECT_NEAR(scene.objects[6].emission.x, 14, 1e-5);
    EXPECT_NEAR(scene.objects[6].emission.z, 14 * 0.8, 1e-5);
}

TEST(CyclesLightMaps, ObjShowsWhatTheCameraSaw) {
    const auto room = Room::load();
    if (!room) GTEST_SKIP() << "no data";
    const Scratch folder;
    const std::string file = folder.file("room.obj");
    const std::string packed = data_path("cycles/room/room_lightmapped.obj.gz")->string();
    ASSERT_EQ(std::system(("gzip -dc '" + packed + "' > '" + file + "'").c_str()), 0);
    const Scene scene = load_scene(file);
    expect_agreement(*room, scene);
    EXPECT_EQ(scene.objects[11].name, "vase");
    EXPECT_EQ(scene.objects[11].object_index, 12);
    EXPECT_EQ(scene.objects[11].material, "vase");
}

}  // namespace burnish
