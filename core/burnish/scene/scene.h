// What a scene is: named objects with a mesh, ids and a matte surface. View-dependent shading is not the scene's business.
#pragma once

#include <burnish/scene/mesh.h>

#include <string>
#include <vector>

namespace burnish {

struct Object {
    std::string name;                          // as cryptomatte and the shot file name it
    std::string material;                      // name of the material it wears in the overlay; empty = none
    Mesh mesh;                                 // world space
    int object_index = 0, material_index = 0;  // as a renderer's index passes hold them; 0 = nothing
    Color3f albedo{0.5f};                      // diffuse reflectance, linear, [0, 1]
    float roughness = 0.5f;                    // artist's roughness written to the roughness layer, [0, 1]
    Color3f emission{0.0f};                    // radiance that leaves the front of its triangles, linear
};

struct Scene {
    std::vector<Object> objects;
};

}  // namespace burnish
