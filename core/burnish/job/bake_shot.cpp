#include <burnish/job/bake_shot.h>
#include <burnish/light/light_json.h>
#include <burnish/material/library.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace burnish {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* kRoom = "room";

LightSettings cube_light(const PlannedCube& cube) {
    CubeMapSettings map;
    map.file = cube.name + ".exr", map.distances = DistanceKind::ray, map.centre = cube.view.centre;
    map.picture.up = cube.view.up, map.proxy.kind = ProxyKind::depth;
    return {map};
}

/// The user's own files by absolute paths: the shot lies elsewhere.
LightSettings room_light(const BakeJob& job, const BakeScene& scene) {
    LightSettings light{scene.files};
    if (!job.bake_light_maps)
        for_each_file(light, [](std::string& file) { file = std::filesystem::absolute(file).lexically_normal().string(); });
    return light;
}

bool is_of(const std::vector<int>& objects, size_t object) {
    return std::ranges::find(objects, static_cast<int>(object)) != objects.end();
}

/// Lights of an object, the first in front; empty: those of the whole shot.
std::vector<std::string> chain_of(const BakePlan& plan, size_t object) {
    std::vector<std::string> chain;
    for (const PlannedMirror& mirror : plan.mirrors)
        if (is_of(mirror.objects, object)) chain.push_back(mirror.name);
    const auto cube = std::ranges::find_if(plan.cubes, [&](const PlannedCube& c) { return is_of(c.objects, object); });
    if (cube != plan.cubes.end())
        chain.push_back(cube->name);
    else if (!chain.empty())
        chain.push_back(kRoom);
    return chain;
}

/// A pattern that matches this name alone.
std::string literal(const std::string& name) {
    std::string pattern;
    for (const char c : name) {
        if (c == ',' || c == '*' || c == '?' || c == '\\') pattern += '\\';
        pattern += c;
    }
    return pattern;
}

/// One rule for all objects of one look, so that pixels between two of them are covered wholly.
ordered_json rules(const BakePlan& plan, const Scene& scene) {
    std::vector<std::pair<ordered_json, std::string>> looks;  // and who has it
    for (size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        if (std::ranges::find(presets(), object.material, &Material::name) == presets().end()) continue;
        ordered_json look = {{"material", object.material}, {"cryptomatte", ""}};
        if (const auto chain = chain_of(plan, i); !chain.empty()) look["light"] = chain;
        const auto known = std::ranges::find(looks, look, &std::pair<ordered_json, std::string>::first);
        if (known == looks.end())
            looks.emplace_back(std::move(look), literal(object.name));
        else
            known->second += "," + literal(object.name);
    }
    ordered_json rules = ordered_json::array();
    for (auto& [look, names] : looks) {
        look["cryptomatte"] = names;
        rules.push_back(std::move(look));
    }
    return rules;
}

}  // namespace

std::string baked_shot(const BakeJob& job, const BakePlan& plan, const BakeScene& scene) {
    ordered_json shot;
    if (plan.frame) shot["aovs"] = "shot.exr";
    for (const PlannedMirror& mirror : plan.mirrors) shot["lights"][mirror.name] = light_to_json({mirror.light});
    for (const PlannedCube& cube : plan.cubes) shot["lights"][cube.name] = light_to_json(cube_light(cube));
    shot["lights"][kRoom] = light_to_json(room_light(job, scene));
    shot["assign"] = rules(plan, scene.lit->light().scene());
    shot["output"] = {{"file", "out.exr"}, {"preview", "after.png"}, {"report", "report.json"}};
    return shot.dump(2) + "\n";
}

}  // namespace burnish
