#include <burnish/job/bake.h>
#include <burnish/job/bake_plan.h>
#include <burnish/job/bake_shot.h>
#include <burnish/job/stages.h>
#include <burnish/output/aov_writer.h>
#include <burnish/output/envmap_writer.h>
#include <burnish/output/exr_writer.h>
#include <burnish/output/scene_writer.h>
#include <burnish/scene/atlas.h>
#include <burnish/scene/bake_frame.h>
#include <burnish/scene/bake_light_map.h>
#include <burnish/scene/find_objects.h>
#include <burnish/scene/gbuffer.h>
#include <burnish/scene/load_scene.h>
#include <burnish/scene/object_matte.h>

namespace burnish {
namespace {

constexpr int kMatteAntialias = 2, kMatteRanks = 4;

/// Writes into the folder of a job and keeps the names.
class Folder {
public:
    Folder(const BakeJob& job, BakeReport& report) : m_folder(job.folder), m_report(report) {}

    template <class Write>
    void write(const std::string& name, const Write& write_file) {
        timed(m_report.seconds, "writing", [&] { write_file((m_folder / name).string()); });
        m_report.files.push_back(name);
    }

private:
    std::filesystem::path m_folder;
    BakeReport& m_report;
};

/// Progress of a job whose parts take as long as the rays they trace.
class Share {
public:
    Share(const Progress& whole, double rays) : m_whole(whole), m_rays(rays) {}
    Progress next(double rays) {
        const double begin = m_done;
        m_done += rays;
        return part_of(m_whole, static_cast<float>(begin / m_rays), static_cast<float>(m_done / m_rays));
    }

private:
    const Progress& m_whole;
    double m_rays, m_done = 0;
};

double cube_rays(const CubeMapView& view) { return 6.0 * view.face_size * view.face_size * (view.samples + 1); }
double view_rays(const View& view, int rays) { return static_cast<double>(view.width) * view.height * rays; }

double all_rays(const BakePlan& plan, const BakeJob& job) {
    double sum = 1;
    if (plan.frame) sum += view_rays(*plan.frame, 1 + job.samples + kMatteAntialias * kMatteAntialias);
    for (const PlannedMirror& mirror : plan.mirrors) sum += view_rays(mirror.view, 1 + job.samples);
    for (const PlannedCube& cube : plan.cubes) sum += cube_rays(cube.view);
    return sum;
}

AovFrame bake_frame(const View& view, const BakeJob& job, const LitScene& scene, Share& share) {
    const Tracer& tracer = scene.tracer();
    AovFrame frame = trace_gbuffer(tracer, view, share.next(view_rays(view, 1)));
    frame.cryptomattes.push_back(trace_object_matte(tracer, view.camera, view.width, view.height, kMatteAntialias, kMatteRanks,
                                                    "CryptoObject",
                                                    share.next(view_rays(view, kMatteAntialias * kMatteAntialias))));
    add_seen_light(frame, tracer, view, scene.light(), job.samples, LightParts::apart,
                   share.next(view_rays(view, job.samples)));
    return frame;
}

/// Light, place and normal of what is seen; the rest is of no use to a mirror.
AovFrame bake_mirror(const View& view, const BakeJob& job, const LitScene& scene, Share& share) {
    AovFrame frame = trace_gbuffer(scene.tracer(), view, share.next(view_rays(view, 1)));
    for (const Role role : {Role::geometric_normal, Role::tangent, Role::uv, Role::roughness}) frame.layers.erase(role);
    add_seen_light(frame, scene.tracer(), view, scene.light(), job.samples, LightParts::together,
                   share.next(view_rays(view, job.samples)));
    return frame;
}

}  // namespace

BakeScene light_bake_scene(Scene scene, const BakeJob& job, const Progress& progress, BakeReport& report) {
    Folder folder(job, report);
    timed(report.seconds, "atlas", [&] { lay_out_atlas(scene, job.light_map_size); });
    Image map = timed(report.seconds, "light map", [&] {
        LightMapSettings settings;
        settings.size = job.light_map_size, settings.hidden = objects_named(scene, job.panes);
        return bake_light_map(Tracer(scene), settings, progress);
    });
    AovFrame frame;
    frame.data_window = frame.display_window = {0, 0, map.width, map.height};
    folder.write("irradiance.exr", [&](const std::string& file) {
        write_exr(file, frame, {{{"R", "G", "B"}, &map}}, PixelType::half);
    });
    folder.write("scene.glb", [&](const std::string& file) { write_scene(file, scene, job.up); });
    BakeScene baked;
    baked.files.scene = "scene.glb", baked.files.irradiance = "irradiance.exr", baked.files.up = job.up;
    baked.lit = timed(report.seconds, "loading", [&] {
        return std::make_shared<const LitScene>(std::move(scene), LightMaps{.irradiance = std::move(map)});
    });
    return baked;
}

BakeScene load_bake_scene(const BakeJob& job, const Progress& progress, BakeReport& report) {
    if (job.bake_light_maps) {
        Scene scene = timed(report.seconds, "loading", [&] { return load_scene(job.scene, {job.up, 0}); });
        return light_bake_scene(std::move(scene), job, progress, report);
    }
    BakeScene scene;
    scene.files.scene = job.scene, scene.files.up = job.up, scene.files.texcoord = job.texcoord;
    scene.files.radiance = job.radiance, scene.files.irradiance = job.irradiance, scene.files.albedo = job.albedo;
    scene.lit = timed(report.seconds, "loading", [&] { return std::make_shared<const LitScene>(scene.files); });
    return scene;
}

void bake_pictures(const BakeJob& job, const BakeScene& scene, const Progress& progress, BakeReport& report) {
    Folder folder(job, report);
    const BakePlan plan = plan_bake(job, scene.lit->light().scene());
    Share share(progress, all_rays(plan, job));
    for (const PlannedCube& cube : plan.cubes) {
        const CubeMapPicture picture = timed(report.seconds, "cube maps", [&] {
            return bake_cube_map(scene.lit->tracer(), scene.lit->light(), cube.view, share.next(cube_rays(cube.view)));
        });
        folder.write(cube.name + ".exr", [&](const std::string& file) { write_cube_map(file, picture); });
    }
    for (const PlannedMirror& mirror : plan.mirrors) {
        const AovFrame frame = timed(report.seconds, mirror.light.behind ? "panes" : "mirrors",
                                     [&] { return bake_mirror(mirror.view, job, *scene.lit, share); });
        folder.write(mirror.name + ".exr", [&](const std::string& file) { write_aovs(file, frame, "ViewLayer"); });
    }
    if (plan.frame) {
        const AovFrame frame = timed(report.seconds, "frame", [&] { return bake_frame(*plan.frame, job, *scene.lit, share); });
        folder.write("shot.exr", [&](const std::string& file) { write_aovs(file, frame, "ViewLayer"); });
    }
    folder.write("shot.json", [&](const std::string& file) { write_text(file, baked_shot(job, plan, scene)); });
}

BakeReport bake(const BakeJob& job, const Progress& progress) {
    constexpr float kLightMaps = 0.5f;  // of the time, where they are baked
    BakeReport report;
    const float begin = job.bake_light_maps ? kLightMaps : 0.0f;
    const BakeScene scene = load_bake_scene(job, part_of(progress, 0.0f, begin), report);
    bake_pictures(job, scene, part_of(progress, begin, 1.0f), report);
    return report;
}

}  // namespace burnish
