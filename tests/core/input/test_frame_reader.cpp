// Large frames: judged by strips of rows, read by bands; what is found is what the whole frame shows.
#include "core/input/synthetic_exr.h"
#include "core/scenes.h"
#include "core/scratch.h"

#include <burnish/input/frame_reader.h>

#include <gtest/gtest.h>

#include <limits>

using namespace burnish;

namespace {

constexpr size_t kUnlimited = std::numeric_limits<size_t>::max();

/// A sphere of `size` pixels with its left upper corner at (x, y) of an empty frame of 2048 x 1536, too large to be judged whole.
std::string write_large(const Scratch& scratch, int size, int x, int y, const char* compression) {
    const AovFrame sphere = scenes::sphere_frame(size);
    Image p(2048, 1536, 3), n(2048, 1536, 3);
    for (int row = 0; row < size; ++row) {
        std::copy_n(sphere.layer(Role::position).at(0, row), 3 * size, p.at(x, y + row));
        std::copy_n(sphere.layer(Role::normal).at(0, row), 3 * size, n.at(x, y + row));
    }
    for (float& value : n.data) value = 0.5f * value + 0.5f;
    SyntheticPart part;
    part.layers = {{{"R", "G", "B"}, Image(2048, 1536, 3, 0.5f)}, {{"P.X", "P.Y", "P.Z"}, p}, {{"N.X", "N.Y", "N.Z"}, n}};
    part.compression = compression;
    return write_synthetic(scratch.file("large.exr"), {part});
}

void expect_bands_of_the_whole(const std::string& file, size_t band_pixels, int bands) {
    const AovFrame whole = read_frame(file, {});
    FrameReader reader(file, {}, band_pixels);
    ASSERT_EQ(reader.band_count(), bands);
    int row = 0;
    for (int i = 0; i < bands; ++i) {
        const AovFrame band = reader.read_band();
        EXPECT_EQ(band.data_window.y, row);
        for (const auto& [role, image] : band.layers) {
            const Image& all = whole.layer(role);
            ASSERT_TRUE(std::equal(image.data.begin(), image.data.end(), all.at(0, row))) << role_info(role).name;
        }
        EXPECT_EQ(band.layers.size(), whole.layers.size());
        EXPECT_EQ(band.notes, whole.notes);
        row += band.data_window.height;
    }
    EXPECT_EQ(row, whole.data_window.height);
}

}  // namespace

TEST(RowStrips, HoldAllRowsOfSmallFramesAndEvenlySpreadBlocksOfLargeOnes) {
    const Window small{0, 0, 100, 100}, large{-5, 7, 1000, 1003};
    EXPECT_TRUE(RowStrips::spread(small, 16, 10000).is_whole());
    const RowStrips strips = RowStrips::spread(large, 16, 160000);
    EXPECT_EQ(strips.rows, 160);
    for (int y = 0; y < strips.rows; ++y) {
        EXPECT_EQ(strips.row(y) % 16, y % 16) << "strips are blocks";
        EXPECT_LT(strips.row(y), large.height);
        EXPECT_EQ(strips.has_neighbours(y), y % 16 != 0 && y % 16 != 15);
    }
    EXPECT_LT(strips.row(0), 100);
    EXPECT_GT(strips.row(159), large.height - 120);
}

TEST(FrameReader, FindsByStripsWhatTheWholeFrameShows) {
    const Scratch scratch;
    const std::string file = write_large(scratch, 1500, 300, 20, "zip");
    const AovFrame frame = FrameReader(file, {}, kUnlimited).frame();
    ASSERT_TRUE(frame.camera);
    EXPECT_EQ(frame.camera->source, "recovered from position");
    EXPECT_LT((frame.camera->centre - Vec3f(0, 0, 6)).length(), 1e-3f);
}

TEST(FrameReader, FindsWhatStripsMiss) {
    const Scratch scratch;
    const AovFrame frame = FrameReader(write_large(scratch, 60, 900, 770, "zip"), {}, kUnlimited).frame();
    ASSERT_TRUE(frame.camera);
    EXPECT_LT((frame.camera->centre - Vec3f(0, 0, 6)).length(), 0.05f);
}

TEST(FrameReader, BandsAreThePixelsOfTheWholeFrame) {
    const Scratch scratch;
    expect_bands_of_the_whole(write_large(scratch, 1500, 300, 20, "zip"), 2048 * 700, 3);
    expect_bands_of_the_whole(write_large(scratch, 1500, 300, 20, "dwab"), 2048 * 300, 6);
}
