#include <burnish/job/build_lights.h>

#include <burnish/base/json_fields.h>
#include <burnish/base/parallel.h>
#include <burnish/input/frames.h>
#include <burnish/job/color_flow.h>
#include <burnish/job/job_lights.h>
#include <burnish/job/look.h>
#include <burnish/job/stages.h>
#include <burnish/light/environment_picture.h>
#include <burnish/light/filter/gaussian_stack.h>
#include <burnish/light/light_json.h>
#include <burnish/scene/load_scene.h>

#include <algorithm>
#include <filesystem>
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

/// What all lights of a rig are made with.
struct LightRoom {
    LightRoom(const ColorFlow& color_flow, const LightFrame& light_frame) : color(color_flow), frame(light_frame) {}

    const ColorFlow color;
    const LightFrame frame;

    /// Proxies of cube maps, by file: rooms have many maps and one mesh.
    std::shared_ptr<const Scene> mesh(const std::string& file, UpAxis up) {
        const std::lock_guard lock(loading);
        std::shared_ptr<const Scene>& own = meshes[file];
        if (!own) own = std::make_shared<const Scene>(load_scene(file, {settled_up(up, frame.renderer)}));
        return own;
    }

private:
    std::mutex loading;
    std::map<std::string, std::shared_ptr<const Scene>> meshes;
};

/// Makes one light.
struct LightMaker {
    const LightSettings& settings;
    LightRoom& room;
    LightNotes& told;

    Light operator()(CubeMapSettings map) {
        map.picture.up = up(map.picture.up), map.picture.scale = settings.scale, map.picture.tint = settings.tint;
        const bool has_mesh = map.proxy.kind == ProxyKind::mesh && !map.proxy.mesh.empty();
        CubeMapLight light(map, conversion(), has_mesh ? room.mesh(map.proxy.mesh, map.picture.up) : nullptr);
        light.picture().gaussian_stack().stack();  // now, where lights are made side by side
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
        MirrorBuffer buffer = MirrorBuffer::load(of_frame, room.frame.camera, conversion());
        tell(buffer.notes, buffer.warnings);
        return MirrorLight(buffer, of_frame, gain());
    }

private:
    UpAxis up(UpAxis given) const { return settled_up(given, room.frame.renderer); }
    Color3f gain() const { return settings.tint * settings.scale; }

    std::function<void(Image&)> conversion() const {
        return [this](Image& picture) { room.color.from_space(picture, settings.space); };
    }

    std::string numbered(const std::string& file) const {
        if (!has_frame_token(file)) return file;
        if (!room.frame.number)
            throw Error(ErrorCode::bad_argument,
                        "'" + file + "' names a file for each frame, but aovs is one frame; name the one file");
        return frame_file(file, *room.frame.number);
    }

    void tell(const std::vector<std::string>& notes, const std::vector<std::string>& warnings) {
        told.notes.insert(told.notes.end(), notes.begin(), notes.end());
        told.warnings.insert(told.warnings.end(), warnings.begin(), warnings.end());
    }
};

[[noreturn]] void fail_light(const std::string& name, const Error& error) {
    if (error.code() == ErrorCode::cancelled) throw error;
    throw Error(error.code(), "lights." + name + ": " + error.what());
}

/// What the light tells, and errors, begin with its name.
LightSlot::Load loader(const RigLight& light, std::shared_ptr<LightRoom> room) {
    return [name = light.name, settings = *light.settings, room = std::move(room)](LightNotes& told) {
        try {
            told = {};
            Light made = std::visit(LightMaker{settings, *room, told}, settings.kind);
            for (std::string& line : told.notes) line = name + ": " + line;
            for (std::string& line : told.warnings) line = name + ": " + line;
            return made;
        } catch (const Error& error) {
            fail_light(name, error);
        }
    };
}

/// Whether it is loaded, and all levels of an environment filtered: rays of a chain read any.
bool is_ready(const RigLight& light) {
    if (!light.slot->is_loaded()) return false;
    const auto loaded = light.slot->light();
    const auto* distant = std::get_if<EnvironmentLight>(loaded.get());
    return !distant || distant->environment().gaussian_stack().is_whole();
}

/// A missing file is told before the first frame, not by the frame that first needs it.
void check_files(const RigLight& light) try {
    if (const auto* map = light.as<CubeMapSettings>()) environment_has_layer(map->file, PictureLayer::color);
    LightSettings settings = *light.settings;
    for_each_file(settings, [](const std::string& file) {
        const bool is_pattern = file.find("%s") != file.npos || file.find("{face}") != file.npos || has_frame_token(file);
        if (file.starts_with('{') || is_pattern || std::filesystem::exists(file)) return;
        throw Error(ErrorCode::read_failed, file + ": there is no such file. Correct its name.");
    });
} catch (const Error& error) {
    fail_light(light.name, error);
}

}  // namespace

UpAxis settled_up(UpAxis up, Renderer renderer) {
    return up == UpAxis::automatic && renderer == Renderer::cycles ? UpAxis::z : up;
}

Rig build_rig(const Job& job, const std::vector<AssignRule>& rules, const ColorFlow& color,
              std::shared_ptr<const Environment> environment, const LightFrame& frame) {
    const bool has_environment = environment || !job.environment.empty() || job.lights.empty();
    const std::set<std::string_view> used = used_names(job, rules, check_names(job, rules, has_environment));
    const auto room = std::make_shared<LightRoom>(color, frame);
    Rig rig;
    for (const auto& [name, settings] : job.lights) {
        if (!used.contains(name)) continue;
        RigLight light{name, settings, nullptr, settings.blocks};
        check_files(light);
        if (!is_of_frame(light)) light.slot = std::make_shared<LightSlot>(loader(light, room));
        rig.lights.push_back(std::move(light));
    }
    if (used.contains(job.environment_name) && has_environment) {
        if (!environment) environment = load_light(job, color, frame.renderer);
        LightNotes told{environment->notes(), environment->warnings()};
        const auto slot = std::make_shared<LightSlot>(EnvironmentLight(std::move(environment)), std::move(told));
        rig.lights.push_back({job.environment_name, {}, slot, false});
    }
    for (const AssignRule& rule : rules) rig.chains.push_back(chain_of(rig, names_of(job, rule)));
    return rig;
}

void load_needed(const Rig& rig, const std::vector<LitRule>& looks, NamedValues<double>& seconds, const Progress& progress) {
    std::set<size_t> needed;
    for (const LitRule& look : looks)
        if (!rig.is_distant(look.chain)) needed.insert(look.chain.begin(), look.chain.end());
    std::erase_if(needed, [&](size_t place) { return is_ready(rig.lights[place]); });
    if (needed.empty()) return;
    const std::vector<size_t> places(needed.begin(), needed.end());
    std::mutex reporting;
    timed(seconds, "light", [&] {
        for_each_index(static_cast<int>(places.size()), [&](int i) {
            {
                const std::lock_guard lock(reporting);
                progress.report("lights", 0.0f);
            }
            const auto light = rig.lights[places[static_cast<size_t>(i)]].slot->light();
            if (const auto* distant = std::get_if<EnvironmentLight>(light.get()))
                distant->environment().gaussian_stack().stack();
        });
    });
}

bool has_frame_lights(const Rig& rig) { return std::any_of(rig.lights.begin(), rig.lights.end(), is_of_frame); }

LightNotes load_frame_lights(Rig& rig, const ColorFlow& color, const LightFrame& frame) {
    LightNotes told;
    for (RigLight& light : rig.lights)
        if (is_of_frame(light)) {
            LightNotes own;
            Light made = loader(light, std::make_shared<LightRoom>(color, frame))(own);
            light.slot = std::make_shared<LightSlot>(std::move(made), LightNotes());
            told.notes.insert(told.notes.end(), own.notes.begin(), own.notes.end());
            told.warnings.insert(told.warnings.end(), own.warnings.begin(), own.warnings.end());
        }
    return told;
}

}  // namespace burnish
