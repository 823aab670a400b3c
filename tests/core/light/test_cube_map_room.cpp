// Cube maps of the room that Cycles rendered: every texel looks where Cycles says it does, and the vase reflects the room under
// each proxy. PSNR is the display one, of docs/measured.md.
#include "core/data.h"

#include <burnish/input/exr_file.h>
#include <burnish/light/cube_map/cube_map_light.h>
#include <burnish/scene/load_scene.h>
#include <burnish/shading/local_shading.h>
#include <burnish/shading/material_shader.h>

#include <gtest/gtest.h>

#include <chrono>

using namespace burnish;

namespace {

const Vec3f kCentre(0.8f, 0.7f, 1.0187499f);

/// A colour or vector layer of one of the room's files.
Image layer(const std::filesystem::path& file, const std::string& name, const std::string& components) {
    const ExrFile exr(file.string(), "");
    const Window window = exr.data_window(0);
    Image image(window.width, window.height, static_cast<int>(components.size()));
    std::vector<ChannelRead> reads;
    for (size_t k = 0; k < components.size(); ++k)
        reads.push_back(
            {*exr.find_layer("ViewLayer." + name)->find(std::string(1, components[k])), &image, static_cast<int>(k)});
    exr.read(reads, window);
    return image;
}

Vec3f vector_at(const Image& image, size_t i) { return {image.at(i)[0], image.at(i)[1], image.at(i)[2]}; }

CubeMapSettings settings_of(const std::filesystem::path& room, const std::string& file, ProxyKind kind) {
    CubeMapSettings settings;
    settings.file = (room / file).string(), settings.centre = kCentre, settings.picture.up = UpAxis::z;
    settings.proxy.kind = kind;
    settings.proxy.planes = {{{0, 0, 0}, {0, 0, 1}}, {{0, 0, 3}, {0, 0, 1}}};
    settings.proxy.box = {{0, 0, 1.5f}, {3, 4, 1.5f}};
    return settings;
}

/// Shares of a file's texels whose own position the distances miss by half a percent, and whose colour the light does by two.
Vec2f misses(const DistanceMap& distances, const Environment& light, const std::filesystem::path& file) {
    const Image position = layer(file, "Position", "xyz"), color = layer(file, "Combined", "rgb");
    Vec2f missed(0, 0);
    for (size_t i = 0; i < position.pixel_count(); ++i) {
        const Vec3f to = vector_at(position, i) - kCentre, d = to.normalized(), own = vector_at(color, i);
        missed.x += std::fabs(distances.nearer(to * distances.world_to_map()) - 1) > 0.005f;
        missed.y += (Vec3f(light.radiance(d * light.world_to_light())) - own).length() > 0.02f * (own.length() + 0.02f);
    }
    return missed / static_cast<float>(position.pixel_count());
}

/// The vase's pixels, and those well inside the mirror image of the floor that the map's centre sees.
struct Vase {
    SurfaceBatch batch;
    std::vector<Color3f> glossy;
    std::vector<bool> floor;

    Vase(const std::filesystem::path& room, const Scene& scene) {
        const std::filesystem::path file = room / "room.exr";
        const Image position = layer(file, "Position", "xyz"), normal = layer(file, "Normal", "xyz");
        const Image material = layer(file, "IndexMA", "x"), direct = layer(file, "GlossDir", "rgb");
        const Image indirect = layer(file, "GlossInd", "rgb"), color = layer(file, "GlossCol", "rgb");
        const Tracer tracer(scene);
        const Vec3f eye(0.2f, -3.7f, 1.55f);
        for (size_t i = 0; i < position.pixel_count(); ++i) {
            const Vec3f p = vector_at(position, i), n = vector_at(normal, i), wo = (eye - p).normalized();
            if (*material.at(i) != 2 || std::fabs(n.length() - 1) > 0.01f || n.dot(wo) < 0.01f) continue;
            batch.pixel.push_back(static_cast<uint32_t>(i));
            batch.p.push_back(p), batch.n.push_back(n.normalized()), batch.wo.push_back(wo),
                batch.t.push_back(Frame::around(n).t);
            glossy.push_back(Color3f(vector_at(color, i)) * Color3f(vector_at(direct, i) + vector_at(indirect, i)));
            const Vec3f d = n * (2 * n.dot(wo)) - wo;
            const auto hit = tracer.closest(p + n * 1e-3f, d);
            const Vec3f to = hit ? hit->p + Vec3f(0, 0, 1e-3f) - kCentre : d;
            floor.push_back(hit && hit->p.z < 1e-3f && !tracer.occluded(kCentre, to, 0.999f));
        }
        keep_interior(position.width);
    }

    /// Only pixels whose whole 5 x 5 neighbourhood mirrors the floor stay.
    void keep_interior(int width) {
        std::vector<bool> all(static_cast<size_t>(width) * width, false), inside = floor;
        for (size_t i = 0; i < floor.size(); ++i) all[batch.pixel[i]] = floor[i];
        for (size_t i = 0; i < floor.size(); ++i)
            for (int k = 0; k < 25; ++k)
                inside[i] =
                    inside[i] && all[static_cast<size_t>(static_cast<int>(batch.pixel[i]) + (k / 5 - 2) * width + k % 5 - 2)];
        floor = inside;
    }

    double psnr(const std::vector<Color3f>& overlay, bool only_floor) const {
        const auto displayed = [](double x) {
            x = std::clamp(x, 0.0, 1.0);
            return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
        };
        double mean = 0, square = 0, count = 0;
        for (size_t i = 0; i < glossy.size(); ++i)
            if (floor[i] || !only_floor) mean += glossy[i].x + glossy[i].y + glossy[i].z, count += 3;
        for (size_t i = 0; i < glossy.size(); ++i)
            for (int k = 0; k < 3 && (floor[i] || !only_floor); ++k)
                square +=
                    std::pow(displayed(0.18 * count / mean * overlay[i][k]) - displayed(0.18 * count / mean * glossy[i][k]), 2);
        return -10 * std::log10(square / count);
    }
};

}  // namespace

TEST(CubeMapRoom, TexelsLookWhereCyclesSays) {
    const auto room = data_path("cycles/room");
    if (!room) GTEST_SKIP() << "no test data";
    for (const std::string file : {"cube_%s.exr", "equirect.exr"}) {
        const CubeMapSettings settings = settings_of(*room, file, ProxyKind::depth);
        const DistanceMap distances = DistanceMap::load(settings);
        const Environment light = Environment::load(settings.file, settings.picture);
        const std::string own = file == "equirect.exr" ? file : "cube_ny.exr";
        const Vec2f missed = misses(distances, light, *room / own);
        EXPECT_LT(missed.x, 0.01f) << file;  // a lat-long is resampled, so surfaces' outlines move by a texel
        EXPECT_LT(missed.y, 0.01f) << file;
    }
}

TEST(CubeMapRoom, TheVaseReflectsTheRoom) {
    const auto room = data_path("cycles/room");
    if (!room) GTEST_SKIP() << "no test data";
    auto scene = std::make_shared<Scene>(load_scene((*room / "room_lightmapped.glb").string(), {.up = UpAxis::z}));
    std::erase_if(scene->objects, [](const Object& object) { return object.name == "vase"; });
    const Vase vase(*room, *scene);
    LobeParameters lobe;
    lobe.model = ModelId::ggx, lobe.mx = lobe.my = 0.05f, lobe.tint = {0.7f, 0.7f, 0.65f};
    const auto taps = std::make_shared<const MaterialTaps>(Material{"vase", Color3f(0, 0, 0), {lobe}}, EstimatorSettings());
    double all[5], floor[5];
    const char* names[] = {"infinite", "planes", "box", "depth", "mesh"};
    for (int kind = 0; kind < 5; ++kind) {
        const CubeMapSettings settings = settings_of(*room, "cube_%s.exr", static_cast<ProxyKind>(kind));
        const auto light = std::make_shared<const Light>(CubeMapLight(settings, {}, scene));
        const MaterialShader shader(taps, LightChain({{light, true}}));
        ShadedBatch out;
        shader.shade(vase.batch, out);
        const auto start = std::chrono::steady_clock::now();
        shader.shade(vase.batch, out);
        const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
        all[kind] = vase.psnr(out.overlay, false), floor[kind] = vase.psnr(out.overlay, true);
        std::printf("%-8s vase %.1f dB, floor in it %.1f dB, %.2f ms\n", names[kind], all[kind], floor[kind], spent.count());
    }
    EXPECT_GT(floor[1], floor[0] + 10);
    EXPECT_GT(all[1], all[0] + 2);
    EXPECT_GT(all[3], 31);
    EXPECT_GT(all[4], 31);
    EXPECT_GT(all[3], all[2] + 6);
}
