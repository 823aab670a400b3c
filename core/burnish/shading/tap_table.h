// The taps of one lobe as a table over the view: what an estimator computes a few hundred times, each pixel interpolates.
//
// For a lobe of uniform anisotropy the taps depend on the view alone, and on the width where that comes from a layer. Axes:
//
//     view     sqrt(1 - cos_o) - sqrt(cos_o): fine near the normal, where taps move, and at the horizon, where weights do
//     azimuth  of anisotropic lobes: a = y / (|x| + |y|), 2 - a where x < 0, of wo half way to the space where the lobe is
//              round; all round, as patterns need not be symmetric and mirroring by the sign of a vanishing x makes noise
//     width    sqrt(m), the artist's roughness
//
// Directions are kept as half vectors: they move little with the view, not at all for `regular`, and the pixel's own wo
// turns them into directions again, wi ~ 2 (wo . h) h - (h . h) wo, so mirror reflections stay sharp between nodes.
#pragma once

#include <burnish/light/filter/level_range.h>
#include <burnish/material/parameters.h>
#include <burnish/shading/shading_point.h>
#include <burnish/shading/tap.h>

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace burnish {

class TapTable {
public:
    /// Writes the taps of the lobe at a point.
    using Rule = std::function<void(const ShadingPoint& point, std::span<Tap> taps)>;

    /// Whether so many taps of this lobe can be tabulated: its anisotropy is uniform, and the table is not too large.
    static bool covers(const LobeParameters& lobe, int taps);

    TapTable() = default;
    /// A table of weightless taps, to be filled by `set`. `taps` >= 1.
    TapTable(const LobeParameters& lobe, int taps);
    /// Filled by `rule`, in parallel.
    TapTable(const LobeParameters& lobe, int taps, const Rule& rule);

    int tap_count() const { return m_taps; }
    int node_count() const { return node_count(m_axes); }
    /// Where a node lies: wo, mx and my; the frame is the local one, ng = n, scale 1.
    ShadingPoint node_point(int node) const;
    void set(int node, std::span<const Tap> taps);

    /// Of each tap, over the nodes and so over all that lies between them.
    std::vector<LevelRange> level_ranges() const;

    /// The taps at a point (wo, mx, my), linear between nodes.
    void at(const ShadingPoint& point, std::span<Tap> taps) const;

    /// Fields of a node, each `padded_taps()` floats, one after the other: taps are the lanes of a SIMD kernel.
    enum Field { h_x, h_y, h_z, level, weight_r, weight_g, weight_b, edge, kFields };
    int padded_taps() const { return m_padded; }
    int node_floats() const { return m_padded * kFields; }
    /// The first node; the others follow.
    const float* data() const { return m_data.data(); }

    /// One axis: `count` nodes, `stride` nodes apart, the first at `low` and `per_unit` nodes to a unit of the measure.
    struct Axis {
        float low = 0, per_unit = 0;
        int count = 1, stride = 1;
    };
    static constexpr int kAxes = 3, kLanes = 8;
    const std::array<Axis, kAxes>& axes() const { return m_axes; }
    static std::array<Axis, kAxes> axes_of(const LobeParameters& lobe);
    static int node_count(const std::array<Axis, kAxes>& axes) { return axes[2].stride * axes[2].count; }
    /// The lobe's own width, sqrt(mx my).
    float width() const { return m_width; }
    /// Of the azimuth's measure: x is multiplied by it, y divided.
    float azimuth_stretch() const { return std::sqrt(m_half_aspect); }
    float side_sign() const { return m_side_sign; }

private:
    static int padded(int taps) { return (taps + kLanes - 1) / kLanes * kLanes; }
    float measure(int axis, const ShadingPoint& point) const;

    std::array<Axis, kAxes> m_axes;
    float m_half_aspect = 1, m_width = 1, m_side_sign = 1;  // m_half_aspect: mx = m half_aspect, my = m / half_aspect
    int m_taps = 0, m_padded = 0;
    std::vector<float> m_data;
};

}  // namespace burnish
