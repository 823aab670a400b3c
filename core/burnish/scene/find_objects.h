// Objects of a scene by name, and the places that baking needs of them.
#pragma once

#include <burnish/scene/view.h>

#include <string>
#include <vector>

namespace burnish {

/// Indices of the objects whose names match the patterns (see name_pattern.h), in the scene's order; "" matches none.
std::vector<int> objects_named(const Scene& scene, const std::string& patterns);

/// Middle of the box around the objects' vertices. There is at least one object with a vertex.
Vec3f bounding_centre(const Scene& scene, const std::vector<int>& objects);

/// The plane that holds most of the objects' area among those whose front `eye` sees; its normal points to `eye`. Nothing when it
/// sees no front.
std::optional<HalfSpace> largest_plane(const Scene& scene, const std::vector<int>& objects, const Vec3f& eye);

}  // namespace burnish
