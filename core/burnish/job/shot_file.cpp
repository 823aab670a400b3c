#include <burnish/base/json_text.h>
#include <burnish/job/job_lights.h>
#include <burnish/job/setting_sections.h>
#include <burnish/job/shot_file.h>

#include <nlohmann/json.hpp>

namespace burnish {
namespace {

using nlohmann::json;

constexpr std::string_view kLights = "lights";

}  // namespace

Job job_from_json(const json& document, const std::string& where, const std::filesystem::path& folder) {
    Job job;
    if (!document.is_object()) fail_expected(where, "an object {...}", document);
    for (const auto& [key, value] : document.items()) {
        if (key == "$schema") continue;
        const std::string path = where + ": " + key;
        if (key == kLights)
            set_lights(job, value, path, folder);
        else if (is_section(key))
            set_section(job, key, value, path, folder);
        else
            set_field(job, "", key, value, where, folder);
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
            document[section][job.environment_name][key] = std::move(value);
        else
            document[section][key] = std::move(value);
    }
    return document;
}

Job read_shot_file(const std::string& file) {
    return job_from_json(read_json(file, "shot file"), file, std::filesystem::path(file).parent_path());
}

}  // namespace burnish
