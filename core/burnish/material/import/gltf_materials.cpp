#include <burnish/material/import/gltf_materials.h>

#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>
#include <burnish/material/import/gltf_file.h>
#include <burnish/material/import/surface_numbers.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace burnish {

using nlohmann::json;

namespace {

constexpr NumberRange kShare{0, 1}, kIndex{0, 100}, kColor{0, 1000}, kAngle{-100, 100};
constexpr std::array<std::string_view, 5> kRead{"KHR_materials_ior", "KHR_materials_specular", "KHR_materials_anisotropy",
                                                "KHR_materials_clearcoat", "KHR_materials_transmission"};

/// One material, its numbers with the defaults of the specification.
class GltfMaterialReader {
public:
    GltfMaterialReader(const json& material, const std::string& where)
        : m_material(material, where), m_extensions(child(m_material, "extensions")) {
        note_textures(material, where);
        for (const auto& [name, value] : m_extensions.items())
            if (std::ranges::find(kRead, name) == kRead.end())
                m_notes.push_back(where + ".extensions." + name + " is left out");
    }

    Material read(const std::string& name) {
        read_base();
        read_dielectric();
        read_coat();
        const JsonFields transmission = extension("KHR_materials_transmission");
        m_numbers.transmission = transmission.number("transmissionFactor", kShare, 0);
        m_numbers.transmission_color = m_numbers.base;
        Material material = material_of(name, m_numbers);
        material.notes = std::move(m_notes);
        return material;
    }

private:
    static const json& child(const JsonFields& parent, std::string_view key) {
        static const json kNone = json::object();
        if (!parent.has(key)) return kNone;
        const json& value = parent.at(key);
        if (!value.is_object()) fail_expected(parent.path(key), "an object {...}", value);
        return value;
    }

    JsonFields extension(std::string_view name) {
        const JsonFields extensions(m_extensions, m_material.path("extensions"));
        const json& value = child(extensions, name);
        note_textures(value, extensions.path(name));
        return JsonFields(value, extensions.path(name));
    }

    void note_textures(const json& object, const std::string& where) {
        for (const auto& [key, value] : object.items())
            if (key.ends_with("Texture")) m_notes.push_back(where + "." + key + " is left out: its factor holds everywhere");
    }

    void read_base() {
        const json& object = child(m_material, "pbrMetallicRoughness");
        const JsonFields pbr(object, m_material.path("pbrMetallicRoughness"));
        note_textures(object, m_material.path("pbrMetallicRoughness"));
        if (pbr.has("baseColorFactor")) m_numbers.base = opaque_color(pbr.at("baseColorFactor"), pbr.path("baseColorFactor"));
        m_numbers.metallic = pbr.number("metallicFactor", kShare, 1);
        const float roughness = pbr.number("roughnessFactor", kShare, 1);
        m_numbers.dielectric.alpha = Vec2f(roughness * roughness);
    }

    static Color3f opaque_color(const json& rgba, const std::string& where) {
        if (!rgba.is_array() || rgba.size() != 4) fail_expected(where, "four numbers [r, g, b, a]", rgba);
        const json rgb = {{"rgb", {rgba[0], rgba[1], rgba[2]}}};
        return JsonFields(rgb, where).color("rgb", kShare);
    }

    void read_dielectric() {
        Interface& face = m_numbers.dielectric;
        const float ior = extension("KHR_materials_ior").number("ior", kIndex, 1.5f);
        const JsonFields specular = extension("KHR_materials_specular");
        const float factor = specular.number("specularFactor", kShare, 1);
        const Color3f f0 = specular.color("specularColorFactor", kColor, Color3f(1)) * f0_of_ior(ior);
        for (int c = 0; c < 3; ++c) face.f0[c] = std::min(f0[c], 1.0f) * factor;
        face.f90 = Color3f(factor);
        const JsonFields anisotropy = extension("KHR_materials_anisotropy");
        const float strength = anisotropy.number("anisotropyStrength", kShare, 0);
        face.alpha.x += (1 - face.alpha.x) * strength * strength;
        face.rotation = anisotropy.number("anisotropyRotation", kAngle, 0);
    }

    void read_coat() {
        const JsonFields coat = extension("KHR_materials_clearcoat");
        m_numbers.coat_weight = coat.number("clearcoatFactor", kShare, 0);
        const float roughness = coat.number("clearcoatRoughnessFactor", kShare, 0);
        m_numbers.coat.alpha = Vec2f(roughness * roughness);
    }

    JsonFields m_material;
    const json& m_extensions;
    SurfaceNumbers m_numbers;
    std::vector<std::string> m_notes;
};

}  // namespace

std::vector<Material> gltf_materials(const std::string& file) {
    const json document = read_gltf(file);
    const json list = document.value("materials", json::array());
    if (!list.is_array()) fail_expected(file + ": materials", "a list", list);
    std::vector<Material> materials;
    for (size_t i = 0; i < list.size(); ++i) {
        const std::string where = file + ": materials[" + std::to_string(i) + "]";
        const JsonFields fields(list[i], where);
        const std::string name = fields.has("name") ? fields.text("name") : "";
        materials.push_back(GltfMaterialReader(list[i], where).read(name.empty() ? "material_" + std::to_string(i) : name));
    }
    return materials;
}

}  // namespace burnish
