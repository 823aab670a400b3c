// Light of a room by its cube map and a proxy: against the room's own picture, its averages over cones, and its files.
#include "core/scratch.h"
#include "painted_room.h"

#include <burnish/base/error.h>
#include <burnish/light/environment_layouts.h>
#include <burnish/light/light_chain.h>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <fstream>

using namespace burnish_test;

namespace {

const Vec3f kCentre(0.5f, 0.2f, -0.7f);
constexpr int kSize = 256;

EnvironmentSettings keep_suns() {
    EnvironmentSettings settings;
    settings.suns = Suns::keep;
    return settings;
}

CubeMapLight light_of(const PaintedRoom& room, Proxy proxy, int size = kSize) {
    return {Environment::from_picture(room.picture(kCentre, size), keep_suns(), "room"), std::nullopt, kCentre,
            std::move(proxy)};
}

Proxy impostor(const PaintedRoom& room) {
    return DepthImpostor(
        std::make_shared<DistanceMap>(room.distances(kCentre, kSize), EnvironmentSettings(), DistanceKind::ray), kCentre);
}

Incident look(const CubeMapLight& light, const LightRay& ray) {
    Incident found;
    light.lookup({&ray, 1}, {&found, 1});
    return found;
}

float relative(const Color3f& a, const Color3f& b) { return (a - b).length() / b.length(); }

/// Mean relative error of exact light from all over the room.
double exact_error(const PaintedRoom& room, const CubeMapLight& light) {
    Directions random;
    double sum = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3f p = room.inside(random, 0.1f), d = random.next();
        sum += relative(light.exact({p, d, d, 0}).radiance, room.seen(p, d));
    }
    return sum / 4000;
}

/// What the room shows in a Gaussian cone, by points of a golden spiral.
Color3f cone_average(const PaintedRoom& room, const LightRay& ray) {
    constexpr int kPoints = 2000;
    const Frame frame = Frame::around(ray.d);
    Color3f sum(0, 0, 0);
    for (int i = 0; i < kPoints; ++i) {
        const float u = (static_cast<float>(i) + 0.5f) / kPoints, phi = 2.399963f * static_cast<float>(i);
        const float cosine = 1 + ray.sigma * ray.sigma * std::log(1 - u * (1 - std::exp(-2 / (ray.sigma * ray.sigma))));
        const float sine = std::sqrt(std::max(1 - cosine * cosine, 0.0f));
        sum += room.seen(ray.p, frame.to_world({sine * std::cos(phi), sine * std::sin(phi), cosine}));
    }
    return sum / kPoints;
}

struct ConeError {
    double mean = 0, worst = 0, unfiltered = 0;
};

ConeError cone_error(const PaintedRoom& room, const CubeMapLight& light, float sigma) {
    Directions random;
    ConeError error;
    constexpr int kRays = 400;
    for (int i = 0; i < kRays; ++i) {
        const Vec3f d = random.next();
        const LightRay ray{room.inside(random, 0.3f), d, d, sigma};
        const Color3f average = cone_average(room, ray);
        const double one = relative(look(light, ray).radiance, average);
        error.unfiltered += relative(room.seen(ray.p, d), average) / kRays;
        error.mean += one / kRays, error.worst = std::max(error.worst, one);
    }
    return error;
}

}  // namespace

TEST(CubeMapLight, ProxiesKeepThePictureWhereTheRoomIs) {
    const PaintedRoom room;
    EXPECT_GT(exact_error(room, light_of(room, InfiniteProxy())), 0.2);
    EXPECT_LT(exact_error(room, light_of(room, BoundingPlanes(room.planes(), kCentre))), 1e-3);
    EXPECT_LT(exact_error(room, light_of(room, BoundingPlanes(room.box(), kCentre))), 1e-3);
    EXPECT_LT(exact_error(room, light_of(room, ProxyMesh(room.scene(), kCentre))), 1e-3);
    EXPECT_LT(exact_error(room, light_of(room, impostor(room))), 1e-3);
}

TEST(CubeMapLight, ConesAreAveragedAsWideAsTheyAre) {
    const PaintedRoom room;
    const CubeMapLight boxed = light_of(room, BoundingPlanes(room.box(), kCentre)), deep = light_of(room, impostor(room));
    for (const float sigma : {0.02f, 0.05f, 0.1f, 0.2f, 0.4f}) {
        const ConeError box = cone_error(room, boxed, sigma), depth = cone_error(room, deep, sigma);
        std::printf("sigma %.2f: box mean %.4f worst %.3f, depth mean %.4f worst %.3f, unfiltered %.4f\n", sigma, box.mean,
                    box.worst, depth.mean, depth.worst, box.unfiltered);
        for (const ConeError& error : {box, depth}) {
            EXPECT_LT(error.mean, 0.3 * sigma);
            EXPECT_LT(error.mean, 0.35 * error.unfiltered);
        }
    }
}

// Neighbouring rays differ by less the closer they are, also where they meet another wall.
TEST(CubeMapLight, FilteredLightHasNoTears) {
    const PaintedRoom room;
    const CubeMapLight light = light_of(room, BoundingPlanes(room.box(), kCentre));
    const auto largest_step = [&](int steps) {
        float largest = 0;
        Color3f before;
        for (int i = 0; i <= steps; ++i) {
            const float phi = 2 * kPi * static_cast<float>(i) / static_cast<float>(steps), z = 0.5f * std::sin(3 * phi);
            const Vec3f d(std::sqrt(1 - z * z) * std::cos(phi), z, std::sqrt(1 - z * z) * std::sin(phi));
            const Color3f here = look(light, {{2, -0.7f, 3}, d, d, 0.15f}).radiance;
            if (i > 0) largest = std::max(largest, (here - before).length());
            before = here;
        }
        return largest;
    };
    EXPECT_LT(largest_step(32000), 0.2f * largest_step(4000));
}

TEST(CubeMapLight, BendBoundsTheSecondDerivative) {
    const PaintedRoom room;
    const CubeMapLight light = light_of(room, BoundingPlanes(room.box(), kCentre));
    Directions random;
    int broken = 0, badly = 0;
    constexpr int kRays = 2000;
    for (int i = 0; i < kRays; ++i) {
        const Vec3f d = random.next(), side = Frame::around(d).turned(6 * random.uniform()).t, p = room.inside(random, 0.4f);
        constexpr float kStep = 0.02f;
        const auto brightness = [&](float angle) {
            const Vec3f w = d * std::cos(angle) + side * std::sin(angle);
            return luminance(look(light, {p, w, w, 0.05f}).radiance);
        };
        const float bend = std::fabs(brightness(kStep) + brightness(-kStep) - 2 * brightness(0)) / (kStep * kStep);
        const float bound = look(light, {p, d, d, 0.05f}).bend;
        broken += bend > bound, badly += bend > 2 * bound;
    }
    std::printf("bend beyond its bound in %.1f %% of rays, beyond twice in %.1f %%\n", 100.0 * broken / kRays,
                100.0 * badly / kRays);
    EXPECT_LT(broken, kRays / 10);
    EXPECT_LT(badly, kRays / 33);
}

TEST(CubeMapLight, NearnessIsOneOverTheDistance) {
    const PaintedRoom room;
    EXPECT_NEAR(look(light_of(room, BoundingPlanes(room.box(), kCentre)), {{1, 0, 0}, {0, 1, 0}, {0, 1, 0}, 0}).nearness, 0.5f,
                1e-5f);
    EXPECT_EQ(look(light_of(room, InfiniteProxy()), {{1, 0, 0}, {0, 1, 0}, {0, 1, 0}, 0}).nearness, 0.0f);
}

// Draws come with the density that `exact` says, and nothing else is drawn: light gathered by draws and by uniform directions,
// weighted by the balance heuristic as the reference does, is all the light there is.
TEST(CubeMapLight, SamplesComeWithTheirDensity) {
    PaintedRoom room;
    room.block = standing_block();
    const CubeMapLight lights[] = {light_of(room, InfiniteProxy(), 32),
                                   light_of(room, BoundingPlanes(room.planes(), kCentre), 32),
                                   light_of(room, BoundingPlanes(std::vector{room.planes()[2]}, kCentre), 32),
                                   light_of(room, ProxyMesh(room.scene(), kCentre), 32), light_of(room, impostor(room), 32)};
    for (const CubeMapLight& light : lights)
        for (const Vec3f& p : {Vec3f(-1, 0.5f, 2), Vec3f(2, room.low.y + 0.03f, 1), Vec3f(1, room.low.y, 0)}) {
            Directions random;
            constexpr int kDraws = 40000;
            constexpr float kUniform = 1 / (4 * kPi);
            double both = 0, uniform = 0, drawn = 0;
            for (int i = 0; i < kDraws; ++i) {
                const LightDraw draw = light.sample(p, {random.uniform(), random.uniform()});
                if (draw.pdf > 0) {
                    const ExactLight found = light.exact({p, draw.d, draw.d, 0});
                    ASSERT_NEAR(found.pdf, draw.pdf, 2e-3f * draw.pdf);
                    both += luminance(found.radiance) / (found.pdf + kUniform), drawn += 1.0 / kDraws;
                }
                const Vec3f d = random.next();
                const ExactLight found = light.exact({p, d, d, 0});
                both += luminance(found.radiance) / (found.pdf + kUniform), uniform += luminance(found.radiance) / kUniform;
            }
            EXPECT_NEAR(both / uniform, 1, 0.015) << &light - lights << p;
            EXPECT_GT(drawn, 0.4) << &light - lights << p;
        }
}

TEST(CubeMapLight, SamePixelsSameBitsInAnyBatch) {
    const PaintedRoom room;
    const CubeMapLight light = light_of(room, impostor(room));
    Directions random;
    std::vector<LightRay> rays;
    for (int i = 0; i < 600; ++i) {
        const Vec3f d = random.next();
        rays.push_back({room.inside(random, 0.1f), d, d, 0.2f * random.uniform()});
    }
    std::vector<Incident> all(rays.size());
    light.lookup(rays, all);
    for (size_t i = 0; i < rays.size(); ++i) {
        const Incident one = look(light, rays[i]);
        ASSERT_EQ(one.radiance, all[i].radiance);
        ASSERT_EQ(one.bend, all[i].bend);
    }
}

namespace {

/// Writes faces as a strip, as bakes are: channels beyond RGB after it.
std::string write_strip(const std::string& file, const std::vector<const std::array<Image, 6>*>& layers,
                        const std::vector<std::string>& names) {
    OIIO::ImageSpec spec((*layers[0])[0].width, 6 * (*layers[0])[0].width, static_cast<int>(names.size()), OIIO::TypeFloat);
    spec.channelnames = names;
    std::vector<float> pixels;
    for (int face = 0; face < 6; ++face)
        for (size_t i = 0; i < (*layers[0])[face].pixel_count(); ++i)
            for (const auto* layer : layers)
                pixels.insert(pixels.end(), (*layer)[face].at(i), (*layer)[face].at(i) + (*layer)[face].channels);
    const auto out = OIIO::ImageOutput::create(file);
    EXPECT_TRUE(out && out->open(file, spec) && out->write_image(OIIO::TypeFloat, pixels.data()) && out->close());
    return file;
}

CubeMapSettings settings_of(const std::string& file, ProxyKind kind) {
    CubeMapSettings settings;
    settings.file = file, settings.centre = kCentre, settings.proxy.kind = kind;
    return settings;
}

ErrorCode refusal(const CubeMapSettings& settings, std::string& message) {
    try {
        CubeMapLight(settings, {});
    } catch (const Error& error) {
        message = error.what();
        return error.code();
    }
    ADD_FAILURE() << settings.file << " was accepted";
    return ErrorCode::cancelled;
}

}  // namespace

TEST(CubeMapLight, ReadsWhatBakesAreMadeOf) {
    const Scratch folder;
    const PaintedRoom room;
    const EnvironmentPicture color = room.picture(kCentre, 64), rays = room.distances(kCentre, 64),
                             planar = room.distances(kCentre, 64, DistanceKind::planar);
    const std::string bake = write_strip(folder.file("bake.exr"), {&*color.faces, &*rays.faces}, {"R", "G", "B", "Z"});
    EXPECT_LT(exact_error(room, CubeMapLight(settings_of(bake, ProxyKind::depth), {})), 0.01);
    const std::string layered =
        write_strip(folder.file("layered.exr"), {&*color.faces, &*planar.faces},
                    {"ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B", "ViewLayer.Depth.Z"});
    EXPECT_LT(exact_error(room, CubeMapLight(settings_of(layered, ProxyKind::depth), {})), 0.01);
    const std::string bare = write_strip(folder.file("bare.exr"), {&*color.faces}, {"R", "G", "B"});
    const std::string apart = write_strip(folder.file("apart.exr"), {&*rays.faces}, {"Y"});
    CubeMapSettings both = settings_of(bare, ProxyKind::depth);
    both.depth = apart;
    EXPECT_LT(exact_error(room, CubeMapLight(both, {})), 0.01);
    CubeMapSettings wrong = settings_of(layered, ProxyKind::depth);
    wrong.distances = DistanceKind::ray;
    EXPECT_GT(exact_error(room, CubeMapLight(wrong, {})), 0.05);
}

TEST(CubeMapLight, WindowsLetTheNextLightThrough) {
    const Scratch folder;
    const PaintedRoom room;
    std::array<Image, 6> color = *room.picture(kCentre, 64).faces, alpha = *room.distances(kCentre, 64).faces;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const bool window = face == 0 && x >= 16 && x < 48 && y >= 16 && y < 48;
                *alpha[face].at(x, y) = window ? 0.0f : 1.0f;
                if (window) std::fill_n(color[face].at(x, y), 3, 0.0f);
            }
    const std::string file = write_strip(folder.file("window.exr"), {&color, &alpha}, {"R", "G", "B", "A"});
    const CubeMapLight light(settings_of(file, ProxyKind::infinite), {});
    const auto cover = [&](const Vec3f& d, float sigma) { return look(light, {{0, 0, 0}, d, d, sigma}).cover; };
    EXPECT_NEAR(cover({1, 0, 0}, 0.02f), 0, 1e-4f);
    EXPECT_NEAR(cover({-1, 0, 0}, 0.02f), 1, 1e-5f);
    const Vec3f edge = Vec3f(1, 0.5f, 0).normalized();
    EXPECT_NEAR(cover(edge, 0.05f), 0.5f, 0.03f);
    EXPECT_LT(cover({1, 0, 0}, 0.5f), 0.9f);
    EXPECT_EQ(light.exact({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, 0}).cover, 0.0f);

    const auto sky = std::make_shared<Environment>(
        Environment::from_picture({.latlong = {}, .faces = constant_faces(16, {7, 7, 7})}, keep_suns(), "sky"));
    const LightChain chain({{std::make_shared<Light>(light), true}, {std::make_shared<Light>(EnvironmentLight(sky)), true}});
    const LightRay out{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, 0.02f};
    Incident found;
    chain.lookup({&out, 1}, {&found, 1});
    EXPECT_NEAR(found.radiance.y, 7, 1e-2f);
    EXPECT_NEAR(chain.exact(out).radiance.y, 7, 1e-4f);
}

TEST(CubeMapLight, SaysWhatIsWrongWithFiles) {
    const Scratch folder;
    const EnvironmentPicture color = PaintedRoom().picture(kCentre, 16);
    const std::string bare = write_strip(folder.file("bare.exr"), {&*color.faces}, {"R", "G", "B"});
    std::string message;
    EXPECT_EQ(refusal(settings_of(bare, ProxyKind::depth), message), ErrorCode::missing_channel);
    for (const char* part : {"bare.exr", "Depth.Z", "another proxy"})
        EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(refusal(settings_of(bare, ProxyKind::mesh), message), ErrorCode::bad_argument);
    EXPECT_EQ(refusal(settings_of(folder.file("absent.exr"), ProxyKind::depth), message), ErrorCode::read_failed);
    EXPECT_EQ(refusal(settings_of(folder.file("absent_%s.exr"), ProxyKind::depth), message), ErrorCode::read_failed);
    std::ofstream(folder.file("broken.exr")) << "no picture at all";
    EXPECT_EQ(refusal(settings_of(folder.file("broken.exr"), ProxyKind::depth), message), ErrorCode::read_failed);
    const std::string nothing = write_strip(folder.file("normals.exr"), {&*color.faces}, {"N.X", "N.Y", "N.Z"});
    EXPECT_EQ(refusal(settings_of(nothing, ProxyKind::infinite), message), ErrorCode::read_failed);
    CubeMapSettings nowhere = settings_of(bare, ProxyKind::infinite);
    nowhere.centre.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(refusal(nowhere, message), ErrorCode::bad_argument);
}
