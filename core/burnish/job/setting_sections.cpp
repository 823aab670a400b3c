#include <burnish/job/setting_sections.h>

#include <burnish/material/import/import_material.h>
#include <burnish/material/measured/read_measured.h>
#include <burnish/material/measured/table_files.h>

#include <algorithm>

namespace burnish {
namespace {

using nlohmann::json;

const Setting* find_setting(std::string_view section, std::string_view key) {
    const auto table = settings();
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const Setting& s) { return s.section == section && s.key == key; });
    return found == table.end() ? nullptr : &*found;
}

std::vector<std::string_view> known_keys(std::string_view section) {
    std::vector<std::string_view> keys;
    for (const Setting& setting : settings()) {
        const std::string_view key = setting.section == section ? setting.key : section.empty() ? setting.section : "";
        if (!key.empty() && std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    }
    return keys;
}

bool names_file(const std::string& material) { return is_measured_name(material) || is_import_name(material); }

/// The value with its paths as from `folder`.
json with_paths_in(const Setting& setting, const json& value, const std::filesystem::path& folder) {
    if (setting.kind == SettingKind::path && value.is_string()) return in_folder(value.get<std::string>(), folder);
    const bool is_files = setting.kind == SettingKind::pairs && setting.unit.ends_with("FILE");
    if ((setting.kind != SettingKind::materials && !is_files) || !value.is_object()) return value;
    json materials = json::object();
    for (const auto& [name, material] : value.items())
        materials[name] = material.is_string() && (is_files || names_file(material.get<std::string>()))
                              ? json(in_folder(material.get<std::string>(), folder))
                              : with_tables_in(material, folder);
    return materials;
}

}  // namespace

bool is_section(std::string_view key) {
    const auto table = settings();
    return !key.empty() && std::any_of(table.begin(), table.end(), [&](const Setting& s) { return s.section == key; });
}

void set_field(Job& job, std::string_view section, const std::string& key, const json& value, const std::string& where,
               const std::filesystem::path& folder) {
    const Setting* setting = find_setting(section, key);
    if (!setting) fail_unknown(where, "field", key, known_keys(section));
    setting->set(job, with_paths_in(*setting, value, folder), where + (section.empty() ? ": " : ".") + key);
}

void set_section(Job& job, std::string_view section, const json& fields, const std::string& where,
                 const std::filesystem::path& folder) {
    if (!fields.is_object()) fail_expected(where, "an object {...}", fields);
    for (const auto& [key, value] : fields.items()) set_field(job, section, key, value, where, folder);
}

std::string in_folder(const std::string& path, const std::filesystem::path& folder) {
    const bool is_json = path.starts_with('{');
    if (path.empty() || folder.empty() || is_json || std::filesystem::path(path).is_absolute()) return path;
    return (folder / path).string();
}

}  // namespace burnish
