// The cheap cure for energy lost at grazing angles: true over estimated directional albedo, tabulated once per lobe.
//
// A few samples cannot follow a lobe that the horizon cuts: the plain quadrature loses 4-11 % at 75-85 degrees. Under constant light the
// loss depends on the lobe and the view alone, so a small table removes it, and under any light the mean of it.
#pragma once

#include <burnish/shading/shading_point.h>

#include <array>
#include <functional>
#include <vector>

namespace burnish {

class AlbedoRatio {
public:
    /// Estimated directional albedo of the lobe at a point (wo, mx, my set; scale 1; light axes = local axes).
    using Estimate = std::function<Color3f(const ShadingPoint&)>;

    /// An empty table: the ratio is 1.
    AlbedoRatio() = default;
    AlbedoRatio(const LobeParameters& lobe, const Estimate& estimate);
    /// Times that making the table of this lobe evaluates it.
    static int evaluations(const LobeParameters& lobe);

    /// Factor for the estimate at `point`, linear between nodes.
    float at(const ShadingPoint& point) const;

private:
    /// One axis of the table: `count` nodes from low to high in the axis' own measure.
    struct Axis {
        float low, high;
        int count;
        float node(int i) const { return count > 1 ? low + (high - low) * i / (count - 1) : low; }
    };
    static constexpr int kAxes = 4;  // sqrt(cos theta_o), phi_o, log2 of mean width, log2 of mx/my
    static std::array<Axis, kAxes> axes_of(const LobeParameters& lobe);

    std::array<float, kAxes> coordinates(const ShadingPoint& point) const;
    ShadingPoint point_at(const std::array<int, kAxes>& node) const;

    std::array<Axis, kAxes> m_axes{};
    std::vector<float> m_ratio;
};

}  // namespace burnish
