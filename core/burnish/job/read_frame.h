// The frame a job works on: from a file, or from layers in memory.
#pragma once

#include <burnish/input/exr_reader.h>
#include <burnish/job/look.h>

#include <map>
#include <string>

namespace burnish {

/// What a file is there for: all of it, or one half where there are finer AOVs.
enum class FramePart { whole, picture, surfaces };

/// What the job needs of a file. `camera`: JSON file, the JSON itself, or "" (see Job::camera). `view`: see ReadOptions.
ReadOptions read_options(const Job& job, const Wardrobe& wardrobe, const std::string& camera, FramePart part,
                         const std::string& view);

/// Reads the layers that the job needs, whole. Throws Error(read_failed | missing_channel | bad_argument).
AovFrame read_job_frame(const Job& job, const Wardrobe& wardrobe, const std::string& file, const std::string& camera,
                        FramePart part, const std::string& view);

/// A frame from layers of one size, linear and in world space. A beauty of four channels holds alpha too. Without a camera it
/// is recovered from position. Throws Error(size_mismatch | bad_argument).
AovFrame frame_from_layers(std::map<Role, Image> layers, const std::string& camera);

}  // namespace burnish
