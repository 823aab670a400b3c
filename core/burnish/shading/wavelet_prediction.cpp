#include <burnish/shading/wavelet_prediction.h>

#include <burnish/frequency/lobe_bandwidth.h>
#include <burnish/material/lobe.h>
#include <burnish/shading/disc_light.h>
#include <burnish/shading/tap_rule.h>
#include <burnish/shading/tap_table.h>

#include <algorithm>

namespace burnish {
namespace {

/// A pattern of equal cells that fill the lobe up to four fifths of its energy: beyond, little comes through.
EstimatorSettings pattern_settings(int directions) {
    EstimatorSettings settings;
    settings.kind = EstimatorKind::regular;
    settings.samples = directions > 0 ? directions : WaveletPrediction::kDefaultDirections;
    settings.border = 0.2f;
    settings.albedo_correction = false;
    return settings;
}

/// Sums of one pixel over all lobes and directions.
struct Sums {
    float lambda = 0, nu_l = 0, nu_kept = 0, variance = 0, preconvolved_variance = 0;

    /// A direction: lambda = light that comes through it, chi = lambda / (cos_i Omega).
    void add(float nu_light, float nu_rho, float light, float cos_i, float omega) {
        const float chi2_omega = light * light / (cos_i * cos_i * omega);
        lambda += light, nu_l += light * nu_light, nu_kept += light * std::min(nu_rho, nu_light);
        variance += (nu_light + nu_rho) * chi2_omega, preconvolved_variance += 2 * nu_rho * chi2_omega;
    }

    PathBandwidth means() const {
        const float scale = lambda > 0 ? 1 / lambda : 0.0f;
        return {nu_l * scale, nu_kept * scale, variance, preconvolved_variance};
    }
};

constexpr float kLeastCosine = 0.05f;  // of a direction that counts for the variance, and of a view that narrows lobes
constexpr float kCellsOfNyquist = 2 * kCellPeriods;
constexpr float kReach = 0.5f;  // of a lobe's width: as far as its cells still cover it

}  // namespace

struct WaveletPrediction::LobeDirections {
    LobeDirections(const LobeParameters& parameters, const Environment& environment, int directions)
        : lobe(parameters),
          light(environment),
          rule(parameters, pattern_settings(directions),
               [&environment](float omega) { return environment.pyramid().level(omega); }),
          bandwidth(parameters) {
        const int count = rule.tap_count(lobe.mx, lobe.my);
        if (TapTable::covers(lobe, count)) table = TapTable(lobe, count, rule);
    }

    void taps_at(const ShadingPoint& point, std::vector<Tap>& taps) const {
        taps.resize(rule.tap_count(point.mx, point.my));
        if (table.tap_count() > 0)
            table.at(point, taps);
        else
            rule(point, taps);
    }

    /// The lobe's bandwidth goes like 1 / m, where widths come from layers.
    float nu_rho(const ShadingPoint& point) const {
        return bandwidth.nu_rho(point.wo.z) * (std::min(lobe.mx, lobe.my) / std::min(point.mx, point.my));
    }

    void add(const ShadingPoint& point, const LightBandwidth& nu_light, std::vector<Tap>& taps, Sums& sums) const {
        const float side_sign = lobe.side == Side::transmission ? -1.0f : 1.0f, rho = nu_rho(point);
        const CubePyramid& pyramid = light.pyramid();
        const float unit_level = pyramid.level(1.0f);  // where a texel covers one steradian
        taps_at(point, taps);
        for (const Tap& tap : taps) {
            const float length = std::sqrt(tap.wi.length2()), cos_i = tap.wi.z * side_sign / length;
            if (cos_i <= 0 || tap.weight == Color3f(0, 0, 0) || !point.sees(tap.wi, side_sign)) continue;
            const Vec3f d = point.frame.to_world(tap.wi);
            const float omega = std::exp2(2 * (tap.level - unit_level)), radius = std::min(std::sqrt(omega / kPi), kPi / 4);
            const float level = tap.level + CubePyramid::kDistortion * cube_distortion(d);
            const float through = luminance(pyramid.lookup(d, level) * tap.weight * point.scale);
            sums.add(nu_light.at(d, radius), rho, through, std::max(cos_i, kLeastCosine), omega);
        }
        add_discs(point, nu_light, rho, side_sign, sums);
    }

    void add_discs(const ShadingPoint& point, const LightBandwidth& nu_light, float rho, float side_sign, Sums& sums) const {
        for (const BrightDisc& disc : light.discs()) {
            const Color3f reflected = visit_lobe(lobe, [&](const auto& own) {
                return disc_light(own.with_widths(point.mx, point.my), {&disc, 1}, point);
            });
            const float through = luminance(reflected * point.scale), radius = disc.radius();
            if (!(through > 0)) continue;
            const float cos_i = disc.direction.dot(point.frame.n) * side_sign;
            sums.add(nu_light.at(disc.direction, radius), rho, through, std::max(cos_i, kLeastCosine), kPi * radius * radius);
        }
    }

    /// How far from a pixel's direction its prediction holds for this lobe.
    void limit(const SurfaceBatch& batch, size_t i, AngularPrediction& out) const {
        const Vec2f widths = lobe_widths(batch, i, lobe);
        const float cos_o = std::max(batch.n[i].dot(batch.wo[i]), kLeastCosine);
        out.reach = std::min(out.reach, kReach * std::sqrt(2.0f) * std::min(widths.x, widths.y) * cos_o);
        if (widths.x != widths.y) out.length = std::max(out.length, std::sqrt(2.0f) * std::max(widths.x, widths.y));
    }

    LobeParameters lobe;
    const Environment& light;
    TapRule rule;
    TapTable table;  // empty where anisotropy comes from a layer
    LobeBandwidth bandwidth;
};

WaveletPrediction::WaveletPrediction(const Material& material, const Environment& light, const DensitySettings& settings,
                                     std::shared_ptr<const LightBandwidth> shared)
    : m_light(light),
      m_bandwidth(shared ? std::move(shared) : std::make_shared<const LightBandwidth>(light)),
      m_settings(settings) {
    for (const LobeParameters& lobe : material.lobes)
        m_lobes.push_back(std::make_shared<LobeDirections>(lobe, light, settings.directions));
}

void WaveletPrediction::predict(const SurfaceBatch& batch, std::span<PathBandwidth> paths) const {
    std::vector<Tap> taps;
    for (size_t i = 0; i < batch.size(); ++i) {
        Sums sums;
        for (const auto& lobe : m_lobes)
            lobe->add(shading_point(batch, i, lobe->lobe, m_light.world_to_light()), *m_bandwidth, taps, sums);
        paths[i] = sums.means();
    }
}

void WaveletPrediction::predict(const SurfaceBatch& batch, std::span<AngularPrediction> out) const {
    std::vector<PathBandwidth> paths(batch.size());
    predict(batch, std::span(paths));
    const bool source = m_settings.prediction == PredictionKind::source;
    for (size_t i = 0; i < batch.size(); ++i) {
        const float nu = source ? 0.5f * (paths[i].nu_l + paths[i].nu_kept) : paths[i].nu_kept;
        out[i] = {m_settings.safety * nu * kCellsOfNyquist, kPi, 0, 0, 0};
        for (const auto& lobe : m_lobes) lobe->limit(batch, i, out[i]);
    }
}

}  // namespace burnish
