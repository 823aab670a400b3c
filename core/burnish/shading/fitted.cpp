#include <burnish/shading/fitted.h>

#include <burnish/base/parallel.h>
#include <burnish/shading/lobe_fit.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kAnchorCosine = 0.5f;    // paths start at 60 degrees: the lobe is long enough there to tell the taps apart
constexpr float kGrazingCosine = 0.01f;  // lower views take the half vectors of this one
constexpr int kFitEvery = 4;             // azimuths and widths that are fitted; those between are interpolated

using Path = std::vector<GaussianTaps>;  // along the view axis, at one azimuth and one width

GaussianTaps blend(const GaussianTaps& a, const GaussianTaps& b, float part) {
    GaussianTaps taps = a;
    const auto mix = [&](float& x, float y) { x += (y - x) * part; };
    for (size_t i = 0; i < taps.size(); ++i) {
        mix(taps[i].sx, b[i].sx), mix(taps[i].sy, b[i].sy), mix(taps[i].log_sigma, b[i].log_sigma);
        for (int k = 0; k < 3; ++k) mix(taps[i].weight[k], b[i].weight[k]);
    }
    return taps;
}

Path blend(const Path& a, const Path& b, float part) {
    Path path;
    for (size_t view = 0; view < a.size(); ++view) path.push_back(blend(a[view], b[view], part));
    return path;
}

/// The same taps for a lobe of other widths.
GaussianTaps scaled(GaussianTaps taps, const LobeParameters& from, const LobeParameters& to) {
    const float x = to.mx / from.mx, y = to.my / from.my;
    for (GaussianTap& tap : taps) tap.sx *= x, tap.sy *= y, tap.log_sigma += 0.5f * std::log(x * y);
    return taps;
}

/// Fits of one lobe at the nodes of a table.
class TableFit {
public:
    TableFit(const LobeParameters& lobe, const TapTable& table) : m_lobe(lobe), m_table(table) {
        m_lobe.strength = 1, m_lobe.tint = Color3f(1), m_lobe.rotation = 0, m_lobe.per_pixel = {};
        while (m_anchor + 1 < axis(0).count && view(node(m_anchor, 0, 0)).z > kAnchorCosine) ++m_anchor;
    }

    /// Every fitted azimuth and width, azimuths first. Anchors one after the other, each starting from the one before, so
    /// that taps keep their order over the whole table; then the paths from their anchors.
    std::vector<Path> fit() const {
        std::vector<GaussianTaps> anchors;
        for (int path = 0; path < path_count(); ++path) {
            const LobeParameters lobe = lobe_at(path);
            GaussianTaps near;
            if (path % azimuths() > 0)
                near = anchors.back();
            else if (path > 0)
                near = scaled(anchors[static_cast<size_t>(path - azimuths())], lobe_at(path - azimuths()), lobe);
            const Vec3f wo = view(first_node(path) + m_anchor * axis(0).stride);
            anchors.push_back(fit_view(lobe, wo, in_plane(), m_table.tap_count(), near));
        }
        std::vector<Path> paths(anchors.size());
        for_each_index(path_count(), [&](int path) {
            std::vector<Vec3f> views;
            for (int i = 0; i < axis(0).count; ++i) views.push_back(view(first_node(path) + i * axis(0).stride));
            const auto p = static_cast<size_t>(path);
            paths[p] = fit_path(lobe_at(path), views, in_plane(), static_cast<size_t>(m_anchor), anchors[p]);
        });
        return paths;
    }

    int azimuths() const { return fitted(1); }

private:
    const TapTable::Axis& axis(int a) const { return m_table.axes()[static_cast<size_t>(a)]; }
    int fitted(int a) const { return (axis(a).count - 1) / kFitEvery + 1; }
    int path_count() const { return fitted(1) * fitted(2); }
    bool in_plane() const { return axis(1).count == 1; }
    int node(int i, int j, int k) const { return i * axis(0).stride + j * axis(1).stride + k * axis(2).stride; }
    int first_node(int path) const { return node(0, path % azimuths() * kFitEvery, path / azimuths() * kFitEvery); }

    LobeParameters lobe_at(int path) const {
        const ShadingPoint point = m_table.node_point(first_node(path));
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
    int m_anchor = 0;
};

}  // namespace

TapTable fitted_table(const LobeParameters& lobe, int taps, const GaussianStack& light) {
    TapTable table(lobe, taps);
    const TableFit fit(lobe, table);
    const std::vector<Path> paths = fit.fit();
    const auto& [views, azimuths, widths] = table.axes();
    const auto path_at = [&](int azimuth, int width) -> const Path& {
        return paths[static_cast<size_t>(width * fit.azimuths() + azimuth)];
    };
    const auto between = [](int index, const auto& at) {
        const int low = index / kFitEvery, rest = index % kFitEvery;
        return rest == 0 ? at(low) : blend(at(low), at(low + 1), static_cast<float>(rest) / kFitEvery);
    };
    for_each_index(azimuths.count * widths.count, [&](int index) {
        const int azimuth = index % azimuths.count, width = index / azimuths.count;
        const Path path = between(width, [&](int w) { return between(azimuth, [&](int a) -> Path { return path_at(a, w); }); });
        for (int view = 0; view < views.count; ++view) {
            const int node = view * views.stride + azimuth * azimuths.stride + width * widths.stride;
            std::vector<Tap> lookups;
            for (const GaussianTap& tap : path[static_cast<size_t>(view)]) {
                Vec3f wi = tap_direction(table.node_point(node).wo, tap.sx, tap.sy);
                wi.z *= table.side_sign();
                lookups.push_back({wi, light.level(std::exp(tap.log_sigma)), tap.weight});
            }
            table.set(node, lookups);
        }
    });
    return table;
}

}  // namespace burnish
