// Colour on its way through a job: the environment into the frame's space, where shading happens, and results out of it.
#pragma once

#include <burnish/composite/composite.h>
#include <burnish/input/color.h>
#include <burnish/job/job.h>
#include <burnish/output/preview.h>

#include <optional>

namespace burnish {

class ColorFlow {
public:
    /// Loads a config only when a space or a preview asks for one. Throws Error(color_space) for spaces the config does not
    /// know, and for a frame's space that is not linear.
    explicit ColorFlow(const Job& job);

    void from_environment(Image& picture) const;
    /// Of a light near the objects; "" = it is in the frame's space.
    void from_space(Image& picture, const std::string& space) const;
    void to_output(Composite& composite) const;
    /// For pictures that went through `to_output`.
    PreviewSettings preview() const;

private:
    std::optional<ColorConfig> m_config;
    std::string m_working, m_environment, m_output;
};

}  // namespace burnish
