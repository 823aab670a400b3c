#include <burnish/shading/lobe_fit.h>

#include <burnish/base/parallel.h>
#include <burnish/shading/line_probes.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kFirstSteps = 60, kNextSteps = 12;

struct Start {
    float reach, spread;  // of line_probes
};
constexpr Start kStarts[kPathStarts] = {{1.4f, 1.0f}, {2.0f, 1.0f}, {1.2f, 2.5f}, {1.0f, 1.0f}, {1.7f, 1.6f}};

}  // namespace

GaussianTaps fit_view(const LobeParameters& lobe, const Vec3f& wo, bool in_plane, int taps, const GaussianTaps& near) {
    const LobeQuadrature quadrature = lobe_quadrature(lobe, wo, in_plane, taps);
    GaussianTaps best;
    float best_residual = 0;
    const auto attempt = [&](GaussianTaps start) {
        const float residual = fit_gaussians(quadrature, wo, in_plane, kFirstSteps, start);
        if (best.empty() || residual < best_residual) best = std::move(start), best_residual = residual;
    };
    if (!near.empty())
        attempt(near);
    else
        for (const Start& start : kStarts) attempt(line_probes(wo, lobe.mx, lobe.my, taps, start.reach, start.spread));
    return best;
}

std::vector<GaussianTaps> fit_path(const LobeParameters& lobe, std::span<const Vec3f> views, bool in_plane, size_t anchor,
                                   const GaussianTaps& start) {
    std::vector<GaussianTaps> fits(views.size());
    fits[anchor] = start;
    const auto follow = [&](size_t view, size_t neighbour) {
        fits[view] = fits[neighbour];
        fit_gaussians(lobe_quadrature(lobe, views[view], in_plane, static_cast<int>(start.size())), views[view], in_plane,
                      kNextSteps, fits[view]);
    };
    for (size_t view = anchor; view-- > 0;) follow(view, view + 1);
    for (size_t view = anchor + 1; view < views.size(); ++view) follow(view, view - 1);
    return fits;
}

GaussianTaps blend(const GaussianTaps& a, const GaussianTaps& b, float part) {
    GaussianTaps taps = a;
    const auto mix = [&](float& x, float y) { x += (y - x) * part; };
    for (size_t i = 0; i < taps.size(); ++i) {
        mix(taps[i].sx, b[i].sx), mix(taps[i].sy, b[i].sy), mix(taps[i].log_sigma, b[i].log_sigma);
        for (int k = 0; k < 3; ++k) mix(taps[i].weight[k], b[i].weight[k]);
    }
    return taps;
}

std::vector<GaussianTaps> fit_best_path(const LobeParameters& lobe, std::span<const Vec3f> views, bool in_plane, size_t anchor,
                                        int taps) {
    const auto error_of = [&](const std::vector<GaussianTaps>& fits) {
        float sum = 0;
        for (size_t i = 0; i + 1 < views.size(); ++i) {
            const Vec3f wo = (views[i] + views[i + 1]).normalized();
            const float sine = std::sqrt(std::max(0.0f, 1 - wo.z * wo.z));  // as often as a sphere shows the view
            sum +=
                sine *
                std::pow(residual_of(lobe_quadrature(lobe, wo, in_plane, taps), wo, blend(fits[i], fits[i + 1], 0.5f)), 2.0f);
        }
        return sum;
    };
    std::vector<std::vector<GaussianTaps>> paths(std::size(kStarts));
    std::vector<float> errors(paths.size());
    for_each_index(static_cast<int>(paths.size()), [&](int i) {
        const auto p = static_cast<size_t>(i);
        GaussianTaps start = line_probes(views[anchor], lobe.mx, lobe.my, taps, kStarts[p].reach, kStarts[p].spread);
        fit_gaussians(lobe_quadrature(lobe, views[anchor], in_plane, taps), views[anchor], in_plane, kFirstSteps, start);
        paths[p] = fit_path(lobe, views, in_plane, anchor, start);
        errors[p] = error_of(paths[p]);
    });
    return paths[static_cast<size_t>(std::ranges::min_element(errors) - errors.begin())];
}

}  // namespace burnish
