#include <burnish/material/import/materialx_file.h>

#include <burnish/base/error.h>
#include <burnish/material/import/materialx_inputs.h>
#include <burnish/material/import/surface_numbers.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <numbers>

namespace burnish {
namespace {

constexpr NumberRange kShare{0, 1}, kIndex{0, 100}, kColor{0, 1000}, kTurn{-100, 100};
constexpr float kWholeTurn = 2 * std::numbers::pi_v<float>;
constexpr uintmax_t kLargestFile = 64 << 20;  // bytes

[[noreturn]] void refuse(const std::string& file, const std::string& problem) {
    throw Error(ErrorCode::read_failed, file + ": " + problem);
}

/// MaterialX's own roughness_anisotropy.
Vec2f standard_widths(float roughness, float anisotropy) {
    const float r2 = roughness * roughness, aspect = std::sqrt(1 - std::min(anisotropy, 0.98f));
    return {std::min(r2 / aspect, 1.0f), r2 * aspect};
}

/// OpenPBR's: both widths change, and what they scatter together stays.
Vec2f openpbr_widths(float roughness, float anisotropy) {
    const float b = 1 - anisotropy, t = roughness * roughness * std::sqrt(2 / (1 + b * b));
    return {t, b * t};
}

SurfaceNumbers standard_surface(MaterialxInputs& in, bool is_first_version) {
    SurfaceNumbers n;
    n.base = in.color("base_color", kShare, Color3f(is_first_version ? 1.0f : 0.8f)) *
             in.number("base", kShare, is_first_version ? 0.8f : 1.0f);
    n.metallic = in.number("metalness", kShare, 0);
    n.dielectric.f90 = in.color("specular_color", kColor, Color3f(1)) * in.number("specular", kShare, 1);
    n.dielectric.f0 = n.dielectric.f90 * f0_of_ior(in.number("specular_IOR", kIndex, 1.5f));
    n.dielectric.alpha =
        standard_widths(in.number("specular_roughness", kShare, 0.2f), in.number("specular_anisotropy", kShare, 0));
    n.dielectric.rotation = in.number("specular_rotation", kTurn, 0) * kWholeTurn;
    n.transmission = in.number("transmission", kShare, 0);
    n.transmission_color = in.color("transmission_color", kColor, Color3f(1));
    n.coat_weight = in.number("coat", kShare, 0);
    n.coat.f0 = Color3f(f0_of_ior(in.number("coat_IOR", kIndex, 1.5f)));
    n.coat.alpha = standard_widths(in.number("coat_roughness", kShare, 0.1f), in.number("coat_anisotropy", kShare, 0));
    n.coat.rotation = in.number("coat_rotation", kTurn, 0) * kWholeTurn;
    n.coat_color = in.color("coat_color", kShare, Color3f(1));
    return n;
}

SurfaceNumbers open_pbr_surface(MaterialxInputs& in) {
    SurfaceNumbers n;
    n.base = in.color("base_color", kShare, Color3f(0.8f)) * in.number("base_weight", kShare, 1);
    n.metallic = in.number("base_metalness", kShare, 0);
    n.dielectric.f90 = in.color("specular_color", kColor, Color3f(1));
    const float f0 = in.number("specular_weight", kShare, 1) * f0_of_ior(in.number("specular_ior", kIndex, 1.5f));
    n.dielectric.f0 = n.dielectric.f90 * f0;
    n.dielectric.alpha =
        openpbr_widths(in.number("specular_roughness", kShare, 0.3f), in.number("specular_roughness_anisotropy", kShare, 0));
    n.transmission = in.number("transmission_weight", kShare, 0);
    n.transmission_color = in.color("transmission_color", kColor, Color3f(1));
    n.coat_weight = in.number("coat_weight", kShare, 0);
    n.coat.f0 = Color3f(f0_of_ior(in.number("coat_ior", kIndex, 1.6f)));
    n.coat.alpha = openpbr_widths(in.number("coat_roughness", kShare, 0), in.number("coat_roughness_anisotropy", kShare, 0));
    n.coat_color = in.color("coat_color", kShare, Color3f(1));
    return n;
}

bool is_known_shader(pugi::xml_node node) {
    return std::strcmp(node.name(), "standard_surface") == 0 || std::strcmp(node.name(), "open_pbr_surface") == 0;
}

Material material_from(pugi::xml_node shader, const std::string& name, const std::string& file) {
    MaterialxInputs inputs(shader, file + ": " + shader.attribute("name").value());
    const bool is_standard = std::strcmp(shader.name(), "standard_surface") == 0;
    const bool is_first_version = std::strcmp(shader.attribute("version").value(), "1.0.0") == 0;
    const SurfaceNumbers numbers = is_standard ? standard_surface(inputs, is_first_version) : open_pbr_surface(inputs);
    Material material = material_of(name, numbers);
    material.notes = inputs.notes();
    return material;
}

pugi::xml_node shader_of(pugi::xml_node document, pugi::xml_node material, const std::string& file) {
    const pugi::xml_node input = material.find_child_by_attribute("input", "name", "surfaceshader");
    const char* wanted = input.attribute("nodename").value();
    for (const pugi::xml_node node : document.children()) {
        if (std::strcmp(node.attribute("name").value(), wanted) != 0 || !*wanted) continue;
        if (is_known_shader(node)) return node;
        refuse(file, std::string(material.attribute("name").value()) +
                         ": expected standard_surface or open_pbr_surface, found " + node.name() +
                         "; convert the material to one of these");
    }
    refuse(file, std::string(material.attribute("name").value()) + ": expected a surfaceshader of this file, found '" + wanted +
                     "'; export the material with its shader");
}

}  // namespace

std::vector<Material> materialx_materials(const std::string& file) {
    std::error_code error;
    const uintmax_t size = std::filesystem::file_size(file, error);
    if (error) refuse(file, "cannot be read (" + error.message() + "); check its path and permissions");
    if (size > kLargestFile) refuse(file, "is larger than the 64 MiB of XML burnish reads; leave out what is no material");
    pugi::xml_document xml;
    const pugi::xml_parse_result parsed = xml.load_file(file.c_str());
    if (!parsed)
        refuse(file, std::string("is not XML: ") + parsed.description() + " near byte " + std::to_string(parsed.offset) +
                         "; export it again");
    const pugi::xml_node document = xml.child("materialx");
    if (!document) refuse(file, "expected a <materialx> document, found none; is it MaterialX?");
    std::vector<Material> materials;
    std::vector<pugi::xml_node> worn;
    for (const pugi::xml_node node : document.children("surfacematerial")) {
        worn.push_back(shader_of(document, node, file));
        materials.push_back(material_from(worn.back(), node.attribute("name").value(), file));
    }
    for (const pugi::xml_node node : document.children())
        if (is_known_shader(node) && std::ranges::find(worn, node) == worn.end())
            materials.push_back(material_from(node, node.attribute("name").value(), file));
    return materials;
}

}  // namespace burnish
