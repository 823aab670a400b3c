// The attributes of a frame's first part (timecode, camera, host, ...), by their exact names.
//
// Names are those OpenImageIO gives. The letter case matters: `worldToCamera` is the standard attribute, while
// `worldtocamera` is what V-Ray's `cameraTransform` (camera to world!) becomes on reading.
#pragma once

#include <burnish/base/types.h>

#include <optional>
#include <string>
#include <vector>

namespace burnish {

struct Metadata;

/// Channels of the file, and those of them that were decoded.
struct ChannelCounts {
    size_t decoded = 0, all = 0;
};
ChannelCounts channel_counts(const Metadata& metadata);

/// Names of all attributes, in the order of the file.
std::vector<std::string> attribute_names(const Metadata& metadata);

/// A string attribute; nothing when there is none of that name and type.
std::optional<std::string> string_attribute(const Metadata& metadata, const std::string& name);

/// A float, double or integer attribute.
std::optional<double> number_attribute(const Metadata& metadata, const std::string& name);

/// A 4x4 matrix (m44f, or 16 floats) in Imath's convention: row vectors, translation in row 3.
std::optional<Matrix44f> matrix_attribute(const Metadata& metadata, const std::string& name);

}  // namespace burnish
