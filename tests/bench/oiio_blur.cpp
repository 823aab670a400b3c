// What OpenImageIO's environment lookup makes of a frame: one lookup in the mirror direction, blurred over a disc of directions.
//
//     burnish_oiio_blur FRAME.exr ENV --radius 1=0.02,2=0.1 [--rotate DEG] -o blurred.exr
//
// ENV is a lat-long as Blender lays it (+X in the middle, Z up); pixels of the material ids that have a radius, in radians, are
// looked up. Prints JSON: seconds to make the tiled MIP map (what maketx does, once a light) and of the lookups, fastest of the repeats.
#include <burnish/base/parallel.h>
#include <burnish/input/exr_reader.h>
#include <burnish/output/exr_writer.h>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>

using namespace burnish;

namespace {

struct Options {
    std::string frame, environment, output;
    std::vector<std::string> radii;  // "ID=RADIANS"
    float rotate_deg = 0;
    int threads = 0, repeats = 5;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The environment as a file that a texture system reads tile by tile, beside the output.
std::string make_texture(const Options& options) {
    const OIIO::ImageBuf picture(options.environment);
    const std::string file = options.output + ".tx.exr";
    if (!OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxEnvLatl, picture, file, OIIO::ImageSpec()))
        throw std::runtime_error(options.environment + ": " + OIIO::geterror());
    return file;
}

/// World to OpenImageIO's own lat-long, Y up: column = 0.5 - atan2(x, z) / 2 pi, which Blender's is of (y, x) after its rotation.
Vec3f to_picture(const Vec3f& d, float rotate_deg) {
    const float turn = rotate_deg * kPi / 180, c = std::cos(turn), s = std::sin(turn);
    return {s * d.x + c * d.y, d.z, c * d.x - s * d.y};
}

class Blur {
public:
    Blur(const Options& options, const std::string& texture)
        : m_rotate_deg(options.rotate_deg),
          m_frame(read_frame(options.frame, {{Role::position, Role::normal, Role::material_id}, {}, {}, false, 1, {}, {}})),
          m_position(m_frame.layer(Role::position)),
          m_normal(m_frame.layer(Role::normal)),
          m_eye(m_frame.camera.value().centre),
          m_textures(OIIO::TextureSystem::create(false)),
          m_handle(m_textures->get_texture_handle(OIIO::ustring(texture))) {
        for (const std::string& radius : options.radii) {
            const size_t split = radius.find('=');
            m_radius[std::stoi(radius.substr(0, split))] = std::stof(radius.substr(split + 1));
        }
    }
    ~Blur() { OIIO::TextureSystem::destroy(m_textures); }
    Blur(const Blur&) = delete;
    Blur& operator=(const Blur&) = delete;

    const AovFrame& frame() const { return m_frame; }

    Image run() const {
        const Image& ids = m_frame.layer(Role::material_id);
        Image blurred(ids.width, ids.height, 3);
        for_each_tile(ids.width, ids.height, {}, "blur", [&](const Window& tile) {
            auto* thread = m_textures->get_perthread_info();
            for (int y = tile.y; y < tile.y + tile.height; ++y)
                for (int x = tile.x; x < tile.x + tile.width; ++x) {
                    const size_t pixel = static_cast<size_t>(y) * ids.width + x;
                    const auto radius = m_radius.find(static_cast<int>(*ids.at(pixel)));
                    if (radius != m_radius.end()) look_up(thread, pixel, radius->second, blurred.at(pixel));
                }
        });
        return blurred;
    }

private:
    void look_up(OIIO::TextureSystem::Perthread* thread, size_t pixel, float radius, float* rgb) const {
        const auto vector = [&](Role role) {
            const float* v = m_frame.layer(role).at(pixel);
            return Vec3f(v[0], v[1], v[2]);
        };
        const Vec3f n = vector(Role::normal).normalized(), wo = (m_frame.camera->centre - vector(Role::position)).normalized();
        const Vec3f d = to_picture(n * (2 * n.dot(wo)) - wo, m_rotate_deg);
        const Frame disc = Frame::around(d);
        OIIO::TextureOpt options;
        m_textures->environment(m_handle, thread, options, d, disc.t * radius, disc.b * radius, 3, rgb);
    }

    float m_rotate_deg;
    AovFrame m_frame;
    const Image &m_position, &m_normal;
    Vec3f m_eye;
    std::map<int, float> m_radius;
    OIIO::TextureSystem* m_textures;
    OIIO::TextureSystem::TextureHandle* m_handle;
};

void run(const Options& options) {
    auto start = std::chrono::steady_clock::now();
    const std::string texture = make_texture(options);
    const double texture_s = seconds_since(start);
    const Blur blur(options, texture);
    double lookups_s = 1e9;
    Image blurred;
    for (int repeat = 0; repeat < options.repeats; ++repeat) {
        start = std::chrono::steady_clock::now();
        blurred = blur.run();
        lookups_s = std::min(lookups_s, seconds_since(start));
    }
    write_exr(options.output, blur.frame(), {{{"R", "G", "B"}, &blurred}}, PixelType::float32);
    std::remove(texture.c_str());
    std::printf("{\"texture_s\": %.6f, \"lookups_s\": %.6f}\n", texture_s, lookups_s);
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("One blurred environment lookup a pixel by OpenImageIO");
    app.add_option("frame", options.frame, "EXR with normals, positions and material ids")->required();
    app.add_option("environment", options.environment, "lat-long picture")->required();
    app.add_option("--radius", options.radii, "ID=RADIANS of each material")->delimiter(',')->required();
    app.add_option("--rotate", options.rotate_deg, "degrees, as burnish's --env-rotate");
    app.add_option("--threads", options.threads, "0: all cores");
    app.add_option("--repeats", options.repeats, "the fastest counts");
    app.add_option("-o,--output", options.output, "EXR to write")->required();
    CLI11_PARSE(app, argc, argv);
    const ThreadLimit limit(options.threads);
    try {
        run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
