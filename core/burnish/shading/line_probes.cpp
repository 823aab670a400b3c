#include <burnish/shading/line_probes.h>

#include <burnish/shading/lobe_image.h>

#include <algorithm>

namespace burnish {

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
