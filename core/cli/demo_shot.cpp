#include "demo_shot.h"

#include <burnish/base/json_fields.h>
#include <burnish/input/camera_json.h>
#include <burnish/job/stages.h>
#include <burnish/light/environment.h>
#include <burnish/output/aov_writer.h>
#include <burnish/output/exr_writer.h>
#include <burnish/sampling/sequence.h>
#include <burnish/scene/demo_scene.h>
#include <burnish/scene/diffuse.h>
#include <burnish/scene/gbuffer.h>
#include <burnish/scene/object_matte.h>
#include <burnish/scene/procedural_sky.h>

#include <nlohmann/json.hpp>

namespace burnish::cli {
namespace {

using nlohmann::ordered_json;

constexpr int kSkyWidth = 2048, kSkySamples = 2, kLightSamples = 512, kBounceSamples = 8, kAntialias = 2, kMatteRanks = 4;

/// One rule an object, except that all balls wear plastic until a later rule says otherwise, and that the ring is named by its
/// object index: every way to choose pixels in one shot.
ordered_json assign_json(const Scene& scene) {
    ordered_json rules = ordered_json::array();
    rules.push_back({{"material", "plastic-gloss"}, {"cryptomatte", "ball_*"}});
    for (const Object& object : scene.objects) {
        if (object.material.empty() || object.material == "plastic-gloss") continue;
        if (object.material == "rubber")
            rules.push_back({{"material", object.material}, {"index", object.object_index}});
        else
            rules.push_back({{"material", object.material}, {"cryptomatte", object.name}});
    }
    return rules;
}

ordered_json shot_json(const Scene& scene) {
    return {{"aovs", "shot.exr"},
            {"camera", camera_json(demo_viewpoint())},
            {"lights", {{"sky", {{"type", "environment"}, {"file", "sky.exr"}, {"convention", "blender"}, {"up", "z"}}}}},
            {"assign", assign_json(scene)},
            {"quality", {{"samples", 37}}},
            {"output", {{"file", "out.exr"}, {"preview", "after.png"}, {"report", "report.json"}}}};
}

/// The sky for the tracer: seen by formula, sampled from the picture that also lights the overlay.
DistantLight distant_light(const ProceduralSky& sky, const Image& picture) {
    EnvironmentSettings settings;
    settings.convention = EnvironmentConvention::blender;
    settings.up = UpAxis::z;
    const Environment environment = Environment::from_image(picture, settings, "sky");
    const Matrix33f to_world = environment.world_to_light().transposed();
    DistantLight light;
    light.radiance = [&sky](const Vec3f& d) { return sky.radiance(d); };
    for (uint32_t i = 0; i < kLightSamples; ++i) {
        constexpr uint32_t kSeed = 7;
        float pdf = 0;
        const Vec3f wi = environment.sample(owen_sobol(i, kSeed), pdf);
        light.samples.push_back({wi * to_world, environment.radiance(wi) / (pdf * kLightSamples)});
    }
    return light;
}

void write_sky(const std::string& file, const Image& picture) {
    AovFrame frame;
    frame.data_window = frame.display_window = {0, 0, picture.width, picture.height};
    write_exr(file, frame, {{{"R", "G", "B"}, &picture}}, PixelType::half);
}

}  // namespace

ordered_json camera_json(const Viewpoint& view) {
    return {{"position", to_json_vector(view.position)},
            {"look_at", to_json_vector(view.look_at)},
            {"up", to_json_vector(view.up)},
            {"fov_x_deg", to_json_number(view.fov_x_deg)}};
}

void write_demo_shot(const std::filesystem::path& folder, int width, int height, const Progress& progress,
                     NamedValues<double>& seconds) {
    const Scene scene = timed(seconds, "make scene", make_demo_scene);
    const ProceduralSky sky;
    const Image picture = timed(seconds, "make sky", [&] { return sky.picture(kSkyWidth, kSkySamples); });
    const AovFrame frame = timed(seconds, "trace", [&] {
        const auto aspect = static_cast<float>(width) / static_cast<float>(height);
        const Camera camera = camera_from_json(camera_json(demo_viewpoint()), "camera", aspect);
        const Tracer tracer(scene);
        AovFrame traced = trace_gbuffer(tracer, camera, width, height, part_of(progress, 0.0f, 0.1f));
        traced.cryptomattes.push_back(trace_object_matte(tracer, camera, width, height, kAntialias, kMatteRanks, "CryptoObject",
                                                         part_of(progress, 0.1f, 0.3f)));
        add_diffuse(traced, tracer, distant_light(sky, picture), {kAntialias, kBounceSamples}, part_of(progress, 0.3f, 1.0f));
        return traced;
    });
    timed(seconds, "write shot", [&] {
        write_aovs((folder / "shot.exr").string(), frame, "ViewLayer");
        write_sky((folder / "sky.exr").string(), picture);
        write_text((folder / "shot.json").string(), shot_json(scene).dump(2) + "\n");
    });
}

}  // namespace burnish::cli
