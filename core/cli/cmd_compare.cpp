// burnish compare: how far a picture is from its reference.
#include "command.h"

#include <burnish/input/exr_reader.h>
#include <burnish/output/compare.h>
#include <burnish/output/preview.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <memory>

namespace burnish::cli {
namespace {

struct Options {
    std::string test, reference, layer, reference_layer, mask, difference;
    bool as_json = false;
};

/// The picture of a file: a named layer, or its beauty.
AovFrame read_layer(const std::string& file, Role role, const std::string& layer) {
    ReadOptions options;
    options.roles = {role};
    if (!layer.empty()) options.channels[role] = layer;
    return read_frame(file, options);
}

void print_json(const Comparison& c) {
    const nlohmann::json psnr = std::isfinite(c.display_psnr_db) ? nlohmann::json(c.display_psnr_db) : nlohmann::json();
    const nlohmann::json out = {{"pixels", c.pixels},
                                {"non_finite", c.non_finite},
                                {"psnr_db", psnr},
                                {"relative_rms", c.relative_rms},
                                {"relmse", c.rel_mse},
                                {"largest_error", c.largest_error},
                                {"largest_at", {c.largest_x, c.largest_y}}};
    std::printf("%s\n", out.dump(2).c_str());
}

void print_text(const Comparison& c) {
    std::printf(
        "display PSNR   %.2f dB\nrelative RMS   %.6g\nrelMSE         %.6g\nlargest error  %.6g at pixel %d,%d\n"
        "pixels         %zu, and %zu with NaN or infinity\n",
        c.display_psnr_db, c.relative_rms, c.rel_mse, c.largest_error, c.largest_x, c.largest_y, c.pixels, c.non_finite);
}

int compare(const Options& options) {
    const std::string& reference_layer = options.reference_layer.empty() ? options.layer : options.reference_layer;
    const AovFrame test = read_layer(options.test, Role::beauty, options.layer);
    const AovFrame reference = read_layer(options.reference, Role::beauty, reference_layer);
    AovFrame mask;
    if (!options.mask.empty()) mask = read_layer(options.reference, Role::mask, options.mask);
    const Image &a = test.layer(Role::beauty), &b = reference.layer(Role::beauty);
    const Comparison result = compare_images(a, b, mask.find(Role::mask));
    if (options.as_json)
        print_json(result);
    else
        print_text(result);
    if (!options.difference.empty())
        write_preview(options.difference, difference_image(a, b, mask.find(Role::mask)), PreviewSettings());
    return 0;
}

}  // namespace

Run add_compare(CLI::App& app) {
    auto* command = app.add_subcommand("compare", "Measures how far a picture is from its reference");
    auto options = std::make_shared<Options>();
    command->add_option("TEST", options->test, "an EXR")->required();
    command->add_option("REFERENCE", options->reference, "the EXR it should equal")->required();
    command->add_option("--layer", options->layer, "layer to compare; by default the beauty")->type_name("NAME");
    command->add_option("--reference-layer", options->reference_layer, "its name in REFERENCE, where it differs")
        ->type_name("NAME");
    command->add_option("--mask", options->mask, "layer of REFERENCE; only pixels above 0 count")->type_name("NAME");
    command->add_option("-o,--output", options->difference, "picture of the difference, a PNG")->type_name("FILE");
    command->add_flag("--json", options->as_json, "print as JSON");
    return [options] { return compare(*options); };
}

}  // namespace burnish::cli
