// burnish preview: a ball of a material, to see what a name, a file or a fit looks like.
#include "command.h"

#include <burnish/base/error.h>
#include <burnish/job/material_ball.h>
#include <burnish/material/library.h>
#include <burnish/output/exr_writer.h>
#include <burnish/output/preview.h>

#include <filesystem>
#include <memory>

namespace burnish::cli {
namespace {

struct Options {
    std::string material, output, light;
    BallSettings ball;
    PreviewSettings look;
};

int preview(const Options& options) {
    const Material material = find_material(options.material);
    const BallLight light = options.light.empty() ? BallLight::sky() : BallLight::load(options.light);
    const Image ball = render_ball(material, light, options.ball);
    if (std::filesystem::path(options.output).extension() != ".exr") {
        write_preview(options.output, over_grey(ball), options.look);
        return 0;
    }
    AovFrame frame;
    frame.data_window = frame.display_window = {0, 0, ball.width, ball.height};
    write_exr(options.output, frame, {{{"R", "G", "B", "A"}, &ball}}, PixelType::half);
    return 0;
}

}  // namespace

Run add_preview(CLI::App& app) {
    auto* command = app.add_subcommand("preview", "Shows a material on a ball");
    auto options = std::make_shared<Options>();
    command->add_option("MATERIAL", options->material, "a preset, merl:NAME or a file; see burnish models")->required();
    command->add_option("-o,--output", options->output, "picture: .png, or .exr with alpha")->required()->type_name("FILE");
    command->add_option("--env", options->light, "light from all around, Z up [an outdoor studio]")->type_name("FILE");
    command->add_option("--size", options->ball.size, "of the picture [256]")->check(CLI::Range(16, 4096))->type_name("PIXELS");
    command->add_option("--exposure", options->look.exposure_stops, "of the .png [0]")->type_name("STOPS");
    command->footer("Example: burnish preview merl:brass -o brass.png");
    return [options] { return preview(*options); };
}

}  // namespace burnish::cli
