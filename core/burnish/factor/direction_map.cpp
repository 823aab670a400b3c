#include <burnish/factor/direction_map.h>

#include <burnish/base/error.h>
#include <burnish/light/filter/cube_faces.h>

#include <algorithm>
#include <string>

namespace burnish {
namespace {

constexpr std::array<std::string_view, 5> kNames = {"hemispherical", "parabolic", "double_parabolic", "cube", "elevation"};

/// The unit direction of a place on a disc, z >= 0 within the rim.
Vec3f from_disc(Mapping mapping, const Vec2f& p) {
    const float r2 = p.length2();
    if (mapping != Mapping::hemispherical) return Vec3f(2 * p.x, 2 * p.y, 1 - r2) / (1 + r2);
    return r2 < 1 ? Vec3f(p.x, p.y, std::sqrt(1 - r2)) : Vec3f(p.x, p.y, 0) / std::sqrt(r2);
}

}  // namespace

std::string_view mapping_name(Mapping mapping) { return kNames[static_cast<size_t>(mapping)]; }

Mapping mapping_by_name(std::string_view name) {
    const auto found = std::ranges::find(kNames, name);
    if (found == kNames.end())
        throw Error(
            ErrorCode::bad_argument,
            "expected hemispherical, parabolic, double_parabolic, cube or elevation as a mapping of directions, found '" +
                std::string(name) + "'");
    return static_cast<Mapping>(found - kNames.begin());
}

DirectionMap::DirectionMap(Mapping mapping, int size) : m_mapping(mapping), m_size(size) {
    if (size < kLeastSize || size > kMostSize)
        throw Error(ErrorCode::bad_argument, "the size of a direction map is " + std::to_string(size) + " texels; expected " +
                                                 std::to_string(kLeastSize) + " to " + std::to_string(kMostSize));
}

MapPlace DirectionMap::place(const Vec3f& d) const {
    if (m_mapping == Mapping::elevation) return {0.5f + std::clamp(d.z, 0.0f, 1.0f) * static_cast<float>(m_size - 1), 0.5f};
    if (m_mapping == Mapping::cube) {
        const CubeCoord at = cube_coord(d);
        const float size = static_cast<float>(m_size);
        return {at.x * size, (at.y + static_cast<float>(at.face)) * size};
    }
    Vec2f p(d.x, d.y);
    const bool right = m_mapping == Mapping::double_parabolic && d.z < 0;
    if (m_mapping != Mapping::hemispherical) p /= std::max(1 + (right ? -d.z : d.z), 1e-6f);
    if (m_mapping == Mapping::hemispherical && d.z < 0) p /= std::max(p.length(), 1e-6f);
    const float middle = 0.5f * static_cast<float>(m_size), least = 0.5f, most = static_cast<float>(m_size) - 0.5f;
    const auto along = [&](float c) { return std::clamp(middle + c * radius(), least, most); };
    return {along(p.x) + (right ? static_cast<float>(m_size) : 0.0f), along(p.y)};
}

BlendedTexels DirectionMap::blend(const MapPlace& place, int first_column) const {
    const auto split = [&](float at, int first) {
        const int low = std::clamp(static_cast<int>(std::floor(at - 0.5f)), first, first + m_size - 2);
        return std::pair(low, std::clamp(at - 0.5f - static_cast<float>(low), 0.0f, 1.0f));
    };
    const auto [x, u] = split(place.x, first_column);
    const auto [y, v] = split(place.y, 0);
    const int corner = y * width() + x;
    return {{corner, corner + 1, corner + width(), corner + width() + 1}, {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v}};
}

BlendedTexels DirectionMap::lookup(const Vec3f& d) const {
    if (m_mapping == Mapping::elevation) {
        const float at = place(d).x - 0.5f;
        const int low = std::min(static_cast<int>(at), m_size - 2);
        const float part = at - static_cast<float>(low);
        return {{low, low + 1, low, low + 1}, {1 - part, part, 0, 0}};
    }
    if (m_mapping == Mapping::cube) return cube_lookup(d);
    return blend(place(d), m_mapping == Mapping::double_parabolic && d.z < 0 ? m_size : 0);
}

int DirectionMap::cube_texel(int face, int x, int y) const {
    const auto is_outside = [&](int i) { return i < 0 || i >= m_size; };
    if (is_outside(x) && is_outside(y)) x = std::clamp(x, 0, m_size - 1);  // beyond a corner there is no texel: its neighbour
    const CubeTexel texel = unfolded_texel(face, x, y, m_size);
    return (texel.face * m_size + texel.y) * m_size + texel.x;
}

BlendedTexels DirectionMap::cube_lookup(const Vec3f& d) const {
    const CubeCoord at = cube_coord(d);
    const float px = at.x * static_cast<float>(m_size) - 0.5f, py = at.y * static_cast<float>(m_size) - 0.5f;
    const int x = static_cast<int>(std::floor(px)), y = static_cast<int>(std::floor(py));
    const float u = px - static_cast<float>(x), v = py - static_cast<float>(y);
    return {{cube_texel(at.face, x, y), cube_texel(at.face, x + 1, y), cube_texel(at.face, x, y + 1),
             cube_texel(at.face, x + 1, y + 1)},
            {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v}};
}

Vec2f DirectionMap::on_disc(int texel) const {
    const auto along = [&](int i) {
        return (static_cast<float>(i % m_size) + 0.5f - 0.5f * static_cast<float>(m_size)) / radius();
    };
    return {along(texel % width()), along(texel / width())};
}

Vec3f DirectionMap::direction(int texel) const {
    const int x = texel % width(), y = texel / width();
    if (m_mapping == Mapping::cube) {
        const Vec3f d = face_to_cube(y / m_size, face_place(x, y % m_size, m_size));
        return d / d.length();
    }
    if (m_mapping == Mapping::elevation) {
        const float z = static_cast<float>(x) / static_cast<float>(m_size - 1);
        return {std::sqrt(1 - z * z), 0, z};
    }
    Vec3f d = from_disc(m_mapping, on_disc(texel));
    if (x >= m_size) d.z = -d.z;
    return d;
}

bool DirectionMap::holds(int texel) const {
    return m_mapping == Mapping::cube || m_mapping == Mapping::elevation || on_disc(texel).length2() <= 1;
}

double DirectionMap::solid_angle(int texel) const {
    if (m_mapping == Mapping::cube) {
        const auto edge = [&](int i) { return 2.0 * i / m_size - 1; };
        const int x = texel % m_size, y = texel / m_size % m_size;
        return cube_solid_angle(edge(x), edge(x + 1), edge(y), edge(y + 1));
    }
    if (m_mapping == Mapping::elevation) {
        const bool is_end = texel == 0 || texel == m_size - 1;
        return 2 * std::numbers::pi / (m_size - 1) * (is_end ? 0.5 : 1.0);
    }
    if (!holds(texel)) return 0;
    const double r2 = on_disc(texel).length2(), area = 1.0 / (radius() * radius());
    return m_mapping == Mapping::hemispherical ? area / std::sqrt(std::max(1 - r2, 1e-6)) : area * 4 / ((1 + r2) * (1 + r2));
}

std::vector<int> DirectionMap::neighbours(int texel) const {
    const int x = texel % width(), y = texel / width(), column = x % m_size, row = y % m_size;
    std::vector<int> found;
    for (const auto& [dx, dy] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
        const auto is_inside = [&](int i) { return i >= 0 && i < m_size; };
        if (m_mapping == Mapping::cube)
            found.push_back(cube_texel(y / m_size, column + dx, row + dy));
        else if (is_inside(column + dx) && row + dy >= 0 && row + dy < height())
            found.push_back(texel + dy * width() + dx);
    }
    return found;
}

bool DirectionMap::is_looked_up(int texel) const {
    return on_disc(texel).length() <= 1 + std::numbers::sqrt2_v<float> / radius();
}

std::vector<DirectionMap::Seam> DirectionMap::seams() const {
    std::vector<Seam> found;
    if (m_mapping != Mapping::double_parabolic) return found;
    for (int texel = 0; texel < texels(); ++texel)
        if (!holds(texel) && is_looked_up(texel)) found.push_back({texel, lookup(direction(texel))});
    return found;
}

}  // namespace burnish
