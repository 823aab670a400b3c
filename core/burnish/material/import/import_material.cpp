#include <burnish/material/import/import_material.h>

#include <burnish/base/error.h>
#include <burnish/base/nearest_name.h>
#include <burnish/material/import/gltf_materials.h>
#include <burnish/material/import/materialx_file.h>
#include <burnish/material/library.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace burnish {
namespace {

/// "car.gltf" and "paint" of "car.gltf#paint".
struct Reference {
    std::string file, name;

    explicit Reference(const std::string& text) {
        const size_t hash = text.rfind('#');
        file = text.substr(0, hash);
        if (hash != std::string::npos) name = text.substr(hash + 1);
    }
    std::string extension() const { return std::filesystem::path(file).extension().string(); }
};

std::string names_of(const std::vector<Material>& materials) {
    constexpr size_t kLongestList = 20;
    std::string text;
    for (size_t i = 0; i < std::min(materials.size(), kLongestList); ++i) text += (i ? ", " : "") + materials[i].name;
    return text + (materials.size() > kLongestList ? " and " + std::to_string(materials.size() - kLongestList) + " more" : "");
}

}  // namespace

bool is_import_name(const std::string& text) {
    const std::string extension = Reference(text).extension();
    return extension == ".gltf" || extension == ".glb" || extension == ".mtlx";
}

std::vector<Material> read_materials(const std::string& file) {
    std::vector<Material> materials = Reference(file).extension() == ".mtlx" ? materialx_materials(file) : gltf_materials(file);
    if (materials.empty())
        throw Error(ErrorCode::read_failed, file + ": expected materials, found none; export them with the file");
    return materials;
}

nlohmann::json materials_json(const std::string& file) {
    nlohmann::json list = nlohmann::json::array();
    for (const Material& material : read_materials(file))
        list.push_back({{"name", material.name}, {"material", material_to_json(material)}, {"notes", material.notes}});
    return nlohmann::json::parse(list.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

Material import_material(const std::string& text) {
    const Reference reference(text);
    const std::vector<Material> materials = read_materials(reference.file);
    if (reference.name.empty() && materials.size() == 1) return materials.front();
    const auto found = std::ranges::find(materials, reference.name, &Material::name);
    if (found != materials.end() && !reference.name.empty()) return *found;
    if (reference.name.empty())
        throw Error(ErrorCode::bad_argument, reference.file + ": holds " + std::to_string(materials.size()) +
                                                 " materials; choose one as in " + reference.file + "#" +
                                                 materials.front().name + "; it has " + names_of(materials));
    std::vector<std::string_view> known;
    for (const Material& material : materials) known.push_back(material.name);
    throw Error(ErrorCode::bad_argument, reference.file + ": has no material \"" + reference.name + "\"" +
                                             did_you_mean(reference.name, known) + "; it has " + names_of(materials));
}

}  // namespace burnish
