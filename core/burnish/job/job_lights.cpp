#include <burnish/job/job_lights.h>

#include <burnish/base/json_text.h>
#include <burnish/job/setting_sections.h>
#include <burnish/light/light_json.h>

#include <algorithm>
#include <iterator>

namespace burnish {
namespace {

using nlohmann::json;

constexpr std::string_view kEnvironment = "environment";

/// A light's object, wherever it stood.
struct GivenLight {
    json fields;
    std::string where;
    std::filesystem::path folder;

    GivenLight(const json& value, const std::string& path, const std::filesystem::path& own_folder)
        : fields(value), where(path), folder(own_folder) {
        if (!value.is_string()) return;
        const auto text = in_folder(value.get<std::string>(), folder);
        if (text.starts_with('{')) {
            fields = parse_json(text, where);
            return;
        }
        fields = read_json(text, "light");
        where += " (" + text + ")", folder = std::filesystem::path(text).parent_path();
    }

    std::string type() const {
        std::vector<std::string_view> types{kEnvironment};
        std::copy(std::begin(kNearLightTypes), std::end(kNearLightTypes), std::back_inserter(types));
        const JsonFields object(fields, where);
        return object.has("type") ? object.name("type", types) : std::string(kEnvironment);
    }
};

void check_name(const std::string& name, const std::string& where) {
    if (name.empty() || name == kAutomaticChain || name.find_first_of(",@=") != std::string::npos)
        throw Error(ErrorCode::bad_argument, where + ": '" + name + "' cannot be a light's name; take one other than '" +
                                                 std::string(kAutomaticChain) + "', without , @ and =");
}

LightSettings near_light(const GivenLight& given) {
    LightSettings light = light_from_json(given.fields, given.where);
    for_each_file(light, [&](std::string& file) { file = in_folder(file, given.folder); });
    return light;
}

void set_environment(Job& job, const std::string& name, GivenLight given) {
    given.fields.erase("type");
    job.environment_name = name;
    set_section(job, "lights", given.fields, given.where, given.folder);
}

json lights_to_json(const Job& job) {
    json lights = json::object();
    for (const auto& [name, light] : job.lights) lights[name] = light_to_json(light);
    return lights;
}

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts;
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = std::min(text.find(',', begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

}  // namespace

void set_lights(Job& job, const json& lights, const std::string& where, const std::filesystem::path& folder) {
    if (!lights.is_object()) fail_expected(where, "an object {\"name\": light}", lights);
    job.lights.clear();
    std::string environment;
    for (const auto& [name, value] : lights.items()) {
        const std::string path = where + "." + name;
        check_name(name, path);
        const GivenLight given(value, path, folder);
        if (given.type() != kEnvironment) {
            job.lights[name] = near_light(given);
            continue;
        }
        if (!environment.empty())
            throw Error(ErrorCode::bad_argument, path + ": a job has one environment, and '" + environment +
                                                     "' is one already; give the other lights their \"type\"");
        environment = name;
        set_environment(job, name, given);
    }
}

std::vector<std::string> chain_from_json(const json& value, const std::string& where) {
    if (value.is_string()) return split(value.get<std::string>());
    const auto is_name = [](const json& name) { return name.is_string() && !name.get<std::string>().empty(); };
    if (!value.is_array() || !std::all_of(value.begin(), value.end(), is_name))
        fail_expected(where, "a light's name, or a list of them", value);
    return value.get<std::vector<std::string>>();
}

std::string chain_to_text(const std::vector<std::string>& chain) {
    std::string text;
    for (const std::string& name : chain) text += (text.empty() ? "" : ",") + name;
    return text;
}

namespace setting {

Setting lights_setting() {
    constexpr auto help =
        "a light near the objects: JSON or its file, of type cubemap, mirror, area or traced (shot file: lights.NAME)";
    const auto set = [](Job& job, const json& value, const std::string& where) { set_lights(job, value, where); };
    return {"lights", "", "lights", SettingKind::lights, "NAME=JSON", help, lights_to_json, set};
}

Setting chain_setting() {
    constexpr auto help =
        "lights for what names none with @, the one in front first; auto: a mirror on its plane, area lights, the nearest cube "
        "map or what is traced, the environment";
    const auto get = [](const Job& job) { return json(chain_to_text(job.chain)); };
    const auto set = [](Job& job, const json& value, const std::string& where) { job.chain = chain_from_json(value, where); };
    return {"default_light", "", "light", SettingKind::text, "NAME,...", help, get, set};
}

}  // namespace setting

}  // namespace burnish
