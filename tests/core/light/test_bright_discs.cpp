// Suns found in pictures: where, how large, how strong; the energy is all there, and nothing else is taken.
#include "core/scenes.h"
#include "light_pictures.h"
#include "sun_pictures.h"

#include <burnish/base/parallel.h>
#include <burnish/light/environment.h>

#include <gtest/gtest.h>

using namespace burnish_test;

namespace {

constexpr double kDegree = M_PI / 180;

double angle_deg(const Vec3f& a, const Vec3f& b) { return 2 * std::asin(0.5 * (a - b.normalized()).length()) / kDegree; }

/// Radiance times solid angle per channel, by this test's own solid angles.
Imath::V3d latlong_energy(const Image& image) {
    Imath::V3d sum(0, 0, 0);
    for (int y = 0; y < image.height; ++y) {
        const double omega =
            2 * M_PI / image.width * (std::cos(M_PI * y / image.height) - std::cos(M_PI * (y + 1) / image.height));
        for (int x = 0; x < image.width; ++x)
            for (int k = 0; k < 3; ++k) sum[k] += omega * image.at(x, y)[k];
    }
    return sum;
}

Imath::V3d cube_energy(const std::array<Image, 6>& faces) {
    Imath::V3d sum(0, 0, 0);
    for (const Image& face : faces)
        for (int y = 0; y < face.height; ++y)
            for (int x = 0; x < face.width; ++x)
                for (int k = 0; k < 3; ++k) sum[k] += texel_solid_angle(x, y, face.width) * face.at(x, y)[k];
    return sum;
}

void expect_same_energy(const Imath::V3d& whole, Imath::V3d rest, const DiscCut& cut) {
    for (const BrightDisc& disc : cut.discs()) rest += Imath::V3d(Vec3f(disc.flux));
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(rest[k] / whole[k], 1, 1e-6) << k;
}

/// A painted sun against the disc found for it. The picture spreads it by its texels and by bilinear interpolation.
void expect_sun(const BrightDisc& disc, const PaintedSun& sun, double texel_deg) {
    EXPECT_LT(angle_deg(disc.direction, sun.direction), 0.1 * texel_deg);
    EXPECT_NEAR(disc.flux.y / (sun.radiance.y * sun.solid_angle()), 1, 0.03);
    EXPECT_NEAR(disc.flux.x / disc.flux.z, sun.radiance.x / sun.radiance.z, 1e-3);
    const double expected = std::sqrt(sun.radius_deg * sun.radius_deg + 4 * texel_deg * texel_deg * (1 / 12.0 + 1 / 6.0));
    EXPECT_NEAR(disc.radius() / kDegree / expected, 1, 0.6 * texel_deg) << "more or less, as the texels fall";
    EXPECT_NEAR(disc.along.dot(disc.across), 0, 1e-8);
    EXPECT_NEAR(disc.along.dot(disc.direction), 0, 1e-4);
    EXPECT_LT(disc.longest_radius() / disc.radius(), 1.1);
}

size_t discs_in(Image image) { return DiscCut(PictureCells(image)).discs().size(); }

}  // namespace

TEST(BrightDiscs, FindsTheSunOfASky) {
    const PaintedSun sun{{0.3f, 0.6f, -0.5f}};
    for (const int height : {512, 1024, 2048}) {
        Image image = sunny_latlong({sun}, height);
        const Image whole = image;
        DiscCut cut{PictureCells(image)};
        ASSERT_EQ(cut.discs().size(), 1u) << height;
        expect_sun(cut.discs()[0], sun, 180.0 / height);
        expect_same_energy(latlong_energy(whole), latlong_energy(image), cut);
        EXPECT_LT(*std::max_element(image.data.begin(), image.data.end()), 1.1f) << "the surround's level remains";
        EXPECT_NE(cut.notes().at(0).find("% of the light"), std::string::npos);
        cut.put_back();
        EXPECT_EQ(image.data, whole.data);
    }
}

TEST(BrightDiscs, FindsSunsAcrossTheSeamAndAtThePoles) {
    for (const Vec3f& d :
         {Vec3f(0, 0.2f, -1), Vec3f(0.001f, -0.3f, -1), Vec3f(0, 1, 0), Vec3f(0.004f, 1, 0.003f), Vec3f(0, -1, 0)}) {
        const PaintedSun sun{d};
        Image image = sunny_latlong({sun}, 1024);
        const Image whole = image;
        const DiscCut cut{PictureCells(image)};
        ASSERT_EQ(cut.discs().size(), 1u) << d;
        expect_sun(cut.discs()[0], sun, 180.0 / 1024);
        expect_same_energy(latlong_energy(whole), latlong_energy(image), cut);
    }
}

TEST(BrightDiscs, FindsSunsOnCubesAndAcrossTheirEdges) {
    for (const Vec3f& d : {Vec3f(0.2f, 0.1f, 1), Vec3f(1, 1, 0.1f), Vec3f(1, 1, 1), Vec3f(-0.3f, 1, -1)}) {
        const PaintedSun sun{d, 0.35f};
        std::array<Image, 6> faces = sunny_cube({sun}, 512);
        const std::array<Image, 6> whole = faces;
        DiscCut cut{PictureCells(faces)};
        ASSERT_EQ(cut.discs().size(), 1u) << d;
        EXPECT_LT(angle_deg(cut.discs()[0].direction, d), 0.03);
        EXPECT_NEAR(cut.discs()[0].flux.y / (sun.radiance.y * sun.solid_angle()), 1, 0.02);
        expect_same_energy(cube_energy(whole), cube_energy(faces), cut);
        cut.put_back();
        for (int face = 0; face < 6; ++face) EXPECT_EQ(faces[face].data, whole[face].data);
    }
}

TEST(BrightDiscs, FindsTwoSunsLargestFirst) {
    const PaintedSun small{{1, 0.5f, 0.2f}, 0.3f, {20000, 20000, 20000}}, large{{-1, 0.3f, 0.1f}, 0.5f, {20000, 20000, 20000}};
    Image image = sunny_latlong({small, large}, 1024);
    const DiscCut cut{PictureCells(image)};
    ASSERT_EQ(cut.discs().size(), 2u);
    expect_sun(cut.discs()[0], large, 180.0 / 1024);
    expect_sun(cut.discs()[1], small, 180.0 / 1024);
}

TEST(BrightDiscs, KeepsToTheEightLargest) {
    std::vector<PaintedSun> suns;
    for (int i = 0; i < 12; ++i)
        suns.push_back({{std::cos(0.5f * i), 0.3f, std::sin(0.5f * i)}, 0.3f, Color3f(10000.0f + 1000.0f * ((i * 5) % 12))});
    Image image = sunny_latlong(suns, 1024);
    const Image whole = image;
    const DiscCut cut{PictureCells(image)};
    ASSERT_EQ(cut.discs().size(), 8u);
    for (int i = 0; i < 8; ++i) EXPECT_NEAR(cut.discs()[i].flux.x / (suns[0].solid_angle() * (21000 - 1000 * i)), 1, 0.03) << i;
    expect_same_energy(latlong_energy(whole), latlong_energy(image), cut);
}

TEST(BrightDiscs, MeasuresAnElongatedLamp) {
    Image image(1024, 512, 3, 0.2f);
    for (int x = 500; x < 504; ++x)
        for (int k = 0; k < 3; ++k) image.at(x, 255)[k] = 5000;
    const DiscCut cut{PictureCells(image)};
    ASSERT_EQ(cut.discs().size(), 1u);
    const double texel = M_PI / 512;
    EXPECT_NEAR(cut.discs()[0].longest_radius(), 2 * texel * std::sqrt(15 / 12.0 + 1 / 6.0), 1e-2 * texel);
    EXPECT_NEAR(cut.discs()[0].across.length(), 2 * texel * std::sqrt(1 / 6.0), 1e-2 * texel);
    EXPECT_LT(std::fabs(cut.discs()[0].along.y), 1e-3 * texel);
}

TEST(BrightDiscs, LeavesEverythingElseInThePicture) {
    EXPECT_EQ(discs_in(scenes::constant_light(1, 512)), 0u);
    EXPECT_EQ(discs_in(Image(1024, 512, 3)), 0u) << "black";
    EXPECT_EQ(discs_in(Image(1, 1, 3, 2.0f)), 0u);
    EXPECT_EQ(discs_in(scenes::stress_light(1000, 1024)), 0u);
    for (const int height : {256, 512})
        for (uint32_t seed = 1000; seed < 1006; ++seed)
            EXPECT_EQ(discs_in(scenes::stress_light(seed, height)), 0u) << "stress light " << seed << " of " << height;
    for (const float exponent :
         {1.0f, 12.0f}) {  // the second noise is spiky: a hundredth of its texels holds half of the light
        Directions random(3);
        Image noise(1024, 512, 3);
        for (float& value : noise.data) value = std::pow(random.uniform(), exponent) * 1000;
        EXPECT_EQ(discs_in(noise), 0u) << exponent;
    }
}

TEST(BrightDiscs, LeavesLampsOfTwoDegreesTubesAndCoarsePictures) {
    for (const float radius : {1.0f, 1.25f, 1.8f, 3.0f, 6.0f}) {
        EXPECT_EQ(discs_in(sunny_latlong({{{0.3f, 0.4f, 0.5f}, radius, {3000, 3000, 3000}}}, 512)), 0u) << radius;
        EXPECT_EQ(discs_in(sunny_latlong({{{0.3f, 0.4f, 0.5f}, radius, {3000, 3000, 3000}}}, 1024)), 0u) << radius;
    }
    Image tube(1024, 512, 3, 0.1f);
    for (int x = 500; x < 530; ++x)
        for (int k = 0; k < 3; ++k) tube.at(x, 200)[k] = tube.at(x, 201)[k] = 4000;
    EXPECT_EQ(discs_in(tube), 0u);
    EXPECT_EQ(discs_in(sunny_latlong({{{0.3f, 0.4f, 0.5f}, 2.0f, {60000, 60000, 60000}}}, 32)), 0u)
        << "a texel of 5.6 degrees is no sun";
}

TEST(BrightDiscs, AreTheSameForAnyThreadCount) {
    Image a = sunny_latlong({{{0.3f, 0.6f, -0.5f}}, {{-0.3f, 0.2f, 0.5f}}}, 512), b = a;
    const auto bits = [](Image& image) {
        std::vector<float> values;
        const DiscCut cut{PictureCells(image)};
        for (const BrightDisc& disc : cut.discs())
            values.insert(values.end(), {disc.direction.x, disc.direction.y, disc.along.x, disc.across.z, disc.flux.x});
        return values;
    };
    const std::vector<float> many = bits(a);
    const ThreadLimit one(1);
    EXPECT_EQ(bits(b), many);
    EXPECT_EQ(a.data, b.data);
}

TEST(Environment, KeepsSunsApartFromThePyramidAlone) {
    const PaintedSun sun{{0.3f, 0.6f, -0.5f}};
    const Image image = sunny_latlong({sun}, 512);
    EnvironmentSettings keep;
    keep.suns = Suns::keep;
    const Environment kept = Environment::from_image(image, keep, "kept"), taken = Environment::from_image(image, {}, "taken");
    EXPECT_TRUE(kept.discs().empty());
    ASSERT_EQ(taken.discs().size(), 1u);
    EXPECT_NE(taken.notes().back().find("taken out of the map"), std::string::npos);
    EXPECT_NEAR((level_energy(taken.pyramid().stack(), 0) + taken.discs()[0].flux.y) / level_energy(kept.pyramid().stack(), 0),
                1, 1e-3);
    EXPECT_LT(level_energy(taken.pyramid().stack(), 0), 0.6 * level_energy(kept.pyramid().stack(), 0));
    const Vec3f d = sun.direction.normalized();
    EXPECT_EQ(taken.radiance(d), kept.radiance(d)) << "the reference sees the whole picture";
    EXPECT_EQ(taken.pdf(d), kept.pdf(d));
    EXPECT_GT(taken.radiance(d).x, 10000.0f);
    EXPECT_LT(taken.pyramid().lookup(d, 0).x, 1.2f);
}
