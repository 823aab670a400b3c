#include "core/scratch.h"

#include <burnish/base/error.h>
#include <burnish/output/preview.h>

#include <OpenImageIO/imagebuf.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace burnish;

namespace {

/// Settings that do not depend on this machine's $OCIO.
PreviewSettings plain() {
    unsetenv("OCIO");
    return {};
}

std::vector<unsigned char> read_png(const std::string& file, int& width, int& channels) {
    const OIIO::ImageBuf png(file);
    width = png.spec().width;
    channels = png.nchannels();
    EXPECT_EQ(png.spec().format, OIIO::TypeUInt8);
    std::vector<unsigned char> bytes(png.spec().image_pixels() * static_cast<size_t>(channels));
    png.get_pixels(png.roi(), OIIO::TypeUInt8, bytes.data());
    return bytes;
}

int srgb_byte(double x) {
    return static_cast<int>(std::lround(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055)));
}

}  // namespace

TEST(Preview, EncodesSrgbAndClamps) {
    const Scratch scratch;
    Image image(4, 1, 4, 1.0f);
    image.data = {0.18f, 0.001f, 1, 0.5f, -3, 20, 0.5f, 1, NAN, INFINITY, -INFINITY, 0, 0.02f, 0.3f, 0.7f, 1};
    write_preview(scratch.file("a.png"), image, plain());
    int width = 0, channels = 0;
    const auto bytes = read_png(scratch.file("a.png"), width, channels);
    ASSERT_EQ(channels, 3);
    const int expected[] = {srgb_byte(0.18), srgb_byte(0.001), 255,           0, 255, srgb_byte(0.5), 0, 255, 0,
                            srgb_byte(0.02), srgb_byte(0.3),   srgb_byte(0.7)};
    for (size_t i = 0; i < 12; ++i) EXPECT_NEAR(bytes[i], expected[i], 1) << i;
    EXPECT_EQ(scratch.file_count(), 1u) << "nothing else is left behind";
}

TEST(Preview, ExposesByStops) {
    const Scratch scratch;
    PreviewSettings settings = plain();
    settings.exposure_stops = -2;
    write_preview(scratch.file("a.png"), Image(1, 1, 3, 0.8f), settings);
    int width = 0, channels = 0;
    EXPECT_NEAR(read_png(scratch.file("a.png"), width, channels)[0], srgb_byte(0.2), 1);
}

TEST(Preview, UsesTheViewOfTheConfig) {
    const Scratch scratch;
    std::ofstream(scratch.file("config.ocio")) << R"(ocio_profile_version: 2
roles: {default: base, scene_linear: base}
file_rules: [!<Rule> {name: Default, colorspace: default}]
displays: {Monitor: [!<View> {name: Half, colorspace: half}]}
colorspaces:
  - !<ColorSpace> {name: base}
  - !<ColorSpace> {name: half, to_scene_reference: !<MatrixTransform> {matrix: [2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,0,1]}}
)";
    PreviewSettings settings = plain();
    settings.config = ColorConfig::load(scratch.file("config.ocio"));
    write_preview(scratch.file("a.png"), Image(1, 1, 3, 0.8f), settings);
    int width = 0, channels = 0;
    EXPECT_NEAR(read_png(scratch.file("a.png"), width, channels)[0], 102, 1);
    settings.view = "Quarter";
    EXPECT_THROW(write_preview(scratch.file("b.png"), Image(1, 1, 3), settings), Error);
}

TEST(Preview, LeavesNothingWhenItFails) {
    const Scratch scratch;
    EXPECT_THROW(write_preview(scratch.file("a.exr"), Image(1, 1, 3), plain()), Error);
    EXPECT_THROW(write_preview(scratch.file("a.png"), Image(1, 1, 1), plain()), Error);
    EXPECT_THROW(write_before_after(scratch.file("a.png"), Image(1, 1, 3), Image(1, 2, 3), plain()), Error);
    EXPECT_EQ(scratch.file_count(), 0u);
    EXPECT_THROW(write_preview("/proc/absent/a.png", Image(1, 1, 3), plain()), Error);
}

TEST(Preview, PutsBeforeAndAfterSideBySide) {
    const Scratch scratch;
    write_before_after(scratch.file("a.png"), Image(3, 2, 3, 0.0f), Image(4, 2, 3, 1.0f), plain());
    int width = 0, channels = 0;
    const auto bytes = read_png(scratch.file("a.png"), width, channels);
    ASSERT_EQ(width, 3 + 2 + 4);
    const int expected[] = {0, 0, 0, 153, 153, 255, 255, 255, 255};
    for (int x = 0; x < width; ++x) EXPECT_NEAR(bytes[static_cast<size_t>(3 * (width + x))], expected[x], 1) << x;
}
