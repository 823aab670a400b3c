#include <burnish/shading/split_sum.h>

#include <burnish/base/parallel.h>
#include <burnish/material/albedo.h>
#include <burnish/shading/gaussian_fit.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kGaussians = 6;  // one inside the other: any round lobe to half a percent
constexpr int kFitSteps = 100;
constexpr int kAlbedoSamples = 1024;
constexpr int kSmallestFace = 16;

struct RoundGaussian {
    float sigma;
    float share;  // of the lobe's energy
};

/// The lobe from above, made round.
std::vector<RoundGaussian> round_lobe(LobeParameters lobe) {
    lobe.mx = lobe.my = std::sqrt(lobe.mx * lobe.my);
    const Vec3f wo(0, 0, 1);
    std::vector<GaussianTap> taps;
    for (int i = 0; i < kGaussians; ++i)
        taps.push_back({0, 0, std::log(lobe.mx * std::exp2(static_cast<float>(i) / 2 - 0.5f)), Color3f(0)});
    const LobeQuadrature quadrature = lobe_quadrature(lobe, wo, true, kGaussians);
    fit_gaussians(quadrature, wo, true, kFitSteps, taps);
    std::vector<RoundGaussian> result;
    float sum = 0;
    for (const GaussianTap& tap : taps) sum += luminance(tap.weight);
    for (const GaussianTap& tap : taps) result.push_back({std::exp(tap.log_sigma), luminance(tap.weight) / sum});
    return result;
}

/// Faces that hold the narrowest Gaussian that matters, no finer than the light itself.
int face_size(const std::vector<RoundGaussian>& lobe, const GaussianStack& light) {
    float narrowest = 1;
    for (const RoundGaussian& gaussian : lobe)
        if (gaussian.share > 0.02f) narrowest = std::min(narrowest, gaussian.sigma);
    return std::clamp(static_cast<int>(4 / narrowest), kSmallestFace, std::max(kSmallestFace, light.size(0)));
}

void filter(const std::vector<RoundGaussian>& lobe, const GaussianStack& light, CubeLevel& level) {
    std::vector<LevelRange> levels;
    for (const RoundGaussian& gaussian : lobe) levels.push_back({light.level(gaussian.sigma), light.level(gaussian.sigma)});
    const CubeStack& stack = light.stack(levels);
    const int size = level.size();
    for_each_index(6 * size, [&](int row) {
        for (int x = 0; x < size; ++x) {
            const float scale = 1 / static_cast<float>(size);
            const Vec3f d = cube_direction(row / size, (static_cast<float>(x) + 0.5f) * scale,
                                           (static_cast<float>(row % size) + 0.5f) * scale);
            Color3f sum(0);
            for (size_t i = 0; i < lobe.size(); ++i) sum += stack.lookup(d, levels[i].finest) * lobe[i].share;
            float* texel = level.at(row / size, x, row % size);
            std::copy_n(&sum.x, 3, texel), texel[3] = 0;
        }
    });
    level.fill_borders();
}

LobeParameters plain(LobeParameters lobe) {
    lobe.strength = 1, lobe.tint = Color3f(1), lobe.rotation = 0, lobe.per_pixel = {};
    return lobe;
}

}  // namespace

SplitSum split_sum(const LobeParameters& parameters, const GaussianStack& light) {
    SplitSum result{TapTable(parameters, 1), {}};
    const TapTable::Axis& width = result.table.axes()[2];
    LobeParameters lobe = plain(parameters);
    const auto at = [&](int node) {
        const ShadingPoint point = result.table.node_point(node);
        lobe.mx = point.mx, lobe.my = point.my;
        return point;
    };
    std::vector<std::vector<RoundGaussian>> lobes;
    std::vector<int> sizes;
    for (int i = 0; i < width.count; ++i) {
        at(i * width.stride);
        lobes.push_back(round_lobe(lobe)), sizes.push_back(face_size(lobes.back(), light));
    }
    result.filtered = CubeStack(sizes);
    for (int i = 0; i < width.count; ++i) filter(lobes[static_cast<size_t>(i)], light, result.filtered[i]);
    for (int node = 0; node < result.table.node_count(); ++node) {
        const Vec3f wo = at(node).wo;
        const float side = result.table.side_sign();
        const Tap tap{{-wo.x, -wo.y, wo.z * side},
                      static_cast<float>(node / width.stride % width.count),
                      directional_albedo(lobe, wo, kAlbedoSamples)};
        result.table.set(node, {&tap, 1});
    }
    return result;
}

}  // namespace burnish
