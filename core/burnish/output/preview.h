// Pictures to look at: 8-bit PNGs through the display view of the studio's colour config.
#pragma once

#include <burnish/base/image.h>
#include <burnish/input/color.h>

#include <memory>
#include <optional>
#include <string>

namespace burnish {

struct PreviewSettings {
    std::optional<ColorConfig> config;   // none: $OCIO, or the plain config, which is sRGB without tone mapping
    std::string space = "scene_linear";  // colour space of the image
    std::string display, view;           // empty: the config's default
    float exposure_stops = 0;            // the light is multiplied by 2^stops
};

/// A preview whose rows are appended from the top: there when finished, else never.
class PreviewWriter {
public:
    /// Throws as write_preview does.
    PreviewWriter(const std::string& file, int width, int height, const PreviewSettings& settings);
    ~PreviewWriter();

    /// Appends the rows of `image` but `above` at its top and `below` at its bottom.
    void append(const Image& image, int above, int below);
    void finish();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// Writes linear RGB(A) as an RGB PNG; alpha is dropped, which shows associated colour over black. NaN is shown black.
/// Whole or not at all. Throws Error(bad_argument) for another file extension, Error(color_space), Error(write_failed).
void write_preview(const std::string& file, const Image& image, const PreviewSettings& settings);

/// Writes code values in [0, 1] as they are, three channels, or four where alpha is a number like the others: pictures that are keys to
/// numbers. Throws as write_preview.
void write_code_values(const std::string& file, const Image& picture);

/// Two images of the same height side by side, a thin line between them. Throws Error(size_mismatch).
void write_before_after(const std::string& file, const Image& before, const Image& after, const PreviewSettings& settings);

}  // namespace burnish
