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

/// Writes an EXR (ZIP) with the frame's windows and metadata (may be null), `Software` and a `burnish/history` line added.
/// Layer sizes must equal the data window. Channel names have one dot at most and start with letters, so that every
/// package shows them unchanged. Half values are clamped to +-65504. Makes the output directory when absent.
/// Throws Error(write_failed | size_mismatch | bad_argument); then nothing is left on disk and an older file is untouched.
void write_exr(const std::string& file, const AovFrame& frame, const std::vector<OutputLayer>& layers, PixelType type);

/// Writes any bytes just so: whole or not at all (reports, JSON). Throws Error(write_failed).
void write_text(const std::string& file, const std::string& text);

}  // namespace burnish
