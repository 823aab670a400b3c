#include <burnish/base/json_text.h>
#include <burnish/job/setting_kinds.h>
#include <burnish/job/shot_file.h>

#include <algorithm>

namespace burnish {
namespace {

using nlohmann::json;

constexpr std::string_view kLights = "lights", kLightName = "sky", kLightType = "environment";

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

bool is_section(std::string_view key) {
    const auto table = settings();
    return !key.empty() && std::any_of(table.begin(), table.end(), [&](const Setting& s) { return s.section == key; });
}

const json& object(const json& value, const std::string& where) {
    if (!value.is_object()) fail_expected(where, "an object {...}", value);
    return value;
}

/// A path as the shot file means it: relative to its folder.
json resolved(const Setting& setting, const json& value, const std::filesystem::path& folder) {
    if (setting.kind != SettingKind::path || !value.is_string()) return value;
    const auto text = value.get<std::string>();
    const bool inline_json = text.starts_with('{');
    if (text.empty() || folder.empty() || inline_json || std::filesystem::path(text).is_absolute()) return value;
    return (folder / text).string();
}

struct Reader {
    Job& job;
    const std::filesystem::path& folder;

    void field(std::string_view section, const std::string& key, const json& value, const std::string& where) {
        const Setting* setting = find_setting(section, key);
        if (!setting) fail_unknown(where, "field", key, known_keys(section));
        setting->set(job, resolved(*setting, value, folder), where + (section.empty() ? ": " : ".") + key);
    }

    void section(std::string_view name, const json& values, const std::string& where) {
        for (const auto& [key, value] : object(values, where).items()) field(name, key, value, where);
    }

    /// One light of type environment; the type may be left out.
    void lights(const json& values, const std::string& where) {
        if (object(values, where).size() > 1)
            throw Error(ErrorCode::bad_argument, where + ": expected one light, found " + std::to_string(values.size()));
        for (const auto& [name, light] : values.items()) {
            const std::string path = where + "." + name;
            json fields = object(light, path);
            if (fields.contains("type")) setting::checked_choice(fields["type"], {kLightType}, path + ".type");
            fields.erase("type");
            section(kLights, fields, path);
        }
    }
};

}  // namespace

Job job_from_json(const json& document, const std::string& where, const std::filesystem::path& folder) {
    Job job;
    Reader reader{job, folder};
    for (const auto& [key, value] : object(document, where).items()) {
        if (key == "$schema") continue;
        const std::string path = where + ": " + key;
        if (key == kLights)
            reader.lights(value, path);
        else if (is_section(key))
            reader.section(key, value, path);
        else
            reader.field("", key, value, where);
    }
    return job;
}

json job_to_json(const Job& job) {
    json document = json::object();
    for (const Setting& setting : settings()) {
        json value = setting.get(job);
        if (value == setting.default_value()) continue;
        const std::string section(setting.section), key(setting.key);
        if (section.empty())
            document[key] = std::move(value);
        else if (section == kLights)
            document[section][std::string(kLightName)][key] = std::move(value);
        else
            document[section][key] = std::move(value);
    }
    return document;
}

Job read_shot_file(const std::string& file) {
    return job_from_json(read_json(file, "shot file"), file, std::filesystem::path(file).parent_path());
}

}  // namespace burnish
