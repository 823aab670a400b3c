#include <burnish/shading/fitted.h>

#include <burnish/base/parallel.h>
#include <burnish/shading/lobe_fit.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kAnchorCosine = 0.5f;    // paths start at 60 degrees: the lobe is long enough to tell the taps apart
constexpr float kGrazingCosine = 0.01f;  // lower views take the taps of this one

/// Fills a table path by path: a path runs along the view axis at one azimuth and one width.
class Filler {
public:
    Filler(const LobeParameters& lobe, const GaussianStack& light, TapTable& table)
        : m_lobe(lobe), m_light(light), m_table(table), m_view(table.axes()[0]) {
        m_lobe.strength = 1, m_lobe.tint = Color3f(1), m_lobe.rotation = 0, m_lobe.per_pixel = {};
        m_in_plane = table.axes()[1].count == 1;
    }

    void fill() {
        const TapTable::Axis &azimuth = m_table.axes()[1], &width = m_table.axes()[2];
        const int paths = azimuth.count * width.count;
        std::vector<int> first(static_cast<size_t>(paths));
        for (int path = 0; path < paths; ++path)
            first[static_cast<size_t>(path)] = path % azimuth.count * azimuth.stride + path / azimuth.count * width.stride;
        const std::vector<GaussianTaps> anchors = fit_anchors(first, azimuth.count);
        for_each_index(paths,
                       [&](int path) { fill_path(first[static_cast<size_t>(path)], anchors[static_cast<size_t>(path)]); });
    }

private:
    int node(int first, int view) const { return first + view * m_view.stride; }
    size_t anchor() const {
        int view = 0;
        while (view + 1 < m_view.count && view_of(node(0, view)).z > kAnchorCosine) ++view;
        return static_cast<size_t>(view);
    }
    LobeParameters lobe_at(int index) const {
        const ShadingPoint point = m_table.node_point(index);
        LobeParameters lobe = m_lobe;
        lobe.mx = point.mx, lobe.my = point.my;
        return lobe;
    }
    Vec3f view_of(int index) const {
        const Vec3f wo = m_table.node_point(index).wo;
        if (wo.z >= kGrazingCosine) return wo;
        const Vec2f along = Vec2f(wo.x, wo.y).normalized() * std::sqrt(1 - kGrazingCosine * kGrazingCosine);
        return {along.x, along.y, kGrazingCosine};
    }

    /// One after the other, each starting from the one before, so that taps keep their order over the whole table.
    std::vector<GaussianTaps> fit_anchors(const std::vector<int>& first, int azimuths) const {
        std::vector<GaussianTaps> anchors(first.size());
        for (size_t path = 0; path < first.size(); ++path) {
            const int index = node(first[path], static_cast<int>(anchor()));
            const LobeParameters lobe = lobe_at(index);
            const bool next_width = path % static_cast<size_t>(azimuths) == 0;
            GaussianTaps near;
            if (path > 0)
                near = next_width ? scaled(anchors[path - static_cast<size_t>(azimuths)],
                                           lobe_at(first[path - static_cast<size_t>(azimuths)]), lobe)
                                  : anchors[path - 1];
            anchors[path] = fit_view(lobe, view_of(index), m_in_plane, m_table.tap_count(), near);
        }
        return anchors;
    }

    /// The same taps for a lobe of another width.
    static GaussianTaps scaled(GaussianTaps taps, const LobeParameters& from, const LobeParameters& to) {
        const float x = to.mx / from.mx, y = to.my / from.my;
        for (GaussianTap& tap : taps) tap.sx *= x, tap.sy *= y, tap.log_sigma += 0.5f * std::log(x * y);
        return taps;
    }

    void fill_path(int first, const GaussianTaps& start) {
        std::vector<Vec3f> views;
        for (int view = 0; view < m_view.count; ++view) views.push_back(view_of(node(first, view)));
        const std::vector<GaussianTaps> fits = fit_path(lobe_at(first), views, m_in_plane, anchor(), start);
        std::vector<Tap> taps(start.size());
        for (size_t view = 0; view < fits.size(); ++view) {
            const int index = node(first, static_cast<int>(view));
            std::ranges::transform(fits[view], taps.begin(), [&](const GaussianTap& tap) { return lookup(tap, index); });
            m_table.set(index, taps);
        }
    }

    Tap lookup(const GaussianTap& tap, int index) const {
        Vec3f wi = tap_direction(m_table.node_point(index).wo, tap.sx, tap.sy);
        if (m_lobe.side == Side::transmission) wi.z = -wi.z;
        return {wi, m_light.level(std::exp(tap.log_sigma)), tap.weight};
    }

    LobeParameters m_lobe;
    const GaussianStack& m_light;
    TapTable& m_table;
    const TapTable::Axis& m_view;
    bool m_in_plane;
};

}  // namespace

TapTable fitted_table(const LobeParameters& lobe, int taps, const GaussianStack& light) {
    TapTable table(lobe, taps);
    Filler(lobe, light, table).fill();
    return table;
}

}  // namespace burnish
