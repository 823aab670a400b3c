#include <burnish/job/build_lights.h>

#include <burnish/base/json_fields.h>
#include <burnish/base/parallel.h>
#include <burnish/input/frames.h>
#include <burnish/job/color_flow.h>
#include <burnish/job/job_lights.h>
#include <burnish/job/look.h>
#include <burnish/scene/load_scene.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <set>

namespace burnish {
namespace {

bool is_by_place(const std::vector<std::string>& chain) {
    return chain.empty() || (chain.size() == 1 && chain[0] == kAutomaticChain);
}

const std::vector<std::string>& names_of(const Job& job, const AssignRule& rule) {
    return rule.chain.empty() ? job.chain : rule.chain;
}

/// Every light's name; throws for a rule that names another.
std::vector<std::string_view> check_names(const Job& job, const std::vector<AssignRule>& rules, bool has_environment) {
    std::vector<std::string_view> known;
    for (const auto& [name, light] : job.lights) known.push_back(name);
    if (has_environment) known.push_back(job.environment_name);
    for (const AssignRule& rule : rules) {
        if (is_by_place(names_of(job, rule))) continue;
        for (const std::string& name : names_of(job, rule))
            if (std::find(known.begin(), known.end(), name) == known.end())
                fail_unknown(rule.chain.empty() ? "light" : "assign (material " + rule.material + ")", "light", name, known);
    }
    return known;
}

/// The names that some rule can use: all, where one is left to choose by place.
std::set<std::string_view> used_names(const Job& job, const std::vector<AssignRule>& rules,
                                      const std::vector<std::string_view>& known) {
    std::set<std::string_view> used;
    for (const AssignRule& rule : rules) {
        const std::vector<std::string>& names = names_of(job, rule);
        if (is_by_place(names)) return {known.begin(), known.end()};
        used.insert(names.begin(), names.end());
    }
    return used;
}

std::optional<RigChain> chain_of(const Rig& rig, const std::vector<std::string>& names) {
    if (is_by_place(names)) return {};
    RigChain chain;
    for (const std::string& name : names) {
        const auto found = std::ranges::find(rig.lights, name, &RigLight::name);
        chain.push_back(static_cast<size_t>(found - rig.lights.begin()));
    }
    return chain;
}

/// Whether a light's file or camera is another one for each frame.
bool is_of_frame(const RigLight& light) {
    const auto* mirror = light.as<MirrorSettings>();
    const auto varies = [](const std::string& file) { return !file.starts_with('{') && has_frame_token(file); };
    return mirror && (varies(mirror->file) || varies(mirror->camera));
}

/// Proxies of cube maps, by file: rooms have many maps and one mesh.
using Meshes = std::map<std::string, std::shared_ptr<const Scene>>;

Meshes load_meshes(const Rig& rig, const LightFrame& frame) {
    Meshes meshes;
    for (const RigLight& light : rig.lights)
        if (const auto* map = light.as<CubeMapSettings>(); map && map->proxy.kind == ProxyKind::mesh) {
            std::shared_ptr<const Scene>& mesh = meshes[map->proxy.mesh];
            if (!mesh)
                mesh =
                    std::make_shared<const Scene>(load_scene(map->proxy.mesh, {settled_up(map->picture.up, frame.renderer)}));
        }
    return meshes;
}

/// Makes one light.
struct LightMaker {
    const LightSettings& settings;
    const ColorFlow& color;
    const LightFrame& frame;
    const Meshes& meshes;
    LightNotes told = {};

    Light operator()(CubeMapSettings map) {
        map.picture.up = up(map.picture.up), map.picture.scale = settings.scale, map.picture.tint = settings.tint;
        CubeMapLight light(map, conversion(), map.proxy.mesh.empty() ? nullptr : meshes.at(map.proxy.mesh));
        light.picture().gaussian_stack();  // now, where lights are made side by side
        tell(light.picture().notes(), light.picture().warnings());
        return light;
    }

    Light operator()(const AreaSettings& area) const { return AreaLight::load(area, gain(), conversion()); }

    Light operator()(TracedSettings traced) const {
        traced.up = up(traced.up);
        return TracedLight(std::make_shared<const LitScene>(traced, conversion()), traced.rays, gain());
    }

    Light operator()(const MirrorSettings& mirror) {
        MirrorSettings of_frame = mirror;
        of_frame.file = numbered(mirror.file);
        if (!mirror.camera.starts_with('{')) of_frame.camera = numbered(mirror.camera);
        MirrorBuffer buffer = MirrorBuffer::load(of_frame, frame.camera, conversion());
        tell(buffer.notes, buffer.warnings);
        return MirrorLight(buffer, of_frame, gain());
    }

private:
    UpAxis up(UpAxis given) const { return settled_up(given, frame.renderer); }
    Color3f gain() const { return settings.tint * settings.scale; }

    std::function<void(Image&)> conversion() const {
        return [this](Image& picture) { color.from_space(picture, settings.space); };
    }

    std::string numbered(const std::string& file) const {
        if (!has_frame_token(file)) return file;
        if (!frame.number)
            throw Error(ErrorCode::bad_argument,
                        "'" + file + "' names a file for each frame, but aovs is one frame; name the one file");
        return frame_file(file, *frame.number);
    }

    void tell(const std::vector<std::string>& notes, const std::vector<std::string>& warnings) {
        told.notes.insert(told.notes.end(), notes.begin(), notes.end());
        told.warnings.insert(told.warnings.end(), warnings.begin(), warnings.end());
    }
};

/// Sets light.light; what it tells, and errors, begin with its name.
LightNotes load(RigLight& light, const ColorFlow& color, const LightFrame& frame, const Meshes& meshes) {
    LightMaker maker{*light.settings, color, frame, meshes};
    try {
        light.light = std::make_shared<const Light>(std::visit(maker, light.settings->kind));
    } catch (const Error& error) {
        if (error.code() == ErrorCode::cancelled) throw;
        throw Error(error.code(), "lights." + light.name + ": " + error.what());
    }
    for (std::string& line : maker.told.notes) line = light.name + ": " + line;
    for (std::string& line : maker.told.warnings) line = light.name + ": " + line;
    return std::move(maker.told);
}

void append(const LightNotes& told, std::vector<std::string>& notes, std::vector<std::string>& warnings) {
    notes.insert(notes.end(), told.notes.begin(), told.notes.end());
    warnings.insert(warnings.end(), told.warnings.begin(), told.warnings.end());
}

/// All that do not wait for a frame, several at a time.
void load_all(Rig& rig, const ColorFlow& color, const LightFrame& frame, const Progress& progress) {
    std::vector<RigLight*> lights;
    for (RigLight& light : rig.lights)
        if (light.settings && !is_of_frame(light)) lights.push_back(&light);
    const Meshes meshes = load_meshes(rig, frame);
    std::vector<LightNotes> told(lights.size());
    std::mutex reporting;
    size_t done = 0;
    for_each_index(static_cast<int>(lights.size()), [&](int index) {
        const auto i = static_cast<size_t>(index);
        told[i] = load(*lights[i], color, frame, meshes);
        const std::lock_guard lock(reporting);
        progress.report("lights", static_cast<float>(++done) / static_cast<float>(lights.size()));
    });
    for (const LightNotes& of_one : told) append(of_one, rig.notes, rig.warnings);
}

}  // namespace

UpAxis settled_up(UpAxis up, Renderer renderer) {
    return up == UpAxis::automatic && renderer == Renderer::cycles ? UpAxis::z : up;
}

Rig build_rig(const Job& job, const std::vector<AssignRule>& rules, const ColorFlow& color,
              std::shared_ptr<const Environment> environment, const LightFrame& frame, const Progress& progress) {
    const bool has_environment = environment || !job.environment.empty() || job.lights.empty();
    const std::set<std::string_view> used = used_names(job, rules, check_names(job, rules, has_environment));
    Rig rig;
    for (const auto& [name, settings] : job.lights)
        if (used.contains(name)) rig.lights.push_back({name, settings, nullptr, settings.blocks});
    if (used.contains(job.environment_name) && has_environment) {
        if (!environment) environment = load_light(job, color, frame.renderer);
        append({environment->notes(), environment->warnings()}, rig.notes, rig.warnings);
        const Light light = EnvironmentLight(std::move(environment));
        rig.lights.push_back({job.environment_name, {}, std::make_shared<const Light>(light), false});
    }
    for (const AssignRule& rule : rules) rig.chains.push_back(chain_of(rig, names_of(job, rule)));
    load_all(rig, color, frame, progress);
    return rig;
}

bool has_frame_lights(const Rig& rig) { return std::any_of(rig.lights.begin(), rig.lights.end(), is_of_frame); }

LightNotes load_frame_lights(Rig& rig, const ColorFlow& color, const LightFrame& frame) {
    LightNotes told;
    for (RigLight& light : rig.lights)
        if (is_of_frame(light)) append(load(light, color, frame, {}), told.notes, told.warnings);
    return told;
}

}  // namespace burnish
