#include <burnish/base/error.h>
#include <burnish/base/nearest_name.h>
#include <burnish/input/camera_source.h>
#include <burnish/job/bake_plan.h>
#include <burnish/scene/find_objects.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace burnish {
namespace {

[[noreturn]] void refuse(const std::string& problem) { throw Error(ErrorCode::bad_argument, problem); }

/// A name as part of a file's.
std::string file_name(std::string name) {
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
    return name;
}

/// Resolves names, each at most once.
class Planner {
public:
    Planner(const BakeJob& job, const Scene& scene) : m_job(job), m_scene(scene), m_panes(objects_named(scene, job.panes)) {
        if (!job.panes.empty() && m_panes.empty()) refuse_unknown("panes", job.panes);
    }

    std::optional<View> frame() const {
        if (m_job.camera.empty()) return std::nullopt;
        AovFrame frame;
        frame.data_window = frame.display_window = {0, 0, m_job.width, m_job.height};
        const View view{camera_source(m_job.camera)(frame), m_job.width, m_job.height};
        if (!view.camera.has_rays) refuse("camera: the angle of view is missing; a position alone does not make a picture");
        return view;
    }

    void add(const CubeBake& cube, std::vector<PlannedCube>& cubes) {
        const std::vector<int> objects = objects_named(m_scene, cube.object);
        if (!cube.object.empty() && objects.empty()) refuse_unknown("cube map", cube.object);
        if (cube.centre) return put(cube.name.empty() ? cube.object : cube.name, objects, *cube.centre, cubes);
        for (const std::string& name : names_of(objects)) {
            std::vector<int> parts;
            std::ranges::copy_if(objects, std::back_inserter(parts), [&](int i) { return name_of(i) == name; });
            put(cube.name.empty() ? name : cube.name, parts, bounding_centre(m_scene, parts), cubes);
        }
    }

    void add(const MirrorBake& mirror, const View& frame, std::vector<PlannedMirror>& mirrors) {
        const std::vector<int> objects = objects_named(m_scene, mirror.object);
        if (!mirror.object.empty() && objects.empty()) refuse_unknown("mirror", mirror.object);
        std::optional<HalfSpace> plane;
        if (mirror.plane) plane = HalfSpace{mirror.plane->point, mirror.plane->normal};
        if (!plane) plane = largest_plane(m_scene, objects, frame.camera.centre);
        if (!plane) refuse("mirror '" + mirror.object + "': the camera sees no front of it; give its plane, or turn its faces");
        const std::string kind = mirror.behind ? "behind_" : "mirror_";
        const std::string name = kind + file_name(mirror.name.empty() ? mirror.object : mirror.name);
        PlannedMirror planned{
            claimed(name), objects, {}, mirror.behind ? behind_view(frame, *plane) : mirror_view(frame, *plane)};
        planned.view.hidden = with_panes(objects);
        planned.light.file = name + ".exr", planned.light.plane = {plane->point, plane->normal};
        planned.light.behind = mirror.behind;
        mirrors.push_back(std::move(planned));
    }

private:
    const std::string& name_of(int object) const { return m_scene.objects[static_cast<size_t>(object)].name; }

    std::vector<std::string> names_of(const std::vector<int>& objects) const {
        std::vector<std::string> names;
        for (const int i : objects)
            if (std::ranges::find(names, name_of(i)) == names.end()) names.push_back(name_of(i));
        return names;
    }

    void put(const std::string& name, const std::vector<int>& objects, const Vec3f& centre, std::vector<PlannedCube>& cubes) {
        const UpAxis up = m_job.up == UpAxis::z ? UpAxis::z : UpAxis::y;
        cubes.push_back(
            {claimed("cube_" + file_name(name)), objects, {centre, m_job.cube_size, m_job.samples, up, with_panes(objects)}});
    }

    std::vector<int> with_panes(std::vector<int> objects) const {
        objects.insert(objects.end(), m_panes.begin(), m_panes.end());
        return objects;
    }

    std::string claimed(const std::string& name) {
        if (!m_names.insert(name).second) refuse("two pictures would be called '" + name + "'; give one of them another name");
        return name;
    }

    [[noreturn]] void refuse_unknown(const std::string& what, const std::string& pattern) const {
        std::vector<std::string_view> known;
        for (const Object& object : m_scene.objects) known.push_back(object.name);
        refuse(what + " \"" + pattern + "\": no object of the scene has this name" + did_you_mean(pattern, known));
    }

    const BakeJob& m_job;
    const Scene& m_scene;
    std::vector<int> m_panes;
    std::set<std::string> m_names;
};

}  // namespace

BakePlan plan_bake(const BakeJob& job, const Scene& scene) {
    Planner planner(job, scene);
    BakePlan plan;
    plan.frame = planner.frame();
    for (const CubeBake& cube : job.cubes) planner.add(cube, plan.cubes);
    for (const MirrorBake& mirror : job.mirrors) planner.add(mirror, plan.frame.value(), plan.mirrors);
    return plan;
}

}  // namespace burnish
