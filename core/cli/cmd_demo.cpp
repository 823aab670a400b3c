// burnish demo: makes a shot, lays the overlay over it, and leaves everything in a folder to look at and to play with.
#include "command.h"
#include "demo_room_shot.h"
#include "demo_shot.h"
#include "progress_display.h"

#include <burnish/base/error.h>
#include <burnish/input/exr_reader.h>
#include <burnish/job/run.h>
#include <burnish/job/shot_file.h>
#include <burnish/job/stages.h>
#include <burnish/output/preview.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace burnish::cli {
namespace {

struct Options {
    std::string folder, scene = "table";
    int width = 1280, height = 720;
    bool as_json = false;
};

using Files = std::vector<std::pair<std::string, std::string>>;

struct Result {
    std::filesystem::path folder;
    NamedValues<double> seconds;  // stages in the order they ran
    Files lights;                 // and what they are
    Report report;

    std::string file(const std::string& name) const { return (folder / name).string(); }
};

/// All files, for people.
Files all_files(const Result& result) {
    Files files = {{"before_after.png", "the picture without and with its overlay"},
                   {"before.png", "the render: diffuse light only"},
                   {"after.png", "the same with the overlay"},
                   {"out.exr", "the composited frame, layer burnish_spec the overlay alone"},
                   {"shot.exr", "the render with its AOVs"}};
    files.insert(files.end(), result.lights.begin(), result.lights.end());
    files.emplace_back("shot.json", "materials and who wears them: change them, then run the command below");
    files.emplace_back("report.json", "what was found and done");
    return files;
}

std::string what_is(const std::string& baked) {
    if (baked.starts_with("cube_")) return "the room as seen from one object";
    if (baked.starts_with("mirror_")) return "the room as one mirror shows it";
    if (baked.starts_with("behind_")) return "what is behind one pane";
    return baked.ends_with(".glb") ? "the room" : "its light map";
}

/// Every pixel the mean of 2 x 2.
Image halved(const Image& image) {
    Image half(image.width / 2, image.height / 2, image.channels);
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
            for (int c = 0; c < image.channels; ++c) {
                const float top = image.at(2 * x, 2 * y)[c] + image.at(2 * x + 1, 2 * y)[c];
                const float bottom = image.at(2 * x, 2 * y + 1)[c] + image.at(2 * x + 1, 2 * y + 1)[c];
                half.at(x, y)[c] = 0.25f * (top + bottom);
            }
    return half;
}

void make_shot(const Options& options, const Progress& progress, Result& result) {
    if (options.scene == "table") {
        write_demo_shot(result.folder, options.width, options.height, progress, result.seconds);
        result.lights = {{"sky.exr", "the light around it"}};
        return;
    }
    const BakeReport baked = write_demo_room_shot(result.folder, options.width, options.height, progress);
    result.seconds = baked.seconds;
    for (const std::string& file : baked.files)
        if (!file.starts_with("shot.")) result.lights.emplace_back(file, what_is(file));
}

Image beauty(const std::string& file) {
    ReadOptions beauty_only;
    beauty_only.roles = {Role::beauty};
    return read_frame(file, beauty_only).layer(Role::beauty);
}

Result make_demo(const Options& options, const Progress& progress) {
    Result result;
    result.folder = options.folder;
    std::error_code error;
    std::filesystem::create_directories(result.folder, error);
    if (error) throw Error(ErrorCode::write_failed, options.folder + ": cannot make this folder (" + error.message() + ")");
    make_shot(options, part_of(progress, 0.0f, 0.6f), result);
    result.report = run(read_shot_file(result.file("shot.json")), part_of(progress, 0.6f, 1.0f));
    timed(result.seconds, "write pictures", [&] {
        const Image before = beauty(result.file("shot.exr")), after = beauty(result.file("out.exr"));
        const PreviewSettings look;
        write_preview(result.file("before.png"), before, look);
        write_before_after(result.file("before_after.png"), halved(before), halved(after), look);
    });
    return result;
}

/// All stages in the order they ran: the demo's own, then those of the job.
NamedValues<double> all_seconds(const Result& result) {
    NamedValues<double> all(result.seconds.begin(), result.seconds.end() - 1);
    for (const auto& [stage, seconds] : result.report.seconds)
        if (stage != "total") all.emplace_back(stage, seconds);
    const auto& frame = result.report.frames.front().seconds;
    all.insert(all.end(), frame.begin(), frame.end());
    all.push_back(result.seconds.back());
    return all;
}

void print_json(const Result& result) {
    nlohmann::ordered_json json;
    for (const auto& [name, what] : all_files(result)) json["files"][name] = result.file(name);
    for (const auto& [stage, seconds] : all_seconds(result)) json["seconds"][stage] = seconds;
    json["report"] = report_to_json(result.report);
    std::printf("%s\n", json.dump(2).c_str());
}

void print_text(const Result& result) {
    double total = 0;
    for (const auto& [name, what] : all_files(result)) std::printf("%-24s %s\n", result.file(name).c_str(), what.c_str());
    std::printf("\n");
    for (const auto& [stage, seconds] : all_seconds(result)) {
        std::printf("%-16s %6.2f s\n", stage.c_str(), seconds);
        total += seconds;
    }
    std::printf("%-16s %6.2f s\n\nagain: burnish composite %s\n", "together", total, result.file("shot.json").c_str());
}

int demo(const Options& options) {
    Result result;
    {
        ProgressDisplay display("auto");
        result = make_demo(options, display.progress());
    }
    options.as_json ? print_json(result) : print_text(result);
    return exit_code(result.report);
}

}  // namespace

Run add_demo(CLI::App& app) {
    auto* command = app.add_subcommand("demo", "Makes a shot to play with and shows it without and with its overlay");
    auto options = std::make_shared<Options>();
    command->add_option("-o,--output", options->folder, "folder for pictures and shot, made if absent")
        ->required()
        ->type_name("DIR");
    command
        ->add_option("--scene", options->scene, "table, under a sky, or room, with cube maps and mirrors baked for it [table]")
        ->check(CLI::IsMember({"table", "room"}));
    command->add_option("--width", options->width, "of the picture [1280]")->check(CLI::Range(16, 8192))->type_name("PIXELS");
    command->add_option("--height", options->height, "of the picture [720]")->check(CLI::Range(16, 8192))->type_name("PIXELS");
    command->add_flag("--json", options->as_json, "print files, times and report as JSON");
    command->footer("Example: burnish demo -o demo");
    return [options] { return demo(*options); };
}

}  // namespace burnish::cli
