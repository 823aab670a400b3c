#include <burnish/base/error.h>
#include <burnish/job/build_lights.h>
#include <burnish/job/color_flow.h>
#include <burnish/job/look.h>

namespace burnish {
namespace {

EnvironmentSettings settings_for(const Job& job, Renderer renderer) {
    EnvironmentSettings settings = job.light;
    settings.up = settled_up(settings.up, renderer);
    return settings;
}

}  // namespace

std::shared_ptr<const Environment> load_light(const Job& job, const ColorFlow& color, Renderer renderer) {
    if (job.environment.empty())
        throw Error(ErrorCode::bad_argument, "no light: name an environment map with --env FILE (shot file: lights.sky.file)");
    const auto convert = [&](Image& picture) { color.from_environment(picture); };
    return std::make_shared<const Environment>(Environment::load(job.environment, settings_for(job, renderer), convert));
}

std::shared_ptr<const Environment> light_from_picture(const Job& job, const ColorFlow& color, Image picture,
                                                      Renderer renderer) {
    color.from_environment(picture);
    return std::make_shared<const Environment>(Environment::from_image(picture, settings_for(job, renderer), "light"));
}

}  // namespace burnish
