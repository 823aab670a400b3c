// How far a cube map's centre sees, in every direction.
//
// Kept is  w(x) = |x| / R(x / |x|),  R the distance in a direction: below 1 in front of what the centre sees, above 1 behind it.
// For a plane w is linear in x, so on a cube's face, where the texels hold 1 / (distance along the face's axis), bilinear lookups are
// exact on flat walls. 0 = nothing is seen.
#pragma once

#include <burnish/light/environment_picture.h>
#include <burnish/light/filter/cube_faces.h>
#include <burnish/light/light_settings.h>

#include <vector>

namespace burnish {

class DistanceMap {
public:
    /// Reads the distances of a cube map's settings. Throws Error(missing_channel) where the file has none, and what
    /// Environment::load throws.
    static DistanceMap load(const CubeMapSettings& settings);
    /// From one-channel pictures. `automatic`: lengths of rays in a lat-long; in cubes what makes most of the surfaces flat, or
    /// where that does not tell, planar in six files, else lengths of rays. Distances of 1e9 and more, not finite or not positive: nothing.
    DistanceMap(EnvironmentPicture picture, const EnvironmentSettings& orientation, DistanceKind kind);

    int size() const { return m_size; }
    /// World direction -> the map's axes, which the following are in; row vector times matrix.
    const Matrix33f& world_to_map() const { return m_world_to_map; }

    /// w at x, any length but 0.
    float nearer(const Vec3f& x) const;
    /// Its gradient: the normal, away from the centre, of the surface that the centre sees in that direction.
    Vec3f gradient(const Vec3f& x) const;
    /// How many times as far as the nearest the farthest of the four texels about x is: large where surfaces end.
    float jump(const Vec3f& x) const;
    /// At least the largest 1 / R of the directions within kReach of d.
    float bound(const Vec3f& d) const;

    static constexpr float kReach = 0.0393f;  // radian, 2.25 degrees

private:
    struct Cell;
    Cell cell(const Vec3f& x) const;
    float* at(int face, int x, int y) {
        return &m_texels[(static_cast<size_t>(face) * (m_size + 2) + y + 1) * (m_size + 2) + x + 1];
    }
    void fill_borders();
    void fill_bounds();

    int m_size = 0;
    std::vector<float> m_texels;  // six faces with a border of one
    std::vector<float> m_bounds;  // six faces of kBlocks^2
    Matrix33f m_world_to_map;
};

}  // namespace burnish
