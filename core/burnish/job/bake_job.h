// What `burnish bake` makes of a scene, as plain values, and their JSON form:
//
//     { "scene": "room.glb", "up": "z", "light_maps": {"radiance": "room_light.exr"} or {"bake": true, "size": 1024},
//       "camera": {...} or "camera.json", "size": [1920, 1080],
//       "cubes": [{"object": "vase"}, {"name": "corner", "centre": [1, 2, 1]}],
//       "mirrors": [{"object": "floor"}, {"object": "window", "plane": {"point": [...], "normal": [...]}, "behind": true}],
//       "panes": "window*", "cube_size": 256, "samples": 4, "output": "baked" }
#pragma once

#include <burnish/light/light_settings.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace burnish {

/// A cube map of what is around objects, which are not in it. Without a centre there is one for every name that matches, taken at
/// the middle of its box.
struct CubeBake {
    std::string object;  // names, see name_pattern.h
    std::string name;    // of the light and its file; "" = the object's
    std::optional<Vec3f> centre;
};

/// What a mirror shows the camera, or what is behind a pane.
struct MirrorBake {
    std::string object;          // which is not in it
    std::string name;            // "" = the object's
    std::optional<Plane> plane;  // none: the largest flat side of the object that the camera sees
    bool behind = false;
};

struct BakeJob {
    std::string scene;              // glTF or OBJ
    UpAxis up = UpAxis::automatic;  // of the world, see SceneSettings
    int texcoord = 0;
    std::string radiance, irradiance, albedo;  // light maps, see TracedSettings
    bool bake_light_maps = false;              // instead: from the scene's own lamps
    int light_map_size = 1024;                 // texels a side
    std::string camera;                        // file or JSON; "" = no frame and no mirrors
    int width = 1920, height = 1080;           // of frame and mirrors, pixels
    std::vector<CubeBake> cubes;
    std::vector<MirrorBake> mirrors;
    std::string panes;    // names of objects that let light through: in the frame, not in the pictures of the room
    int cube_size = 256;  // texels along an edge of a face
    int samples = 4;      // rays a texel or pixel
    std::string folder;
};

/// `where` names the document in messages; relative paths are taken from `base`. Throws Error(bad_argument).
BakeJob bake_job_from_json(const nlohmann::json& document, const std::string& where, const std::filesystem::path& base = {});

}  // namespace burnish
