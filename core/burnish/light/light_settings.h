// What a shot file says of the lights near the objects, as plain values. Lengths are scene units, places are world space.
#pragma once

#include <burnish/light/environment.h>

#include <string>
#include <variant>
#include <vector>

namespace burnish {

struct Plane {
    Vec3f point{0, 0, 0}, normal{0, 0, 1};  // the normal need not be a unit vector, nor point to any one side
};

struct OrientedBox {
    Vec3f centre{0, 0, 0}, half{1, 1, 1};      // half: of the edges, > 0
    Vec3f x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};  // unit edge directions, perpendicular to each other
};

/// What stands for the room where rays of a cube map end. `infinite`: nothing, rays are looked up by direction alone;
/// `depth`: the map's own distances; `mesh`: a glTF or OBJ file, met by ray tracing.
enum class ProxyKind { infinite, planes, box, depth, mesh };

struct ProxySettings {
    ProxyKind kind = ProxyKind::infinite;
    std::vector<Plane> planes;  // one or more
    OrientedBox box;
    std::string mesh;
};

/// What the distances of a cube map measure: `planar`, along the axis of their face; `ray`, from the centre; `automatic`:
/// see distance_map.h.
enum class DistanceKind { automatic, planar, ray };

/// The room as seen from one point.
struct CubeMapSettings {
    std::string file;   // as Environment::load takes it
    std::string depth;  // picture or six pictures with the distances; "" = the channels Z or Depth.Z of `file`
    DistanceKind distances = DistanceKind::automatic;
    Vec3f centre{0, 0, 0};        // where it was taken
    EnvironmentSettings picture;  // how it lies over directions
    ProxySettings proxy;
};

/// What a camera sees: `mirror`, of the room from behind a mirror's plane, which it does not see; `behind`, from the frame's own
/// camera, of what lies behind a pane, which it does not see.
struct MirrorSettings {
    std::string file;    // EXR with radiance, position (or depth) and normal; may hold a frame pattern
    std::string camera;  // of the picture: JSON or file; "" = the frame's camera, mirrored for a mirror
    Plane plane;         // of the mirror or pane
    bool behind = false;
    bool second_step = true;  // meet the surface that the first guess found, again
};

/// A planar polygon that shines.
struct AreaSettings {
    std::vector<Vec3f> corners;  // three or more, convex, counter-clockwise seen from the side that shines
    Color3f radiance{1, 1, 1};
    std::string
        texture;  // picture that multiplies the radiance: its lower left corner lies at corners[0], its lower edge along
                  // the way to corners[1]; four corners that make a parallelogram; "" = none
    bool two_sided = false;
};

/// Geometry with baked light, met by ray tracing.
struct TracedSettings {
    std::string scene;              // glTF or OBJ
    std::string radiance;           // light map: what leaves the surface, emission included; "" = from irradiance
    std::string irradiance;         // light map: irradiance / pi, to be multiplied by the albedo; "" = none
    std::string albedo;             // map of diffuse reflectance; "" = the materials' base colours
    UpAxis up = UpAxis::automatic;  // of the render's world; OBJ files are in its axes, glTF has Y up and is turned
    int texcoord = 0;               // set of texture coordinates that the maps lie over
    int rays = 4;                   // that a lookup's cone is averaged from, 1 to 64
};

struct LightSettings {
    std::variant<CubeMapSettings, MirrorSettings, AreaSettings, TracedSettings> kind;
    float scale = 1;  // multiplies radiance
    Color3f tint{1, 1, 1};
    bool blocks = true;  // hides what comes behind it in a list of lights; area lights: false unless they say so
    std::string space;   // colour space of its pictures; "" = the frame's
};

}  // namespace burnish
