#include <burnish/job/color_flow.h>

#include <burnish/base/error.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

/// Twice the light must be twice the number.
void expect_linear(const std::string& space, const ColorConfig& config) {
    Image probe(2, 1, 3, 0.25f);
    for (int c = 0; c < 3; ++c) probe.at(1, 0)[c] = 0.5f;
    convert(probe, space, "scene_linear", config);
    if (std::abs(probe.at(1, 0)[1] - 2 * probe.at(0, 0)[1]) > 1e-3f)
        throw Error(ErrorCode::color_space, "beauty_space: '" + space +
                                                "' is not linear, and light adds up only in linear colour; "
                                                "convert the frame first, or name the linear space it is in");
}

}  // namespace

ColorFlow::ColorFlow(const Job& job)
    : m_working(job.color.beauty.empty() ? "scene_linear" : job.color.beauty),
      m_environment(job.color.environment),
      m_output(job.color.output) {
    const ColorSpaces& spaces = job.color;
    const bool named = !spaces.beauty.empty() || !m_environment.empty() || !m_output.empty() || !spaces.config.empty();
    const bool of_lights = std::ranges::any_of(job.lights, [](const auto& light) { return !light.second.space.empty(); });
    if (!named && !of_lights && job.output.preview.empty()) return;
    m_config = ColorConfig::load(spaces.config);
    expect_linear(m_working, *m_config);
    Image probe(1, 1, 3);
    from_environment(probe);
    for (const auto& [name, light] : job.lights) from_space(probe, light.space);
    if (!m_output.empty()) convert(probe, m_working, m_output, *m_config);
}

void ColorFlow::from_environment(Image& picture) const { from_space(picture, m_environment); }

void ColorFlow::from_space(Image& picture, const std::string& space) const {
    if (!space.empty()) convert(picture, space, m_working, *m_config);
}

void ColorFlow::to_output(Composite& composite) const {
    if (m_output.empty()) return;
    for (Image* image : {&composite.beauty, &composite.overlay, &composite.diffuse})
        if (!image->empty()) convert(*image, m_working, m_output, *m_config);
}

PreviewSettings ColorFlow::preview() const {
    PreviewSettings settings;
    settings.config = m_config.value();
    settings.space = m_output.empty() ? m_working : m_output;
    return settings;
}

}  // namespace burnish
