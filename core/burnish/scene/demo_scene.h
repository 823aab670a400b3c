// The scene of `burnish demo`: a table of objects under an open sky, each made of something that shines differently.
#pragma once

#include <burnish/scene/scene.h>

namespace burnish {

/// Objects by formula, Z up, metres; object and material indices count from 1, the ground has 1 and 1. Objects that share a
/// material share its index.
Scene make_demo_scene();

/// Where the picture is taken from.
struct Viewpoint {
    Vec3f position, look_at, up;
    float fov_x_deg;  // whole angle across
};
Viewpoint demo_viewpoint();

}  // namespace burnish
