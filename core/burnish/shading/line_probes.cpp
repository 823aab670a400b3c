#include <burnish/shading/line_probes.h>

#include <algorithm>

namespace burnish {
namespace {

/// The lobe's image to first order: its standard deviations along both axes, rad, and the longer axis in slopes, one
/// deviation long.
struct LobeImage {
    float major, minor;
    Vec2f axis;
};

LobeImage lobe_image(const Vec3f& wo, float mx, float my) {
    const DirectionSlopes J = direction_slopes(wo, 0, 0);
    const float sx = mx / std::sqrt(2.0f), sy = my / std::sqrt(2.0f);
    const Vec3f x = J.x * sx, y = J.y * sy;
    const float xx = x.dot(x), xy = x.dot(y), yy = y.dot(y);
    const float angle = 0.5f * std::atan2(2 * xy, xx - yy), c = std::cos(angle), s = std::sin(angle);
    const float root = std::sqrt(0.25f * (xx - yy) * (xx - yy) + xy * xy), mean = 0.5f * (xx + yy);
    return {std::sqrt(mean + root), std::sqrt(std::max(mean - root, 1e-4f * mean)), {c * sx, s * sy}};
}

}  // namespace

std::vector<GaussianTap> line_probes(const Vec3f& wo, float mx, float my, int taps, float reach, float spread) {
    const LobeImage image = lobe_image(wo, mx, my);
    const float spacing = taps > 1 ? 2 * reach / static_cast<float>(taps - 1) : 0;
    const float width = std::max(image.minor, 0.5f * spacing * image.major);
    std::vector<GaussianTap> line;
    for (int i = 0; i < taps; ++i) {
        const float s = taps > 1 ? spacing * static_cast<float>(i) - reach : 0;
        const float own_width = width * (i % 2 == 1 ? spread : 1.0f);
        line.push_back({s * image.axis.x, s * image.axis.y, std::log(std::min(own_width, 0.7f)), Color3f(0)});
    }
    return line;
}

}  // namespace burnish
