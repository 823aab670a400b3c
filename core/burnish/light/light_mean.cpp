#include <burnish/light/light_mean.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {

float mean_luminance(const GaussianStack& stack) {
    const CubeLevel& widest = stack.widest()[stack.level_count() - 1];
    double sum = 0;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < widest.size(); ++y)
            for (int x = 0; x < widest.size(); ++x) {
                const float* rgb = widest.at(face, x, y);
                sum += luminance({rgb[0], rgb[1], rgb[2]});
            }
    return static_cast<float>(sum / (6.0 * widest.size() * widest.size()));
}

float display_mean_luminance(const CubeStack& stack) {
    constexpr int kFine = 32;  // texels a face, to tell lamps from walls
    int k = stack.level_count() - 1;
    while (k > 0 && stack[k].size() < kFine) --k;
    const CubeLevel& level = stack[k];
    double sum = 0;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < level.size(); ++y)
            for (int x = 0; x < level.size(); ++x) {
                const float* rgb = level.at(face, x, y);
                sum += std::sqrt(std::max(luminance({rgb[0], rgb[1], rgb[2]}), 0.0f));
            }
    const double root = sum / (6.0 * level.size() * level.size());
    return static_cast<float>(root * root);
}

float mean_luminance(const Light& light) {
    return std::visit(
        [](const auto& own) {
            if constexpr (requires { own.mean_luminance(); })
                return own.mean_luminance();
            else
                return 0.0f;
        },
        light);
}

float mean_luminance(const LightChain& lights) {
    constexpr float kNone = std::numeric_limits<float>::infinity();
    float darkest = kNone;
    for (const LightChain::Link& link : lights.links())
        if (const float own = mean_luminance(*link.light); own > 0) darkest = std::min(darkest, own);
    return darkest < kNone ? darkest : 0.0f;
}

}  // namespace burnish
