// Frame to file: the only place that writes pixels. Writes beside the target and renames, so nothing half-written stays.
#pragma once

#include <burnish/base/image.h>
#include <burnish/input/frame.h>

#include <string>
#include <vector>

namespace burnish {

/// One layer of an output file; `channels` are full names: "R", "burnish_spec.R".
struct OutputLayer {
    std::vector<std::string> channels;
    const Image* image;
};

enum class PixelType { half, float32 };

/// Writes an EXR (ZIP) with the frame's windows and metadata, `Software` and a history line added. Layer sizes must equal
/// the data window. `order`: layers as given. Throws Error(write_failed | size_mismatch).
void write_exr(const std::string& file, const AovFrame& frame, const std::vector<OutputLayer>& layers, PixelType type);

/// Writes any bytes atomically (reports, JSON).
void write_text(const std::string& file, const std::string& text);

}  // namespace burnish
