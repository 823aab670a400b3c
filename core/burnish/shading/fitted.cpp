#include <burnish/shading/fitted.h>

#include <burnish/base/parallel.h>
#include <burnish/material/lobe.h>
#include <burnish/sampling/tuned_patterns.h>
#include <burnish/shading/lobe_fit.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kAnchorCosine = 0.5f;    // 60 degrees: a round lobe's image is long enough there to tell the taps apart
constexpr float kGrazingCosine = 0.01f;  // lower views take the half vectors of this one
constexpr float kFade = 1.25f;           // a tap sets within so many of its own widths
constexpr int kFitEvery[] = {4, 8, 4};   // views, azimuths and widths that are fitted; those between are interpolated

using Path = std::vector<GaussianTaps>;  // along the view axis, at one azimuth and one width

/// The same taps for a lobe of other widths.
GaussianTaps scaled(GaussianTaps taps, const LobeParameters& from, const LobeParameters& to) {
    const float x = to.mx / from.mx, y = to.my / from.my;
    for (GaussianTap& tap : taps) tap.sx *= x, tap.sy *= y, tap.log_sigma += 0.5f * std::log(x * y);
    return taps;
}

/// The fitted nodes of one axis: every few, and the last.
class FittedNodes {
public:
    FittedNodes(const TapTable::Axis& axis, int every)
        : m_last(axis.count - 1), m_every(every), m_count((axis.count - 2 + every) / every + 1), m_stride(axis.stride) {}

    int count() const { return m_count; }
    int stride_of(int fit) const { return place(fit) * m_stride; }
    /// Fit below a node of the axis, and how far on the way to the next one the node lies.
    int below(int node) const { return std::min(node / m_every, std::max(m_count - 2, 0)); }
    float part(int node) const {
        const int low = place(below(node)), high = place(below(node) + 1);
        return high > low ? static_cast<float>(node - low) / static_cast<float>(high - low) : 0.0f;
    }

private:
    int place(int fit) const { return std::min(fit * m_every, m_last); }
    int m_last, m_every, m_count, m_stride;
};

/// Makes taps whose fits are mostly of other, higher views as bright as the lobe is at wo; towards the horizon that may be without
/// bound.
void keep_albedo(GaussianTaps& taps, const LobeParameters& lobe, const Vec3f& wo, bool in_plane) {
    const Color3f albedo = lobe_quadrature(lobe, wo, in_plane, static_cast<int>(taps.size())).albedo;
    Color3f sum(0);
    for (const GaussianTap& tap : taps) sum += tap.weight;
    for (GaussianTap& tap : taps)
        for (int k = 0; k < 3; ++k)
            if (sum[k] > 0) tap.weight[k] *= albedo[k] / sum[k];
}

/// Fits of one lobe at some nodes of a table, taps between them by interpolation.
class TableFit {
public:
    TableFit(const LobeParameters& lobe, const TapTable& table)
        : m_lobe(lobe),
          m_table(table),
          m_views(table.axes()[0], kFitEvery[0]),
          m_azimuths(table.axes()[1], kFitEvery[1]),
          m_widths(table.axes()[2], kFitEvery[2]) {
        m_lobe.strength = 1, m_lobe.tint = Color3f(1), m_lobe.rotation = 0, m_lobe.per_pixel = {};
        while (in_plane() && view(m_views.stride_of(m_anchor)).z > kAnchorCosine) ++m_anchor;
        const auto anchor = static_cast<size_t>(m_anchor);
        if (path_count() == 1) {
            m_paths = {fit_best_path(lobe_at(0), views_of(0), in_plane(), anchor, table.tap_count())};
            return;
        }
        const std::vector<GaussianTaps> anchors = fit_anchors();
        m_paths.resize(anchors.size());
        for_each_index(path_count(), [&](int path) {
            const auto p = static_cast<size_t>(path);
            m_paths[p] = fit_path(lobe_at(path), views_of(path), in_plane(), anchor, anchors[p]);
        });
    }

    /// Taps at a node, given by its place on the three axes.
    GaussianTaps at(int v, int a, int w) const {
        const auto along_view = [&](int path) {
            const Path& p = m_paths[static_cast<size_t>(path)];
            const auto low = static_cast<size_t>(m_views.below(v));
            return blend(p[low], p[std::min(low + 1, p.size() - 1)], m_views.part(v));
        };
        const auto along_azimuth = [&](int width) {
            const int low = width * m_azimuths.count() + m_azimuths.below(a);
            const float part = m_azimuths.part(a);
            return part > 0 ? blend(along_view(low), along_view(low + 1), part) : along_view(low);
        };
        const int low = m_widths.below(w);
        const float part = m_widths.part(w);
        GaussianTaps taps = part > 0 ? blend(along_azimuth(low), along_azimuth(low + 1), part) : along_azimuth(low);
        const ShadingPoint point = m_table.node_point(v + a * m_table.axes()[1].stride + w * m_table.axes()[2].stride);
        if (point.wo.z < 2 * kGrazingCosine) keep_albedo(taps, lobe_of(point), point.wo, in_plane());
        return taps;
    }

private:
    int path_count() const { return m_azimuths.count() * m_widths.count(); }  // azimuths first
    bool in_plane() const { return m_azimuths.count() == 1; }
    int first_node(int path) const {
        return m_azimuths.stride_of(path % m_azimuths.count()) + m_widths.stride_of(path / m_azimuths.count());
    }

    /// Where paths start. A long lobe's taps tell themselves apart from above, where all azimuths are one; a round lobe's do at
    /// m_anchor. Widths one after the other, each from the one before, so that taps keep their order over the whole table.
    std::vector<GaussianTaps> fit_anchors() const {
        std::vector<GaussianTaps> anchors;
        for (int width = 0; width < m_widths.count(); ++width) {
            const int path = width * m_azimuths.count(), narrower = path - m_azimuths.count();
            const LobeParameters lobe = lobe_at(path);
            GaussianTaps near;
            if (width > 0) near = scaled(anchors.back(), lobe_at(narrower), lobe);
            const Vec3f wo = view(first_node(path) + m_views.stride_of(m_anchor));
            const GaussianTaps anchor = fit_view(lobe, wo, in_plane(), m_table.tap_count(), near);
            anchors.insert(anchors.end(), static_cast<size_t>(m_azimuths.count()), anchor);
        }
        return anchors;
    }

    std::vector<Vec3f> views_of(int path) const {
        std::vector<Vec3f> views;
        for (int i = 0; i < m_views.count(); ++i) views.push_back(view(first_node(path) + m_views.stride_of(i)));
        return views;
    }
    LobeParameters lobe_at(int path) const { return lobe_of(m_table.node_point(first_node(path))); }
    LobeParameters lobe_of(const ShadingPoint& point) const {
        LobeParameters lobe = m_lobe;
        lobe.mx = point.mx, lobe.my = point.my;
        return lobe;
    }
    Vec3f view(int index) const {
        const Vec3f wo = m_table.node_point(index).wo;
        if (wo.z >= kGrazingCosine) return wo;
        const Vec2f along = Vec2f(wo.x, wo.y).normalized() * std::sqrt(1 - kGrazingCosine * kGrazingCosine);
        return {along.x, along.y, kGrazingCosine};
    }

    LobeParameters m_lobe;
    const TapTable& m_table;
    FittedNodes m_views, m_azimuths, m_widths;
    int m_anchor = 0;
    std::vector<Path> m_paths;
};

constexpr float kVeryLong = 6;  // mx over my, or the other way round

}  // namespace

bool is_fitted(const LobeParameters& lobe, const EstimatorSettings& settings) {
    if (!TapTable::covers(lobe, lookup_count(settings))) return false;
    const auto border = [&](float xi) { return visit_lobe(lobe, [&](const auto& own) { return own.border(xi); }); };
    const bool very_long = std::max(lobe.mx / lobe.my, lobe.my / lobe.mx) > kVeryLong;
    return settings.samples > 0 || !very_long || lobe_tail(border) == LobeTail::gaussian;
}

EstimatorSettings settled(const LobeParameters& lobe, EstimatorSettings settings) {
    if (settings.kind == EstimatorKind::fitted && !is_fitted(lobe, settings))
        settings.kind = EstimatorKind::regular, settings.samples = 0;
    settings.samples = lookup_count(settings);
    return settings;
}

int fit_count(const LobeParameters& lobe) {
    const std::array<TapTable::Axis, TapTable::kAxes> axes = TapTable::axes_of(lobe);
    std::array<int, TapTable::kAxes> fits{};
    for (size_t a = 0; a < axes.size(); ++a) fits[a] = FittedNodes(axes[a], kFitEvery[a]).count();
    const int paths = fits[1] * fits[2];
    return fits[0] * (paths == 1 ? kPathStarts : paths);
}

TapTable fitted_table(const LobeParameters& lobe, int taps, const std::function<float(float sigma)>& level_of) {
    TapTable table(lobe, taps);
    const TableFit fit(lobe, table);
    const auto& [views, azimuths, widths] = table.axes();
    for_each_index(table.node_count(), [&](int node) {
        std::vector<Tap> lookups;
        const int view = node % views.count, azimuth = node / azimuths.stride % azimuths.count, width = node / widths.stride;
        for (const GaussianTap& tap : fit.at(view, azimuth, width)) {
            Vec3f wi = tap_direction(table.node_point(node).wo, tap.sx, tap.sy);
            wi.z *= table.side_sign();
            const float sigma = std::exp(tap.log_sigma);
            lookups.push_back({wi, level_of(sigma), tap.weight, 1 / (kFade * sigma)});
        }
        table.set(node, lookups);
    });
    return table;
}

}  // namespace burnish
