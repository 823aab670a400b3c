#include <burnish/frequency/layer_change.h>

#include <burnish/frequency/cell_turning.h>

#include <algorithm>
#include <limits>

namespace burnish {
namespace {

constexpr float kMostChange = 0.02f;  // of a factor or an angle, from pixel to pixel: more is a texture, not a gradient
constexpr float kInfinite = std::numeric_limits<float>::infinity();

/// A lobe of width alpha spreads over sigma = sqrt(2) alpha. Its rim moves by the change of sigma, as it would where normals turned
/// by half of it. And the light it averages changes by sigma * its own bend * the change: along a ramp interpolation follows that,
/// elsewhere it misses as much as where normals turn by sqrt(sigma * second difference of sigma) / 2.
float width_change(float before, float a, float b) {
    return std::max(std::fabs(a - b) / std::sqrt(2.0f), std::sqrt(0.5f * a * std::fabs(before - 2 * a + b)));
}
float alpha_change(const float* before, const float* a, const float* b) {
    return width_change(before ? *before : 2 * *a - *b, *a, *b);
}
float roughness_change(const float* before, const float* a, const float* b) {
    const float here = *a * *a, next = *b * *b;
    return width_change(before ? *before * *before : 2 * here - next, here, next);
}

bool is_small(float difference, float size) { return std::fabs(difference) <= kMostChange * size; }
float angle_change(const float*, const float* a, const float* b) { return is_small(*a - *b, 1) ? 0 : kInfinite; }
float factor_change(const float*, const float* a, const float* b) {
    return is_small(*a - *b, std::max(*a, *b)) ? 0 : kInfinite;
}
float color_change(const float*, const float* a, const float* b) {
    const float size = std::max({a[0], a[1], a[2], b[0], b[1], b[2]});
    const bool small = is_small(a[0] - b[0], size) && is_small(a[1] - b[1], size) && is_small(a[2] - b[2], size);
    return small ? 0 : kInfinite;
}

}  // namespace

LayerChange::LayerChange(const AovFrame& frame, const PerPixel& used, bool roughness_is_alpha) {
    const auto add = [&](bool is_used, Role role, auto change) {
        if (const Image* image = is_used ? frame.find(role) : nullptr) m_layers.push_back({image, change});
    };
    add(used.roughness, Role::roughness, roughness_is_alpha ? alpha_change : roughness_change);
    add(used.anisotropy, Role::anisotropy, angle_change);
    add(used.rotation, Role::rotation, angle_change);
    add(used.weight, Role::weight, factor_change);
    add(used.tint, Role::tint, color_change);
}

void LayerChange::add(int y, int first, int count, int dx, int dy, float* squares) const {
    for (const Layer& layer : m_layers) {
        if (y + dy >= layer.image->height) return;
        for (int i = 0; i < std::min(count, layer.image->width - first - dx); ++i) {
            const int x = first + i;
            const bool has_before = x % CellTurning::kLargest >= dx && y % CellTurning::kLargest >= dy;
            const float change = layer.change(has_before ? layer.image->at(x - dx, y - dy) : nullptr, layer.image->at(x, y),
                                              layer.image->at(x + dx, y + dy));
            squares[i] = change * change <= squares[i] ? squares[i] : change * change;
        }
    }
}

}  // namespace burnish
