#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>
#include <burnish/base/json_text.h>
#include <burnish/material/import/import_material.h>
#include <burnish/material/library.h>
#include <burnish/material/measured/read_measured.h>
#include <burnish/material/measured/table_files.h>
#include <burnish/material/measured_library.h>
#include <burnish/presets_json.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace burnish {

namespace {

using nlohmann::json;

std::vector<Material> parsed_presets() {
    std::vector<Material> all;
    const json presets = json::parse(kPresetsJson);  // an object's keys come sorted
    for (const auto& [name, value] : presets.items()) all.push_back(material_from_json(value, name, "preset " + name));
    return all;
}

}  // namespace

std::span<const Material> presets() {
    static const std::vector<Material> all = parsed_presets();
    return all;
}

Material find_material(const std::string& name_or_file) {
    const auto preset = std::ranges::find(presets(), name_or_file, &Material::name);
    if (preset != presets().end()) return *preset;
    if (is_library_name(name_or_file)) return library_material(name_or_file);
    const std::filesystem::path file(name_or_file);
    std::error_code absent;
    if (is_import_name(name_or_file)) return import_material(name_or_file);
    if (is_measured_name(name_or_file)) return table_material(read_measured(name_or_file), file.stem().string());
    if (file.extension() == ".json" || std::filesystem::is_regular_file(file, absent))
        return material_from_json(with_tables_in(read_json(name_or_file, "material"), file.parent_path()), file.stem().string(),
                                  name_or_file);
    if (const std::string measured = "merl:" + name_or_file;
        std::ranges::find(library_names(), measured) != library_names().end())
        throw Error(ErrorCode::bad_argument,
                    "material: unknown name \"" + name_or_file + "\" (did you mean \"" + measured + "\"?)");
    std::vector<std::string_view> known;
    for (const Material& material : presets()) known.push_back(material.name);
    known.insert(known.end(),
                 {"merl:NAME of \"burnish models\"", "a path to a .json, .gltf, .glb or .mtlx file or a measurement"});
    fail_unknown("material", "name", name_or_file, known);
}

}  // namespace burnish
