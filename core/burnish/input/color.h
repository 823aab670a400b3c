// Colour management by OpenColorIO: from the space a picture is in to the space the work is done in, and to a display.
//
// Overlay, environment and beauty must share primaries; data layers (position, normal, ids) are never converted. A studio
// brings its config by $OCIO or --colorconfig; without one a plain config serves:
//
//   lin_rec709 (linear, scene_linear, ...)   ACEScg (lin_ap1)   ACES2065-1 (lin_ap0)   sRGB (texture curve)   raw (data)
#pragma once

#include <burnish/base/image.h>

#include <memory>
#include <string>
#include <vector>

namespace burnish {

class ColorConfig {
public:
    /// The config of `file`; if that is empty the one of $OCIO; without that the plain config. Throws Error(color_space).
    static ColorConfig load(const std::string& file = {});

    /// File of the config, or "plain".
    const std::string& name() const;
    /// Colour spaces, without aliases and roles.
    std::vector<std::string> spaces() const;
    std::vector<std::string> displays() const;
    std::vector<std::string> views(const std::string& display) const;

    /// The config behind; for color.cpp.
    struct State;
    const State& state() const { return *m_state; }

private:
    explicit ColorConfig(std::shared_ptr<const State> state) : m_state(std::move(state)) {}
    std::shared_ptr<const State> m_state;
};

/// Converts the first three channels in place. Names are colour spaces, aliases or roles ("scene_linear"), in any case.
/// Throws Error(color_space) that names the nearest for an unknown one.
void convert(Image& image, const std::string& from, const std::string& to, const ColorConfig& config);

/// From scene-referred light in space `from` to display code values; they are not clamped. An empty display or view is the
/// config's default; "plain" has the display sRGB with the view Standard. Throws Error(color_space).
void apply_view(Image& image, const std::string& from, const std::string& display, const std::string& view,
                const ColorConfig& config);

}  // namespace burnish
