// Which renderer wrote a file, and what its names mean where renderers disagree.
#pragma once

#include <burnish/input/layers.h>
#include <burnish/input/metadata.h>
#include <burnish/input/renderer.h>
#include <burnish/input/roles.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

struct Fingerprint {
    Renderer renderer = Renderer::unknown;
    std::string evidence;  // what gave it away, e.g. "attribute arnold/version"; "" when unknown
};

/// By attribute names first, then by the texts of Software and its like, then by layer names only one renderer uses.
Fingerprint fingerprint(const Metadata& metadata, const std::vector<Layer>& layers);

/// What a layer name means beyond the general aliases.
struct Meaning {
    bool holds_both = false;       // direct and indirect light together
    bool is_camera_space = false;  // positions or normals in the camera's frame
    std::string_view remark;       // for the notes, may be empty
};

/// The renderer's own meaning of `layer` (normal form) as `role`; nothing when the general aliases hold.
std::optional<Meaning> meaning_of(Renderer renderer, Role role, std::string_view layer);

/// Whether this renderer's (or this layer's) depth is the length of the ray rather than planar depth.
bool depth_is_ray_length(Renderer renderer, std::string_view layer);

}  // namespace burnish
