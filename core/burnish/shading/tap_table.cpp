#include <burnish/shading/tap_table.h>

#include <burnish/base/parallel.h>
#include <burnish/material/lobes/microfacet.h>

#include <algorithm>

namespace burnish {
namespace {

// With one or two axes, and with all three.
constexpr std::array<int, 2> kViewNodes{128, 64}, kAzimuthNodes{129, 65}, kWidthNodes{49, 33};
constexpr int64_t kMaxFloats = 1 << 25;       // 128 MB
constexpr float kLowestCosine = 1e-4f;        // of the last node; views below it, which no pixel looks from, take its taps
constexpr float kNarrowestRoughness = 0.01f;  // of the first node: sqrt(kMinWidth)

float view_measure(float cos_o) { return std::sqrt(1 - cos_o) - std::sqrt(cos_o); }

/// The inverse: with sqrt(cos_o) = cos a the measure is sin a - cos a = sqrt(2) sin(a - pi / 4).
float view_cosine(float measure) {
    const float root = std::cos(kPi / 4 + std::asin(std::clamp(measure / std::numbers::sqrt2_v<float>, -1.0f, 1.0f)));
    return root * root;
}

Vec3f mirrored_z(const Vec3f& v, float sign) { return {v.x, v.y, v.z * sign}; }

}  // namespace

std::array<TapTable::Axis, TapTable::kAxes> TapTable::axes_of(const LobeParameters& lobe) {
    const auto axis = [](float low, float high, int count) { return Axis{low, (count - 1) / (high - low), count, 1}; };
    const bool turns = lobe.mx != lobe.my, coarse = turns && lobe.per_pixel.roughness;
    std::array<Axis, kAxes> axes;
    axes[0] = axis(view_measure(1), view_measure(kLowestCosine), kViewNodes[coarse]);
    if (turns) axes[1] = axis(-1, 3, kAzimuthNodes[coarse]);
    if (lobe.per_pixel.roughness) axes[2] = axis(kNarrowestRoughness, 1, kWidthNodes[coarse]);
    axes[1].stride = axes[0].count;
    axes[2].stride = axes[0].count * axes[1].count;
    return axes;
}

bool TapTable::covers(const LobeParameters& lobe, int taps) {
    const Axis last = axes_of(lobe)[2];
    return !lobe.per_pixel.anisotropy && static_cast<int64_t>(last.stride) * last.count * padded(taps) * kFields <= kMaxFloats;
}

TapTable::TapTable(const LobeParameters& lobe, int taps)
    : m_axes(axes_of(lobe)),
      m_half_aspect(std::sqrt(lobe.mx / lobe.my)),
      m_width(std::sqrt(lobe.mx * lobe.my)),
      m_side_sign(lobe.side == Side::transmission ? -1.0f : 1.0f),
      m_taps(taps),
      m_padded(padded(taps)),
      m_data(static_cast<size_t>(node_count()) * node_floats(), 0.0f) {}

TapTable::TapTable(const LobeParameters& lobe, int taps, const Rule& rule) : TapTable(lobe, taps) {
    for_each_index(node_count(), [&](int node) {
        std::vector<Tap> made(m_taps);
        rule(node_point(node), made);
        set(node, made);
    });
}

ShadingPoint TapTable::node_point(int node) const {
    const auto measure = [&](int a) {
        const Axis& axis = m_axes[a];
        return axis.count > 1 ? axis.low + static_cast<float>(node / axis.stride % axis.count) / axis.per_unit : 0.0f;
    };
    constexpr float kLeastSine = 1e-4f;  // the view along the normal still has an azimuth: taps may turn with it
    const float cos_o = view_cosine(measure(0)), sin_o = std::max(std::sqrt(std::max(0.0f, 1 - cos_o * cos_o)), kLeastSine);
    const float a = measure(1), stretched_y = a > 1 ? 2 - a : a, stretched_x = std::copysign(1 - std::abs(stretched_y), 1 - a);
    const float x = stretched_x / azimuth_stretch(), y = stretched_y * azimuth_stretch();
    const float m = m_axes[2].count > 1 ? measure(2) * measure(2) : m_width;
    ShadingPoint point;
    point.frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    point.wo = Vec3f(sin_o * x / std::hypot(x, y), sin_o * y / std::hypot(x, y), cos_o);
    point.ng = Vec3f(0, 0, 1);
    point.mx = std::min(m * m_half_aspect, 1.0f), point.my = std::min(m / m_half_aspect, 1.0f);
    point.scale = Color3f(1, 1, 1);
    return point;
}

void TapTable::set(int node, std::span<const Tap> taps) {
    const Imath::V3d wo = Imath::V3d(node_point(node).wo).normalized();
    float* data = &m_data[static_cast<size_t>(node) * node_floats()];
    for (int i = 0; i < m_taps; ++i) {
        const Tap& tap = taps[i];
        const Imath::V3d h = (wo + Imath::V3d(mirrored_z(tap.wi, m_side_sign)).normalized()).normalized();
        const std::array<float, kFields> fields{static_cast<float>(h.x),
                                                static_cast<float>(h.y),
                                                static_cast<float>(h.z),
                                                tap.level,
                                                tap.weight.x,
                                                tap.weight.y,
                                                tap.weight.z,
                                                tap.edge};
        for (int field = 0; field < kFields; ++field) data[field * m_padded + i] = fields[field];
    }
}

std::vector<LevelRange> TapTable::level_ranges() const {
    std::vector<LevelRange> ranges;
    for (int tap = 0; tap < m_taps; ++tap) {
        const float* at = &m_data[static_cast<size_t>(level * m_padded + tap)];
        LevelRange& range = ranges.emplace_back(LevelRange{*at, *at});
        for (int node = 1; node < node_count(); ++node) {
            const float own = at[static_cast<size_t>(node) * node_floats()];
            range = {std::min(range.finest, own), std::max(range.coarsest, own)};
        }
    }
    return ranges;
}

float TapTable::measure(int axis, const ShadingPoint& point) const {
    const float x = point.wo.x * azimuth_stretch(), y = point.wo.y / azimuth_stretch();
    switch (axis) {
        case 0: return view_measure(std::clamp(point.wo.z, 0.0f, 1.0f));
        case 1: {
            const float a = y / std::max(std::abs(x) + std::abs(y), 1e-30f);
            return x < 0 ? 2 - a : a;
        }
        default: return std::sqrt(std::max(point.mx / m_half_aspect, point.my * m_half_aspect));  // the one not cut at 1
    }
}

void TapTable::at(const ShadingPoint& point, std::span<Tap> taps) const {
    std::vector<float> sum(static_cast<size_t>(m_padded) * kFields, 0.0f);
    std::array<int, kAxes> low{};
    std::array<float, kAxes> part{};
    for (int a = 0; a < kAxes; ++a) {
        const Axis& axis = m_axes[a];
        const float place =
            std::clamp((measure(a, point) - axis.low) * axis.per_unit, 0.0f, static_cast<float>(axis.count - 1));
        low[a] = std::max(std::min(static_cast<int>(place), axis.count - 2), 0);
        part[a] = place - static_cast<float>(low[a]);
    }
    for (int corner = 0; corner < 1 << kAxes; ++corner) {
        float weight = 1;
        int index = 0;
        for (int a = 0; a < kAxes; ++a) {
            const int upper = corner >> a & 1;
            weight *= upper ? part[a] : 1 - part[a];
            index += (low[a] + upper) * m_axes[a].stride;
        }
        if (weight <= 0) continue;
        const float* node = &m_data[static_cast<size_t>(index) * node_floats()];
        for (size_t i = 0; i < sum.size(); ++i) sum[i] += weight * node[i];
    }
    for (int i = 0; i < m_taps; ++i) {
        const auto field = [&](Field f) { return sum[f * m_padded + i]; };
        const Vec3f h(field(h_x), field(h_y), field(h_z));
        const Vec3f wi = h * (2 * point.wo.dot(h)) - point.wo * h.length2();
        taps[i] = {mirrored_z(wi, m_side_sign), field(level), {field(weight_r), field(weight_g), field(weight_b)}, field(edge)};
    }
}

}  // namespace burnish
