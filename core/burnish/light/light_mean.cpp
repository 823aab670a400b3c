#include <burnish/light/light_mean.h>

#include <burnish/light/gaussian_stack.h>

namespace burnish {
namespace {

float mean_of(const EnvironmentLight& light) {
    return luminance(light.environment().gain()) * mean_luminance(light.environment().gaussian_stack().stack());
}

}  // namespace

float mean_luminance(const CubeStack& stack) {
    const CubeLevel& widest = stack[stack.level_count() - 1];
    double sum = 0;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < widest.size(); ++y)
            for (int x = 0; x < widest.size(); ++x) {
                const float* rgb = widest.at(face, x, y);
                sum += luminance({rgb[0], rgb[1], rgb[2]});
            }
    return static_cast<float>(sum / (6.0 * widest.size() * widest.size()));
}

float mean_luminance(const Light& light) {
    return std::visit([](const auto& own) { return mean_of(own); }, light);
}

float mean_luminance(const LightChain& lights) {
    float sum = 0;
    for (const LightChain::Link& link : lights.links()) sum += mean_luminance(*link.light);
    return sum;
}

}  // namespace burnish
