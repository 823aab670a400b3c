#include <burnish/light/cube_map/distance_map.h>

#include <burnish/base/error.h>
#include <burnish/light/filter/cube_resample.h>
#include <burnish/light/latlong.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kNothing = 1e9f;
constexpr int kBlocks = 16;  // along a face: 2.4 degrees or more each, which is more than kReach

float reciprocal(float distance) {
    return std::isfinite(distance) && distance > 0 && distance < kNothing ? 1 / distance : 0.0f;
}

/// Length of the vector to a texel's centre over that along the face's axis.
float stretch(int x, int y, int size) { return face_place(x, y, size).length(); }

/// Median along rows of |second difference| / value, of 1 / distance along the axis: nothing where surfaces are flat.
float roughness(const std::array<Image, 6>& faces, bool planar) {
    const int size = faces[0].width;
    std::vector<float> found;
    for (const Image& face : faces)
        for (int y = 0; y < size; ++y)
            for (int x = 1; x + 1 < size; ++x) {
                const auto w = [&](int i) { return reciprocal(*face.at(i, y)) * (planar ? 1.0f : stretch(i, y, size)); };
                if (w(x) > 0) found.push_back(std::fabs(w(x - 1) + w(x + 1) - 2 * w(x)) / w(x));
            }
    if (found.empty()) return 0;
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
    std::nth_element(found.begin(), middle, found.end());
    return *middle;
}

bool is_planar(const EnvironmentPicture& picture, DistanceKind kind) {
    if (!picture.faces) return false;
    if (kind != DistanceKind::automatic) return kind == DistanceKind::planar;
    constexpr float kClearly = 2;
    const float planar = roughness(*picture.faces, true), ray = roughness(*picture.faces, false);
    if (planar * kClearly < ray) return true;
    return ray * kClearly < planar ? false : picture.six_files;
}

/// 1 / distance three times over, as lookups in a lat-long want it.
Image reciprocals(const Image& distances) {
    Image rgb(distances.width, distances.height, 3);
    for (size_t i = 0; i < rgb.pixel_count(); ++i) std::fill_n(rgb.at(i), 3, reciprocal(*distances.at(i)));
    return rgb;
}

}  // namespace

DistanceMap DistanceMap::load(const CubeMapSettings& settings) {
    const std::string& file = settings.depth.empty() ? settings.file : settings.depth;
    if (!environment_has_layer(file, PictureLayer::distance))
        throw Error(ErrorCode::missing_channel, file +
                                                    ": no distances for the depth proxy: expected a channel Z or Depth.Z. "
                                                    "Render the cube map with its depth pass, name the file that has it "
                                                    "as the map's depth, or choose another proxy.");
    return {read_environment_picture(file, PictureLayer::distance), settings.picture, settings.distances};
}

DistanceMap::DistanceMap(EnvironmentPicture picture, const EnvironmentSettings& orientation, DistanceKind kind) {
    m_world_to_map = orient(picture, orientation).world_to_light;
    m_size = picture.faces ? (*picture.faces)[0].width : cube_size_for_latlong(picture.latlong.width);
    m_texels.resize(6 * static_cast<size_t>(m_size + 2) * (m_size + 2));
    const bool planar = is_planar(picture, kind);
    const Image latlong = picture.faces ? Image() : reciprocals(picture.latlong);
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < m_size; ++y)
            for (int x = 0; x < m_size; ++x) {
                const float longer = planar ? 1.0f : stretch(x, y, m_size);
                const Vec3f d = face_to_cube(face, face_place(x, y, m_size));
                const float w = picture.faces ? reciprocal(*(*picture.faces)[face].at(x, y))
                                              : latlong_bilinear(latlong, latlong_coord(d.normalized())).x;
                *at(face, x, y) = longer * w;
            }
    fill_borders();
    fill_bounds();
}

/// The four texels about a place and where it lies between them.
struct DistanceMap::Cell {
    int face;
    float u, v, along;  // place on the face [-1, 1]^2, right and up; length along the face's axis
    float fx, fy;
    const float *top, *bottom;

    float value() const {
        const float above = top[0] + (top[1] - top[0]) * fx, below = bottom[0] + (bottom[1] - bottom[0]) * fx;
        return above + (below - above) * fy;
    }
};

DistanceMap::Cell DistanceMap::cell(const Vec3f& x) const {
    const CubeCoord c = cube_coord(x);
    const auto size = static_cast<float>(m_size);
    const float px = c.x * size + 0.5f, py = c.y * size + 0.5f;
    const int ix = static_cast<int>(px), iy = static_cast<int>(py), stride = m_size + 2;
    const float* top = &m_texels[(static_cast<size_t>(c.face) * stride + iy) * stride + ix];
    return {
        c.face, 2 * c.x - 1, 1 - 2 * c.y, std::fabs(x[c.face / 2]), px - static_cast<float>(ix), py - static_cast<float>(iy),
        top,    top + stride};
}

float DistanceMap::nearer(const Vec3f& x) const {
    const Cell c = cell(x);
    return c.along * c.value();
}

Vec3f DistanceMap::gradient(const Vec3f& x) const {
    const Cell c = cell(x);
    const float per_texel = 0.5f * static_cast<float>(m_size);
    const float right = per_texel * ((c.top[1] - c.top[0]) * (1 - c.fy) + (c.bottom[1] - c.bottom[0]) * c.fy);
    const float up = per_texel * ((c.top[0] - c.bottom[0]) * (1 - c.fx) + (c.top[1] - c.bottom[1]) * c.fx);
    return face_to_cube(c.face, {c.value() - c.u * right - c.v * up, right, up});
}

float DistanceMap::jump(const Vec3f& x) const {
    const Cell c = cell(x);
    const auto [low, high] = std::minmax({c.top[0], c.top[1], c.bottom[0], c.bottom[1]});
    return high / std::max(low, 1e-30f);
}

float DistanceMap::bound(const Vec3f& d) const {
    const CubeCoord c = cube_coord(d);
    const auto block = [](float x) { return std::min(static_cast<int>(x * kBlocks), kBlocks - 1); };
    return m_bounds[(static_cast<size_t>(c.face) * kBlocks + block(c.y)) * kBlocks + block(c.x)];
}

// What lies beyond an edge, seen along this face's axis: bilinear among the neighbour's own texels.
void DistanceMap::fill_borders() {
    const int last = m_size - 1;
    const auto own = [&](const Vec3f& x) {
        const CubeCoord c = cube_coord(x);
        const auto place = [&](float i) {
            return std::clamp(i * static_cast<float>(m_size) - 0.5f, 0.0f, static_cast<float>(last));
        };
        const float px = place(c.x), py = place(c.y);
        const int ix = static_cast<int>(px), iy = static_cast<int>(py), jx = std::min(ix + 1, last),
                  jy = std::min(iy + 1, last);
        const float fx = px - static_cast<float>(ix), fy = py - static_cast<float>(iy);
        const float above = *at(c.face, ix, iy) * (1 - fx) + *at(c.face, jx, iy) * fx;
        const float below = *at(c.face, ix, jy) * (1 - fx) + *at(c.face, jx, jy) * fx;
        return std::fabs(x[c.face / 2]) * (above * (1 - fy) + below * fy);
    };
    for (int face = 0; face < 6; ++face)
        for (int i = -1; i <= m_size; ++i)
            for (const int edge : {-1, m_size}) {
                *at(face, i, edge) = own(face_to_cube(face, face_place(i, edge, m_size)));
                *at(face, edge, i) = own(face_to_cube(face, face_place(edge, i, m_size)));
            }
}

void DistanceMap::fill_bounds() {
    std::vector<float> own(6 * kBlocks * kBlocks, 0.0f);
    const auto index = [](int face, int x, int y) { return (static_cast<size_t>(face) * kBlocks + y) * kBlocks + x; };
    const float within_texel =
        1 + 3 / static_cast<float>(m_size);  // 1 / R changes less between two texels of a plane through both
    for (int face = 0; face < 6; ++face)
        for (int y = -1; y <= m_size; ++y)
            for (int x = -1; x <= m_size; ++x) {
                const float here = *at(face, x, y) / stretch(x, y, m_size) * within_texel;
                const auto first = [&](int i) { return std::clamp((i - 1) * kBlocks / m_size, 0, kBlocks - 1); };
                const auto last = [&](int i) { return std::clamp(((i + 2) * kBlocks - 1) / m_size, 0, kBlocks - 1); };
                for (int block_y = first(y); block_y <= last(y); ++block_y)
                    for (int block_x = first(x); block_x <= last(x); ++block_x) {
                        float& most = own[index(face, block_x, block_y)];
                        most = std::max(most, here);
                    }
            }
    m_bounds = own;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < kBlocks; ++y)
            for (int x = 0; x < kBlocks; ++x)
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        const bool beyond_x = x + dx < 0 || x + dx >= kBlocks, beyond_y = y + dy < 0 || y + dy >= kBlocks;
                        if (beyond_x && beyond_y) continue;  // three faces meet there: both others are neighbours anyway
                        const CubeTexel t = unfolded_texel(face, x + dx, y + dy, kBlocks);
                        float& most = m_bounds[index(face, x, y)];
                        most = std::max(most, own[index(t.face, t.x, t.y)]);
                    }
}

}  // namespace burnish
