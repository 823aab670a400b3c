#include <burnish/output/envmap_writer.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/light/latlong.h>
#include <burnish/output/exr_pixels.h>

#include <algorithm>
#include <filesystem>

namespace burnish {
namespace {

/// From the picture's axes (Y up) to the world's.
Vec3f to_world(const Vec3f& d, UpAxis up) { return up == UpAxis::z ? Vec3f(d.x, -d.z, d.y) : d; }

/// Direction and solid angle of a texel.
struct Texel {
    Vec3f d;
    float solid_angle;
};

Texel latlong_texel(int x, int y, int width) {
    const float step = 2 * kPi / static_cast<float>(width), theta = (static_cast<float>(y) + 0.5f) * step;
    const Vec2f uv((static_cast<float>(x) + 0.5f) / static_cast<float>(width), theta / kPi);
    return {latlong_direction(uv), step * step * std::sin(theta)};
}

Texel cube_texel(int x, int y, int size) {
    const float n = static_cast<float>(size), s = (static_cast<float>(x) + 0.5f) / n;
    const Vec3f d = cube_direction(y / size, s, (static_cast<float>(y % size) + 0.5f) / n);
    const float largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    return {d, 4 / (n * n) * largest * largest * largest};
}

OIIO::ImageSpec envmap_spec(const std::string& file, const Image& picture, int channels, EnvmapLayout layout) {
    if (std::filesystem::path(file).extension() != ".exr")
        throw Error(ErrorCode::bad_argument, file + ": environment maps are written as EXR; end the name in .exr");
    OIIO::ImageSpec spec(picture.width, picture.height, channels, OIIO::TypeHalf);
    spec.attribute("compression", "zip");
    spec.attribute("textureformat", layout == EnvmapLayout::latlong ? "LatLong Environment" : "CubeFace Environment");
    spec.attribute("openexr:levelmode", 0);  // one level; else OpenImageIO waits for more of them after close()
    spec.attribute("oiio:updirection", "y");
    spec.attribute("DateTime", "");  // else OpenImageIO stamps the time of writing: same job, same bits
    return spec;
}

}  // namespace

Image envmap_picture(const Environment& light, UpAxis up, EnvmapLayout layout, int size) {
    const bool latlong = layout == EnvmapLayout::latlong;
    Image picture(size, latlong ? size / 2 : 6 * size, 3);
    for_each_index(picture.height, [&](int y) {
        for (int x = 0; x < picture.width; ++x) {
            const Texel texel = latlong ? latlong_texel(x, y, size) : cube_texel(x, y, size);
            const Vec3f d = to_world(texel.d, up) * light.world_to_light();
            const CubePyramid& pyramid = light.pyramid();
            const Color3f c = pyramid.lookup(d, std::max(pyramid.level(d, texel.solid_angle), 0.0f)) * light.gain();
            std::copy_n(&c.x, 3, picture.at(x, y));
        }
    });
    return picture;
}

void write_envmap(const std::string& file, const Image& picture, EnvmapLayout layout) {
    write_layers(file, envmap_spec(file, picture, 3, layout), {{{"R", "G", "B"}, &picture}});
}

void write_cube_map(const std::string& file, const CubeMapPicture& picture) {
    OIIO::ImageSpec spec = envmap_spec(file, picture.rgba, 5, EnvmapLayout::cube);
    spec.channelnames = {"R", "G", "B", "A", "Z"};
    spec.channelformats.assign(5, OIIO::TypeHalf);
    spec.channelformats[4] = OIIO::TypeFloat;
    spec.alpha_channel = 3, spec.z_channel = 4;
    spec.attribute("burnish:centre", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::VEC3), &picture.centre);
    write_layers(file, spec, {{{"R", "G", "B", "A"}, &picture.rgba}, {{"Z"}, &picture.distance}});
}

}  // namespace burnish
