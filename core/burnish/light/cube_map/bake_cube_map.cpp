#include <burnish/base/parallel.h>
#include <burnish/light/cube_map/bake_cube_map.h>
#include <burnish/light/filter/cube_faces.h>
#include <burnish/sampling/sequence.h>
#include <burnish/scene/gbuffer.h>

namespace burnish {
namespace {

/// Unit direction in the world of a place in the strip of faces, in texels.
Vec3f strip_direction(const CubeMapView& view, int face, float x, float y) {
    const auto size = static_cast<float>(view.face_size);
    const Vec3f d = cube_direction(face, x / size, y / size);
    return view.up == UpAxis::z ? Vec3f(d.x, -d.z, d.y) : d;
}

struct Texel {
    Color3f radiance{0, 0, 0};
    float cover = 0, distance = kMissDepth;
};

Texel bake_texel(const Tracer& tracer, const SurfaceLight& light, const CubeMapView& view, int x, int row) {
    const int face = row / view.face_size, y = row % view.face_size;
    const auto left = static_cast<float>(x), top = static_cast<float>(y), samples = static_cast<float>(view.samples);
    Texel texel;
    if (const auto hit =
            tracer.closest(view.centre, strip_direction(view, face, left + 0.5f, top + 0.5f), 0, kInfinitelyFar, view.hidden))
        texel.distance = hit->distance;
    const float spread = 2 / static_cast<float>(view.face_size) / std::sqrt(samples);  // of a sample, in the middle of a face
    const auto seed = hash_bits(static_cast<uint32_t>(x), static_cast<uint32_t>(row));
    for (uint32_t i = 0; i < static_cast<uint32_t>(view.samples); ++i) {
        const Vec2f u = owen_sobol(i, seed);
        const Vec3f d = strip_direction(view, face, left + u.x, top + u.y);
        const auto hit = tracer.closest(view.centre, d, 0, kInfinitelyFar, view.hidden);
        if (!hit) continue;
        const float cosine = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        texel.radiance += light.radiance(*hit, spread * hit->distance * cosine) / samples;
        texel.cover += 1 / samples;
    }
    return texel;
}

}  // namespace

CubeMapPicture bake_cube_map(const Tracer& tracer, const SurfaceLight& light, const CubeMapView& view,
                             const Progress& progress) {
    const int width = view.face_size, height = 6 * view.face_size;
    CubeMapPicture picture{view.centre, Image::unset(width, height, 4), Image::unset(width, height, 1)};
    for_each_tile(width, height, progress, "cube map", [&](const Window& tile) {
        for (int y = tile.y; y < tile.y + tile.height; ++y)
            for (int x = tile.x; x < tile.x + tile.width; ++x) {
                const Texel texel = bake_texel(tracer, light, view, x, y);
                float* to = picture.rgba.at(x, y);
                to[0] = texel.radiance.x, to[1] = texel.radiance.y, to[2] = texel.radiance.z, to[3] = texel.cover;
                *picture.distance.at(x, y) = texel.distance;
            }
    });
    return picture;
}

}  // namespace burnish
