// Directions laid out flat: how a small picture holds a function of direction, and which of its texels a lookup blends.
//
//     hemispherical      p = (x, y)                 z >= 0
//     parabolic          p = (x, y) / (1 + z)       z >= 0, and on beyond the horizon      Heidrich & Seidel 1998
//     double_parabolic   two of these side by side: z >= 0 on the left, z < 0 on the right with p = (x, y) / (1 - z)
//     cube               six faces, one below the other, as the pyramids of light have them (cube_faces.h)
//     elevation          z in [0, 1] alone, one row: the horizon in the middle of the first texel, z = 1 in that of the last
//
// Columns go with x and rows with y, row 0 at the least y (on cubes as the faces have them). A disc's rim |p| = 1 lies one texel inside
// its square, so that lookups at the horizon have texels on both sides: those beyond the rim continue a single disc, and of two discs
// they repeat the other one (`seams`). Lookups on a cube blend across its edges.
#pragma once

#include <burnish/base/types.h>

#include <array>
#include <string_view>
#include <vector>

namespace burnish {

enum class Mapping { hemispherical, parabolic, double_parabolic, cube, elevation };

/// "double_parabolic"
std::string_view mapping_name(Mapping mapping);
/// Throws Error(bad_argument) with the known names.
Mapping mapping_by_name(std::string_view name);

/// Texels of a picture, row by row, and what they count for: adds up to 1. A texel may come more than once.
struct BlendedTexels {
    std::array<int, 4> texel;
    std::array<float, 4> weight;
};

/// A place in a picture, columns and rows from its corner: texel middles lie at halves.
struct MapPlace {
    float x, y;
};

class DirectionMap {
public:
    /// `size`: texels along a side of a disc or face, or of the row. Throws Error(bad_argument) outside kLeastSize to kMostSize.
    DirectionMap(Mapping mapping, int size);

    Mapping mapping() const { return m_mapping; }
    int size() const { return m_size; }
    int width() const { return m_mapping == Mapping::double_parabolic ? 2 * m_size : m_size; }
    int height() const { return m_mapping == Mapping::cube ? 6 * m_size : m_mapping == Mapping::elevation ? 1 : m_size; }
    int texels() const { return width() * height(); }
    bool is_whole_sphere() const { return m_mapping == Mapping::double_parabolic || m_mapping == Mapping::cube; }

    /// Where the unit direction d lies; below the horizon of what ends there: its nearest place.
    MapPlace place(const Vec3f& d) const;
    /// The bilinear lookup of a unit direction.
    BlendedTexels lookup(const Vec3f& d) const;

    /// The inverse of `place` at a texel's middle, unit.
    Vec3f direction(int texel) const;
    /// Whether the middle is a direction of this place alone: not beyond a rim.
    bool holds(int texel) const;
    /// Steradian, by the mapping's Jacobian at the middle; of a cube's exactly. 0 where the texel holds nothing.
    double solid_angle(int texel) const;

    /// Texels next to it that may be blended with it, across a cube's edges, too.
    std::vector<int> neighbours(int texel) const;

    /// A texel beyond a rim of two discs, and what it repeats.
    struct Seam {
        int texel;
        BlendedTexels repeats;
    };
    std::vector<Seam> seams() const;

    static constexpr int kLeastSize = 4, kMostSize = 1024;

private:
    float radius() const { return 0.5f * static_cast<float>(m_size) - 1; }  // of a disc, texels
    Vec2f on_disc(int texel) const;
    bool is_looked_up(int texel) const;
    BlendedTexels blend(const MapPlace& place, int first_column) const;
    BlendedTexels cube_lookup(const Vec3f& d) const;
    int cube_texel(int face, int x, int y) const;

    Mapping m_mapping;
    int m_size;
};

}  // namespace burnish
