#include <burnish/shading/albedo_ratio.h>

#include <burnish/base/parallel.h>
#include <burnish/material/albedo.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kMaxRatio = 4.0f;  // beyond it the estimate holds no information worth scaling up

/// For each of so many nodes: a second of work on one core at the most.
int samples_at(int nodes) { return nodes > 10000 ? 512 : 2048; }

}  // namespace

std::array<AlbedoRatio::Axis, AlbedoRatio::kAxes> AlbedoRatio::axes_of(const LobeParameters& lobe) {
    const bool varying_aspect = lobe.per_pixel.anisotropy, varying_width = lobe.per_pixel.roughness;
    const bool anisotropic = varying_aspect || lobe.mx != lobe.my;
    const float width = std::log2(std::sqrt(lobe.mx * lobe.my)), aspect = std::log2(lobe.mx / lobe.my);
    return {Axis{0.1f, 1.0f, 61}, anisotropic ? Axis{0, kPi / 2, 10} : Axis{0, 0, 1},
            varying_width ? Axis{-8, 0, 17} : Axis{width, width, 1},
            varying_aspect ? Axis{-6, 6, 13} : Axis{aspect, aspect, 1}};
}

int AlbedoRatio::evaluations(const LobeParameters& lobe) {
    int count = 1;
    for (const Axis& axis : axes_of(lobe)) count *= axis.count;
    return count * samples_at(count);
}

AlbedoRatio::AlbedoRatio(const LobeParameters& lobe, const Estimate& estimate) : m_axes(axes_of(lobe)) {
    int count = 1;
    for (const Axis& axis : m_axes) count *= axis.count;
    m_ratio.resize(count);
    const int samples = samples_at(count);
    for_each_index(count, [&](int index) {
        std::array<int, kAxes> node{};
        for (int axis = 0, rest = index; axis < kAxes; rest /= m_axes[axis].count, ++axis)
            node[axis] = rest % m_axes[axis].count;
        const ShadingPoint point = point_at(node);
        LobeParameters there = lobe;
        there.mx = point.mx, there.my = point.my, there.rotation = 0, there.strength = 1, there.tint = Color3f(1, 1, 1);
        const float truth = luminance(directional_albedo(there, point.wo, samples)), estimated = luminance(estimate(point));
        m_ratio[index] = estimated > 0 ? std::clamp(truth / estimated, 1 / kMaxRatio, kMaxRatio) : 1.0f;
    });
}

ShadingPoint AlbedoRatio::point_at(const std::array<int, kAxes>& node) const {
    const float x = m_axes[0].node(node[0]), phi = m_axes[1].node(node[1]);
    const float cos_o = x * x, sin_o = std::sqrt(std::max(0.0f, 1 - cos_o * cos_o));
    const float width = std::exp2(m_axes[2].node(node[2])), half_aspect = std::exp2(m_axes[3].node(node[3]) / 2);
    ShadingPoint point;
    point.frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    point.wo = Vec3f(sin_o * std::cos(phi), sin_o * std::sin(phi), cos_o);
    point.ng = Vec3f(0, 0, 1);
    point.mx = std::min(width * half_aspect, 1.0f), point.my = std::min(width / half_aspect, 1.0f);
    point.scale = Color3f(1, 1, 1);
    return point;
}

std::array<float, AlbedoRatio::kAxes> AlbedoRatio::coordinates(const ShadingPoint& point) const {
    const float phi = m_axes[1].count > 1 ? std::atan2(std::abs(point.wo.y), std::abs(point.wo.x)) : 0.0f;
    const float width = m_axes[2].count > 1 ? std::log2(std::sqrt(point.mx * point.my)) : 0.0f;
    const float aspect = m_axes[3].count > 1 ? std::log2(point.mx / point.my) : 0.0f;
    return {std::sqrt(std::max(point.wo.z, 0.0f)), phi, width, aspect};
}

float AlbedoRatio::at(const ShadingPoint& point) const {
    if (m_ratio.empty()) return 1.0f;
    const std::array<float, kAxes> x = coordinates(point);
    std::array<int, kAxes> low{};
    std::array<float, kAxes> part{};
    for (int a = 0; a < kAxes; ++a) {
        const Axis& axis = m_axes[a];
        if (axis.count == 1) continue;
        const float at = std::clamp((x[a] - axis.low) / (axis.high - axis.low), 0.0f, 1.0f) * (axis.count - 1);
        low[a] = std::min(static_cast<int>(at), axis.count - 2);
        part[a] = at - low[a];
    }
    float sum = 0;
    for (int corner = 0; corner < 1 << kAxes; ++corner) {
        float weight = 1;
        int index = 0;
        for (int a = 0, stride = 1; a < kAxes; stride *= m_axes[a].count, ++a) {
            const bool upper = corner >> a & 1;
            weight *= upper ? part[a] : 1 - part[a];
            index += stride * (low[a] + (upper && m_axes[a].count > 1 ? 1 : 0));
        }
        if (weight > 0) sum += weight * m_ratio[index];
    }
    return sum;
}

}  // namespace burnish
