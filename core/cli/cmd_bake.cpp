// burnish bake: cube maps, mirror pictures and AOVs of a scene, and a shot file that lights with them.
#include "command.h"
#include "progress_display.h"

#include <burnish/base/error.h>
#include <burnish/base/json_text.h>
#include <burnish/base/parallel.h>
#include <burnish/job/bake.h>

#include <nlohmann/json.hpp>

#include <charconv>
#include <cstdio>
#include <memory>

namespace burnish::cli {
namespace {

using nlohmann::json;

/// Flags as the JSON form of the job (bake_job.h), which says what is wrong with them.
struct Options {
    std::string scene, progress = "auto";
    json values = json::object();
    int threads = 0;
    bool as_json = false;
};

json numbers(const std::string& text, const std::string& flag) {
    json list = json::array();
    for (size_t begin = 0; begin <= text.size();) {
        const size_t end = std::min(text.find(',', begin), text.size());
        double value = 0;
        const auto read = std::from_chars(text.data() + begin, text.data() + end, value);
        if (read.ec != std::errc() || read.ptr != text.data() + end)
            throw CLI::ValidationError(flag, "expected numbers with commas between, found '" + text + "'");
        list.push_back(value);
        begin = end + 1;
    }
    return list;
}

/// "NAME" or "NAME=numbers".
std::pair<std::string, json> named_numbers(const std::string& text, size_t count, const std::string& flag) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos) return {text, json()};
    json list = numbers(text.substr(equals + 1), flag);
    if (list.size() != count)
        throw CLI::ValidationError(flag, "expected " + std::to_string(count) + " numbers after the =, found '" + text + "'");
    return {text.substr(0, equals), list};
}

void add_cube(json& values, const std::string& text) {
    const auto [name, centre] = named_numbers(text, 3, "--cube");
    values["cubes"].push_back({{"object", name}});
    if (!centre.is_null()) values["cubes"].back()["centre"] = centre;
}

void add_mirror(json& values, const std::string& text, bool behind) {
    const auto [name, plane] = named_numbers(text, 6, behind ? "--behind" : "--mirror");
    json mirror = {{"object", name}, {"behind", behind}};
    if (!plane.is_null())
        mirror["plane"] = {{"point", {plane[0], plane[1], plane[2]}}, {"normal", {plane[3], plane[4], plane[5]}}};
    values["mirrors"].push_back(std::move(mirror));
}

void set_size(json& values, const std::string& text) {
    const size_t x = text.find('x');
    const auto whole = [&](std::string_view part) {
        int value = 0;
        const auto read = std::from_chars(part.data(), part.data() + part.size(), value);
        if (read.ec != std::errc() || read.ptr != part.data() + part.size())
            throw CLI::ValidationError("--size", "expected WIDTHxHEIGHT, found '" + text + "'");
        return value;
    };
    if (x == std::string::npos) throw CLI::ValidationError("--size", "expected WIDTHxHEIGHT, found '" + text + "'");
    values["size"] = {whole(std::string_view(text).substr(0, x)), whole(std::string_view(text).substr(x + 1))};
}

BakeJob job_of(const Options& options) {
    if (!options.scene.ends_with(".json")) {
        json values = options.values;
        values["scene"] = options.scene;
        return bake_job_from_json(values, "burnish bake");
    }
    const std::filesystem::path folder = std::filesystem::path(options.scene).parent_path();
    json document = read_json(options.scene, "bake description");
    if (!document.is_object()) return bake_job_from_json(document, options.scene, folder);
    json flags = options.values;
    for (const char* file : {"output", "camera"})
        if (flags.contains(file) && !flags[file].get_ref<const std::string&>().starts_with('{'))
            flags[file] = std::filesystem::absolute(flags[file].get<std::string>()).string();
    document.update(flags);
    return bake_job_from_json(document, options.scene, folder);
}

void print(const BakeJob& job, const BakeReport& report, bool as_json) {
    double total = 0;
    for (const auto& [stage, seconds] : report.seconds) total += seconds;
    if (as_json) {
        nlohmann::ordered_json out;
        for (const std::string& file : report.files)
            out["files"].push_back((std::filesystem::path(job.folder) / file).string());
        for (const auto& [stage, seconds] : report.seconds) out["seconds"][stage] = seconds;
        out["seconds"]["total"] = total;
        std::printf("%s\n", out.dump(2).c_str());
        return;
    }
    for (const std::string& file : report.files) std::printf("%s\n", (std::filesystem::path(job.folder) / file).c_str());
    std::printf("\n");
    for (const auto& [stage, seconds] : report.seconds) std::printf("%-12s %7.2f s\n", stage.c_str(), seconds);
    std::printf("%-12s %7.2f s\n", "together", total);
}

int run_bake(const Options& options) {
    const BakeJob job = job_of(options);
    const ThreadLimit limit(options.threads);
    BakeReport report;
    {
        ProgressDisplay display(options.progress);
        report = bake(job, display.progress());
    }
    print(job, report, options.as_json);
    return 0;
}

void add_pictures(CLI::App& command, json& values) {
    const auto text = [&](const char* flag, const char* help, const char* type, auto set) {
        command.add_option_function<std::string>(flag, set, help)->type_name(type);
    };
    const auto each = [&](const char* flag, const char* help, const char* type, auto add) {
        const auto all = [add](const std::vector<std::string>& items) {
            for (const std::string& item : items) add(item);
        };
        command.add_option_function<std::vector<std::string>>(flag, all, help)->type_name(type)->allow_extra_args(false);
    };
    text("--camera", "camera of the AOVs and mirrors, a JSON file or the JSON itself", "FILE",
         [&](const std::string& f) { values["camera"] = f; });
    text("--size", "of AOVs and mirrors in pixels [1920x1080]", "WxH", [&](const std::string& s) { set_size(values, s); });
    each("--cube", "cube map around an object (* and ? allowed: one for each), or from a point in scene units", "NAME[=X,Y,Z]",
         [&](const std::string& cube) { add_cube(values, cube); });
    each("--mirror", "what the object's largest flat side mirrors, or the plane through a point with a normal",
         "NAME[=PX,PY,PZ,NX,NY,NZ]", [&](const std::string& mirror) { add_mirror(values, mirror, false); });
    each("--behind", "what the camera sees through a pane", "NAME[=PX,PY,PZ,NX,NY,NZ]",
         [&](const std::string& pane) { add_mirror(values, pane, true); });
    text("--panes", "objects that let light through: not in cube maps and mirrors", "NAMES",
         [&](const std::string& n) { values["panes"] = n; });
}

void add_light(CLI::App& command, json& values) {
    const auto map = [&](const char* flag, const char* key, const char* help) {
        command
            .add_option_function<std::string>(
                flag, [&values, key](const std::string& file) { values["light_maps"][key] = file; }, help)
            ->type_name("FILE");
    };
    map("--light-map", "radiance", "light map of radiance, emission included");
    map("--irradiance", "irradiance", "light map of irradiance / pi");
    map("--albedo", "albedo", "map of diffuse reflectance [the materials' base colours]");
    command.add_flag_callback(
        "--bake-light-maps", [&values] { values["light_maps"]["bake"] = true; },
        "light maps from the scene's own emissive materials");
    command
        .add_option_function<int>(
            "--light-map-size", [&values](int n) { values["light_maps"]["size"] = n; }, "texels a side [1024]")
        ->type_name("N");
    command
        .add_option_function<int>(
            "--texcoord", [&values](int n) { values["texcoord"] = n; }, "set of texture coordinates of the light maps [0]")
        ->type_name("N");
}

}  // namespace

Run add_bake(CLI::App& app) {
    auto* command =
        app.add_subcommand("bake", "Bakes a scene into cube maps, mirror pictures and AOVs, and writes a shot that uses them");
    auto options = std::make_shared<Options>();
    json& values = options->values;
    command
        ->add_option("SCENE", options->scene, "glTF or OBJ, or a JSON file that says all of this, flags having the last word")
        ->required();
    command
        ->add_option_function<std::string>(
            "-o,--output", [&values](const std::string& f) { values["output"] = f; }, "folder, made if absent")
        ->type_name("DIR");
    command
        ->add_option_function<std::string>(
            "--up", [&values](const std::string& up) { values["up"] = up; }, "axis that points up in the render's world [y]")
        ->check(CLI::IsMember({"y", "z"}));
    add_pictures(*command, values);
    add_light(*command, values);
    command
        ->add_option_function<int>(
            "--cube-size", [&values](int n) { values["cube_size"] = n; }, "texels along an edge of a cube map's face [256]")
        ->type_name("N");
    command
        ->add_option_function<int>(
            "--samples", [&values](int n) { values["samples"] = n; }, "rays a texel or pixel [4]")
        ->type_name("N");
    command->add_option("--threads", options->threads, "[all cores]")->check(CLI::Range(0, 1024))->type_name("N");
    command->add_option("--progress", options->progress, "on stderr [auto]")
        ->check(CLI::IsMember(std::vector<std::string>(std::begin(kProgressFormats), std::end(kProgressFormats))))
        ->type_name("FORMAT");
    command->add_flag("--json", options->as_json, "print files and times as JSON");
    command->footer(
        "Example: burnish bake room.glb --up z --light-map light.exr --camera cam.json --cube vase --mirror floor -o baked");
    return [options] { return run_bake(*options); };
}

}  // namespace burnish::cli
