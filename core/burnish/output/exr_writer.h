// Frame to file: the only place that writes pixels. Writes beside the target and renames, so nothing half-written stays.
// Frames too large for memory come in bands of rows.
#pragma once

#include <burnish/base/image.h>
#include <burnish/input/frame.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace burnish {

/// One layer of an output file; `channels` are full names: "R", "burnish_spec.R".
struct OutputLayer {
    std::vector<std::string> channels;
    const Image* image;
};

enum class PixelType { half, float32 };

/// Attributes of a header: name -> text.
using HeaderTexts = std::map<std::string, std::string>;

/// An EXR (ZIP) with a frame's windows and metadata (may be null), `Software` and a `burnish/history` line added.
class ExrWriter {
public:
    /// `layers` says which channels there will be. Their names have one dot at most and start with letters, so that every
    /// package shows them unchanged. `attributes`: of the header, by name. Makes the output directory when absent. Throws Error(write_failed | bad_argument).
    ExrWriter(const std::string& file, const AovFrame& frame, const std::vector<OutputLayer>& layers, PixelType type,
              const HeaderTexts& attributes = {});
    /// Unless finished, nothing is left on disk and an older file is untouched.
    ~ExrWriter();

    /// Appends the rows of these layers but `above` at their top and `below` at their bottom. Half values are clamped to
    /// +-65504. Throws Error(write_failed | size_mismatch).
    void append(const std::vector<OutputLayer>& layers, int above, int below);
    /// All rows of the data window were appended. Throws Error(write_failed).
    void finish();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// The same for layers of the whole frame. Throws Error(write_failed | size_mismatch | bad_argument).
void write_exr(const std::string& file, const AovFrame& frame, const std::vector<OutputLayer>& layers, PixelType type);

/// A part of a multi-part file: images of one size, which may be smaller than the frame.
struct OutputPart {
    std::string name;
    std::vector<OutputLayer> layers;
};

/// Several parts in one file, all with the frame's metadata, `attributes` and the display window; their data windows begin where the
/// frame's does. Channels of different parts may share names. Throws Error(write_failed | size_mismatch | bad_argument).
void write_exr_parts(const std::string& file, const AovFrame& frame, const std::vector<OutputPart>& parts, PixelType type,
                     const HeaderTexts& attributes = {});

/// Writes any bytes just so: whole or not at all (reports, JSON). Throws Error(write_failed).
void write_text(const std::string& file, const std::string& text);

}  // namespace burnish
