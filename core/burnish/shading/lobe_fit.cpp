#include <burnish/shading/lobe_fit.h>

#include <burnish/shading/line_probes.h>

namespace burnish {
namespace {

constexpr int kFirstSteps = 60, kNextSteps = 12;

struct Start {
    float reach, spread;  // of line_probes
};
constexpr Start kStarts[] = {{1.4f, 1.0f}, {2.0f, 1.0f}, {1.2f, 2.5f}};

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

}  // namespace burnish
