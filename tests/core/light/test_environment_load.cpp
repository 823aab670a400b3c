// Layouts, scrubbing, settings and untrusted files.
#include "core/data.h"
#include "core/scratch.h"
#include "light_pictures.h"

#include <burnish/base/error.h>
#include <burnish/light/environment.h>
#include <burnish/light/environment_layouts.h>
#include <burnish/light/envmap.h>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>

using namespace burnish_test;

namespace {

constexpr int kSize = 16;

/// Radiance that tells directions apart.
Color3f compass(const Vec3f& d) { return {1.5f + d.x, 1.5f + d.y, 1.5f + d.z}; }

/// Faces laid out as rows of face indices, -1 where there is none; `turned_face` stands on its head.
Image arranged(const std::array<Image, 6>& faces, const std::vector<std::vector<int>>& cells, int turned_face = -1) {
    Image image(static_cast<int>(cells[0].size()) * kSize, static_cast<int>(cells.size()) * kSize, 3);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const int face = cells[y / kSize][x / kSize];
            if (face < 0) continue;
            const int fx = x % kSize, fy = y % kSize;
            const float* from = face == turned_face ? faces[face].at(kSize - 1 - fx, kSize - 1 - fy) : faces[face].at(fx, fy);
            std::copy_n(from, 3, image.at(x, y));
        }
    }
    return image;
}

void expect_compass(const Environment& light, const std::string& what) {
    Directions random;
    for (int i = 0; i < 3000; ++i) {
        const Vec3f d = random.next();
        ASSERT_LT((light.radiance(d * light.world_to_light()) - compass(d)).length(), 0.02f) << what << " " << d;
        ASSERT_LT((light.pyramid().lookup(d * light.world_to_light(), 0) - compass(d)).length(), 0.02f) << what << " " << d;
    }
}

void write(const std::string& file, const Image& image, const std::string& format = "") {
    OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeFloat);
    if (!format.empty()) spec.attribute("textureformat", format);
    const auto out = OIIO::ImageOutput::create(file);
    ASSERT_TRUE(out && out->open(file, spec) && out->write_image(OIIO::TypeFloat, image.data.data()) && out->close()) << file;
}

ErrorCode failure(const std::string& file, std::string* message = nullptr) {
    try {
        Environment::load(file, {});
    } catch (const Error& error) {
        if (message) *message = error.what();
        return error.code();
    }
    ADD_FAILURE() << file << " was accepted";
    return ErrorCode::cancelled;
}

}  // namespace

TEST(EnvironmentLayouts, AllCubeLayoutsShowTheSameLight) {
    const auto faces = painted_faces(kSize, compass);
    const auto check = [&](const Image& image, EnvironmentLayout layout) {
        ASSERT_EQ(layout_of(image.width, image.height), layout);
        expect_compass(Environment::from_image(image, {}, "cube"), std::string(layout_name(layout)));
    };
    check(arranged(faces, {{0}, {1}, {2}, {3}, {4}, {5}}), EnvironmentLayout::vertical_strip);
    check(arranged(faces, {{0, 1, 2, 3, 4, 5}}), EnvironmentLayout::horizontal_strip);
    check(arranged(faces, {{0, 2, 4}, {1, 3, 5}}), EnvironmentLayout::two_rows);
    check(arranged(faces, {{-1, 2, -1, -1}, {1, 5, 0, 4}, {-1, 3, -1, -1}}), EnvironmentLayout::horizontal_cross);
    check(arranged(faces, {{-1, 2, -1}, {1, 5, 0}, {-1, 3, -1}, {-1, 4, -1}}, 4), EnvironmentLayout::vertical_cross);
}

TEST(EnvironmentLayouts, CrossesAreContinuousAcrossTheirInnerEdges) {
    const auto faces = painted_faces(kSize, compass);
    const Image cross = horizontal_cross(faces);
    const auto step = [&](int x0, int y0, int x1, int y1) {
        return (Vec3f(cross.at(x0, y0)[0], cross.at(x0, y0)[1], cross.at(x0, y0)[2]) -
                Vec3f(cross.at(x1, y1)[0], cross.at(x1, y1)[1], cross.at(x1, y1)[2]))
            .length();
    };
    for (int i = 0; i < kSize; ++i) {
        for (const int edge : {1, 2, 3}) EXPECT_LT(step(edge * kSize - 1, kSize + i, edge * kSize, kSize + i), 0.13f);
        for (const int edge : {1, 2}) EXPECT_LT(step(kSize + i, edge * kSize - 1, kSize + i, edge * kSize), 0.13f);
    }
}

TEST(EnvironmentLayouts, FacesNamedInAZUpWorldAreTurnedToYUp) {
    // The face named pz shows the world's +Z with -Y on top, as OpenEXR's +Y face does after (x, y, z) -> (x, z, -y).
    const auto light_faces = painted_faces(kSize, [](const Vec3f& d) { return compass({d.x, -d.z, d.y}); });
    const auto& [px, nx, py, ny, pz, nz] = light_faces;
    const Image strip = arranged({px, nx, nz, pz, py, ny}, {{0}, {1}, {2}, {3}, {4}, {5}});
    EnvironmentSettings settings;
    settings.up = UpAxis::z;
    expect_compass(Environment::from_image(strip, settings, "strip"), "Z-up names");
    settings.convention = EnvironmentConvention::openexr;
    expect_compass(Environment::from_image(arranged(light_faces, {{0}, {1}, {2}, {3}, {4}, {5}}), settings, "strip"),
                   "Y-up names, Z-up world");
}

TEST(EnvironmentLoad, ReadsSixFilesInAnySpelling) {
    const Scratch folder;
    const auto faces = painted_faces(kSize, compass);
    const char* names[3][6] = {{"px", "nx", "py", "ny", "pz", "nz"},
                               {"posx", "negx", "posy", "negy", "posz", "negz"},
                               {"+X", "-X", "+Y", "-Y", "+Z", "-Z"}};
    for (int spelling = 0; spelling < 3; ++spelling) {
        const std::string stem = folder.file("sky" + std::to_string(spelling) + "_");
        for (int face = 0; face < 6; ++face) write(stem + names[spelling][face] + ".exr", faces[face]);
        expect_compass(Environment::load(stem + "{face}.exr", {}), names[spelling][0]);
        expect_compass(Environment::load(stem + "%s.exr", {}), names[spelling][0]);
    }
    std::filesystem::remove(folder.file("sky0_ny.exr"));
    std::string message;
    EXPECT_EQ(failure(folder.file("sky0_{face}.exr"), &message), ErrorCode::read_failed);
    EXPECT_NE(message.find("sky0_ny.exr"), std::string::npos) << message;
    write(folder.file("sky0_ny.exr"), Image(8, 8, 3));
    EXPECT_EQ(failure(folder.file("sky0_{face}.exr"), &message), ErrorCode::read_failed);
    EXPECT_NE(message.find("16 x 16"), std::string::npos) << message;
}

TEST(EnvironmentLoad, ReadsACubeOfAnySizeAndAnOddLatLong) {
    for (const int size : {1, 5, 12}) {
        Image strip(size, 6 * size, 3, 0.5f);
        const Environment light = Environment::from_image(strip, {}, "strip");
        EXPECT_NEAR(light.pyramid().lookup({0, 1, 0}, 0).x, 0.5f, 1e-6f) << size;
        EXPECT_NEAR(light.radiance({0, 1, 0}).x, 0.5f, 1e-6f) << size;
    }
    for (const auto& [width, height] : {std::array{1, 1}, {7, 3}, {2, 9}, {33, 17}}) {
        const Environment light = Environment::from_image(Image(width, height, 1, 0.25f), {}, "odd");
        EXPECT_NEAR(light.pyramid().lookup({0, -1, 0}, 1).y, 0.25f, 1e-6f) << width;
        EXPECT_NEAR(light.radiance({0, 1, 0}).y, 0.25f, 1e-6f) << width;
        EXPECT_EQ(light.warnings().size(), 1u) << "not 2 : 1";
    }
}

TEST(EnvironmentLoad, ScrubsAndCountsWhatIsNotLight) {
    Image image(8, 4, 3, 0.5f);
    image.at(1, 1)[0] = std::nanf("");
    image.at(2, 1)[0] = INFINITY;
    image.at(3, 1)[0] = -1.0f;
    image.at(4, 1)[0] = -INFINITY;
    image.at(5, 1)[0] = 40.0f;
    const Environment light = Environment::from_image(image, {}, "dirty.exr");
    ASSERT_EQ(light.warnings().size(), 3u);
    EXPECT_NE(light.warnings()[0].find("dirty.exr: 1 NaN values"), std::string::npos);
    EXPECT_NE(light.warnings()[1].find("1 infinite values"), std::string::npos);
    EXPECT_NE(light.warnings()[2].find("2 negative values"), std::string::npos);
    Directions random;
    float largest = 0;
    for (int i = 0; i < 20000; ++i) {
        const Color3f c = light.radiance(random.next());
        ASSERT_TRUE(is_finite(c) && c.x >= 0 && c.x <= 40.0f) << c;
        largest = std::max(largest, c.x);
    }
    EXPECT_GT(largest, 30.0f) << "an infinite value becomes the largest finite one";
}

TEST(EnvironmentLoad, RealFilesWithNanAndInfinityAreUsable) {
    const auto file = data_path("public/exr_spec/BrightRingsNanInf.exr");
    if (!file) GTEST_SKIP() << "needs public/exr_spec of the test data, see BURNISH_DATA";
    const Environment light = Environment::load(file->string(), {});
    EXPECT_GE(light.warnings().size(), 2u);
    Directions random;
    for (int i = 0; i < 5000; ++i) ASSERT_TRUE(is_finite(light.pyramid().lookup(random.next(), 8 * random.uniform())));
}

TEST(EnvironmentLoad, HonoursTheEnvmapAttribute) {
    const Scratch folder;
    const std::string cube = folder.file("cube.exr"), wrong = folder.file("wrong.exr"), latlong = folder.file("latlong.exr");
    write(cube, arranged(painted_faces(kSize, compass), {{0}, {1}, {2}, {3}, {4}, {5}}), "CubeFace Environment");
    expect_compass(Environment::load(cube, {}), "cube attribute");
    write(latlong, Image(12, 2, 3, 1.0f), "LatLong Environment");  // would be a horizontal strip by its shape
    EXPECT_NE(Environment::load(latlong, {}).notes()[0].find("lat-long"), std::string::npos);
    write(wrong, Image(64, 32, 3, 1.0f), "CubeFace Environment");
    std::string message;
    EXPECT_EQ(failure(wrong, &message), ErrorCode::read_failed);
    EXPECT_NE(message.find("envmap"), std::string::npos) << message;
}

TEST(EnvironmentLoad, GainIsScaleTimesTintAndRadianceIsWithout) {
    EnvironmentSettings settings;
    settings.scale = 2;
    settings.tint = {1, 0.5f, 0.25f};
    const Environment light = Environment::from_image(Image(8, 4, 3, 3.0f), settings, "grey");
    EXPECT_EQ(light.gain(), Color3f(2, 1, 0.5f));
    EXPECT_NEAR(light.radiance({1, 0, 0}).x, 3.0f, 1e-6f);
}

TEST(EnvironmentLoad, RefusesSettingsThatMakeNoSense) {
    const auto code = [](auto&& change) {
        EnvironmentSettings settings;
        change(settings);
        try {
            Environment::from_image(Image(8, 4, 3), settings, "sky");
        } catch (const Error& error) {
            return error.code() == ErrorCode::bad_argument;
        }
        return false;
    };
    EXPECT_TRUE(code([](EnvironmentSettings& s) { s.face_size = 100; }));
    EXPECT_TRUE(code([](EnvironmentSettings& s) { s.face_size = -1; }));
    EXPECT_TRUE(code([](EnvironmentSettings& s) { s.face_size = 1 << 20; }));
    EXPECT_TRUE(code([](EnvironmentSettings& s) { s.rotate_deg = NAN; }));
    EXPECT_TRUE(code([](EnvironmentSettings& s) { s.scale = INFINITY; }));
    EXPECT_THROW(Environment::from_image(Image(), {}, "sky"), Error);
}

TEST(EnvironmentLoad, AbsentEmptyAndForeignFilesAreRefusedByName) {
    const Scratch folder;
    std::ofstream(folder.file("empty.exr")).flush();
    std::ofstream(folder.file("text.exr")) << "this is no picture, whatever its name says\n";
    std::ofstream(folder.file("text.hdr")) << "this is no picture, whatever its name says\n";
    std::ofstream(folder.file("cut.hdr")) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 512 +X 1024\n";
    for (const std::string name : {"absent.exr", "empty.exr", "text.exr", "text.hdr", "cut.hdr"}) {
        std::string message;
        EXPECT_EQ(failure(folder.file(name), &message), ErrorCode::read_failed);
        EXPECT_NE(message.find(name), std::string::npos) << message;
    }
    EXPECT_EQ(failure(folder.path().string()), ErrorCode::read_failed) << "a folder";
}

TEST(EnvironmentLoad, DamagedFilesAreRefusedWithoutTakingMemory) {
    const auto bad = data_path("public/exr_bad");
    if (!bad) GTEST_SKIP() << "needs public/exr_bad of the test data, see BURNISH_DATA";
    int refused = 0;
    for (const auto& entry : std::filesystem::directory_iterator(*bad)) {
        try {
            Environment::load(entry.path().string(), {});
            EXPECT_EQ(entry.path().filename(), "scanline_with_deepscanline_type.exr") << "the only one that can be read";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::read_failed) << error.what();
            EXPECT_NE(std::string(error.what()).find(entry.path().filename().string()), std::string::npos);
            ++refused;
        }
    }
    EXPECT_GT(refused, 15);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    EXPECT_LT(usage.ru_maxrss, 2L << 20) << "kilobytes";
}

TEST(EnvironmentLoad, TruncatedPicturesAreRefused) {
    const Scratch folder;
    Image image(64, 32, 3);
    Directions random;
    for (float& value : image.data) value = random.uniform();
    for (const std::string name : {"sky.exr", "sky.hdr"}) {
        write(folder.file(name), image);
        Environment::load(folder.file(name), {});
        const auto size = std::filesystem::file_size(folder.file(name));
        for (const double part : {0.05, 0.3, 0.6, 0.9}) {
            std::filesystem::copy_file(folder.file(name), folder.file("cut_" + name),
                                       std::filesystem::copy_options::overwrite_existing);
            std::filesystem::resize_file(folder.file("cut_" + name), static_cast<uintmax_t>(static_cast<double>(size) * part));
            EXPECT_EQ(failure(folder.file("cut_" + name)), ErrorCode::read_failed) << part;
        }
    }
}

TEST(Envmap, LatLongAndCubeStripBringTheLightBack) {
    const auto faces = painted_faces(64, compass);
    Image strip(64, 384, 3);
    for (int face = 0; face < 6; ++face) std::copy(faces[face].data.begin(), faces[face].data.end(), strip.at(0, 64 * face));
    const Environment light = Environment::from_image(strip, {}, "strip");
    EXPECT_EQ(to_cube_strip(light, 64).data, strip.data);
    expect_compass(Environment::from_image(to_cube_strip(light, 32), {}, "half"), "half size");
    expect_compass(Environment::from_image(to_cube_strip(light, 48), {}, "odd"), "odd size");
    expect_compass(Environment::from_image(to_latlong(light, 256), {}, "lat-long"), "lat-long");
    const Image cross = level_image(light.pyramid(), 1);
    EXPECT_EQ(cross.width, 128);
    expect_compass(Environment::from_image(cross, {}, "cross"), "cross");
    EXPECT_THROW(to_latlong(light, 0), Error);
    EXPECT_THROW(to_cube_strip(light, 0), Error);
    EXPECT_THROW(level_image(light.pyramid(), 7), Error);
}

TEST(Envmap, SummaryOfARealSkyNamesItsSun) {
    const auto file = data_path("public/env/rooitou_park_1k.hdr");
    if (!file) GTEST_SKIP() << "needs public/env of the test data, see BURNISH_DATA";
    EnvironmentSettings whole;
    whole.suns = Suns::keep;
    const Environment light = Environment::load(file->string(), whole);
    const EnvironmentSummary summary = summarize(light);
    EXPECT_EQ(summary.face_size, 256);
    EXPECT_EQ(summary.suggested_face_size, 256);
    EXPECT_GT(summary.bright_share, 0.5f);
    EXPECT_LT(summary.bright_share, 0.9f);
    EXPECT_GT(summary.peak_luminance, 5000.0f);
    EXPECT_GT(luminance(light.radiance(summary.peak_direction)), 1000.0f);
    const EnvironmentSummary even = summarize(Environment::from_image(Image(64, 32, 3, 2.0f), {}, "grey"));
    EXPECT_NEAR(even.mean_luminance, 2.0f, 1e-5f);
    EXPECT_NEAR(even.bright_share, 1e-3f, 1e-6f);
}
