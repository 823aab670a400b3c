#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>
#include <burnish/material/library.h>
#include <burnish/presets_json.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace burnish {

namespace {

using nlohmann::json;

constexpr std::uintmax_t kLargestFile = 1 << 20;  // bytes; a material is a page of text

std::vector<Material> parsed_presets() {
    std::vector<Material> all;
    const json presets = json::parse(kPresetsJson);  // an object's keys come sorted
    for (const auto& [name, value] : presets.items()) all.push_back(material_from_json(value, name, "preset " + name));
    return all;
}

json parsed_file(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::error_code failed;
    const std::uintmax_t size = std::filesystem::file_size(file, failed);
    if (failed) throw Error(ErrorCode::read_failed, name + ": cannot read the material: " + failed.message());
    if (size > kLargestFile)
        throw Error(ErrorCode::read_failed,
                    name + ": expected a material of at most 1 MB, found " + std::to_string(size) + " bytes");
    std::ifstream stream(file);
    if (!stream) throw Error(ErrorCode::read_failed, name + ": cannot open the material; check its permissions");
    try {
        return json::parse(stream);
    } catch (const json::exception& problem) {
        throw Error(ErrorCode::read_failed, name + ": not valid JSON: " + problem.what());
    }
}

}  // namespace

std::span<const Material> presets() {
    static const std::vector<Material> all = parsed_presets();
    return all;
}

Material find_material(const std::string& name_or_file) {
    const auto preset = std::ranges::find(presets(), name_or_file, &Material::name);
    if (preset != presets().end()) return *preset;
    const std::filesystem::path file(name_or_file);
    std::error_code absent;
    if (file.extension() == ".json" || std::filesystem::is_regular_file(file, absent))
        return material_from_json(parsed_file(file), file.stem().string(), name_or_file);
    std::vector<std::string_view> known;
    for (const Material& material : presets()) known.push_back(material.name);
    known.push_back("a path to a .json file");
    fail_unknown("material", "name", name_or_file, known);
}

}  // namespace burnish
