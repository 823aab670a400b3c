#include <burnish/input/info.h>

#include <nlohmann/json.hpp>

namespace burnish {
namespace {

using Missing = std::vector<std::string>;

Missing missing_roles(const AovFrame& frame, std::initializer_list<Role> needed) {
    Missing missing;
    for (const Role role : needed)
        if (!frame.has(role)) missing.emplace_back(role_info(role).name);
    return missing;
}

Missing missing_for_overlay(const AovFrame& frame) {
    Missing missing = missing_roles(frame, {Role::position, Role::normal});
    if (!frame.camera) missing.emplace_back("camera");
    return missing;
}

Missing operator+(Missing a, const Missing& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Passes divided by their colour (Cycles) need it back.
Missing missing_specular(const AovFrame& frame) {
    if (!frame.has(Role::specular_direct) && !frame.has(Role::specular_indirect))
        return {"specular_direct or specular_indirect"};
    return frame.divided_by_albedo ? missing_roles(frame, {Role::specular_albedo}) : Missing{};
}

Missing missing_diffuse(const AovFrame& frame) {
    if (frame.has(Role::irradiance) || frame.has(Role::diffuse_direct) || frame.has(Role::diffuse_indirect)) return {};
    return {"irradiance, diffuse_direct or diffuse_indirect"};
}

Missing unless(bool is_there, const char* what) { return is_there ? Missing{} : Missing{what}; }

std::string join(const Missing& items) {
    std::string text;
    for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
    return text;
}

std::string size_text(const Window& window) {
    return std::to_string(window.width) + "x" + std::to_string(window.height) + " at " + std::to_string(window.x) + "," +
           std::to_string(window.y);
}

nlohmann::json to_json(const Window& window) { return {window.x, window.y, window.width, window.height}; }
nlohmann::json to_json(const Vec3f& v) { return {v.x, v.y, v.z}; }

nlohmann::json to_json(const Camera& camera) {
    nlohmann::json json = {{"source", camera.source}, {"centre", to_json(camera.centre)}};
    if (camera.has_rays)
        json.update({{"axis", to_json(camera.axis)}, {"right", to_json(camera.right)}, {"up", to_json(camera.up)}});
    return json;
}

}  // namespace

std::vector<Possibility> possibilities(const AovFrame& frame) {
    const Missing overlay = missing_for_overlay(frame);
    const Missing beauty = missing_roles(frame, {Role::beauty});
    const bool has_ids = frame.has(Role::object_id) || frame.has(Role::material_id);
    return {
        {"add", "overlay over the frame", overlay},
        {"lights", "cube maps, mirrors, area lights and traced scenes around the objects", overlay},
        {"replace", "overlay in place of the rendered specular", overlay + beauty + missing_specular(frame)},
        {"difference", "new minus old material over the frame", overlay + beauty},
        {"diffuse", "the diffuse part from its passes", missing_diffuse(frame)},
        {"objects", "materials by object or material index", unless(has_ids, "object_id or material_id")},
        {"cryptomatte", "materials by object name", unless(!frame.cryptomattes.empty(), "a cryptomatte")},
        {"anisotropy", "stretched highlights along the tangent", missing_roles(frame, {Role::tangent})},
    };
}

std::string describe(const AovFrame& frame) {
    std::string text =
        frame.file + "\n  data " + size_text(frame.data_window) + ", display " + size_text(frame.display_window) + "\n";
    for (const std::string& note : frame.notes) text += "  " + note + "\n";
    for (const std::string& warning : frame.warnings) text += "  warning: " + warning + "\n";
    text += "jobs\n";
    for (const Possibility& job : possibilities(frame)) {
        text += "  " + job.name + std::string(12 - job.name.size(), ' ');
        text += (job.missing.empty() ? "yes: " + job.help : "no:  " + job.help + " needs " + join(job.missing)) + "\n";
    }
    return text;
}

nlohmann::json describe_json(const AovFrame& frame) {
    nlohmann::json json = {{"file", frame.file},
                           {"renderer", renderer_name(frame.renderer)},
                           {"data_window", to_json(frame.data_window)},
                           {"display_window", to_json(frame.display_window)},
                           {"roles", nlohmann::json::array()},
                           {"cryptomattes", nlohmann::json::array()},
                           {"camera", frame.camera ? to_json(*frame.camera) : nlohmann::json()},
                           {"notes", frame.notes},
                           {"warnings", frame.warnings},
                           {"jobs", nlohmann::json::object()}};
    for (const auto& [role, image] : frame.layers) json["roles"].push_back(role_info(role).name);
    for (const Cryptomatte& matte : frame.cryptomattes) json["cryptomattes"].push_back(matte.name);
    for (const Possibility& job : possibilities(frame))
        json["jobs"][job.name] = {{"possible", job.missing.empty()}, {"missing", job.missing}};
    // Names come from files and may hold any bytes; JSON must be UTF-8.
    return nlohmann::json::parse(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace burnish
