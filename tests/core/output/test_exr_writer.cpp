// The writer: what goes in comes back out, and a failed write leaves nothing behind.
#include <burnish/base/error.h>
#include <burnish/input/metadata_spec.h>
#include <burnish/output/exr_writer.h>

#include <core/scratch.h>

#include <OpenImageIO/imagebuf.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <limits>
#include <sstream>
#include <thread>

#include <sys/resource.h>

namespace burnish {
namespace {

/// A frame of 5x4 pixels with overscan, in a 10x8 display window.
AovFrame overscan_frame() {
    AovFrame frame;
    frame.file = "shots/beauty.0001.exr";
    frame.data_window = {-2, -1, 5, 4};
    frame.display_window = {0, 0, 10, 8};
    return frame;
}

Image ramp(const Window& window, int channels, float scale = 1.0f) {
    Image image(window.width, window.height, channels);
    for (size_t i = 0; i < image.data.size(); ++i) image.data[i] = scale * (static_cast<float>(i) + 0.125f);
    return image;
}

std::string bytes_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    std::stringstream bytes;
    bytes << stream.rdbuf();
    return bytes.str();
}

ErrorCode code_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.code();
    }
    ADD_FAILURE() << "nothing was thrown";
    return ErrorCode::cancelled;
}

/// Files may not grow beyond `bytes` while this lives: a disk that fills up.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) {
        m_handler = std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit limited{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limited);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_handler);
    }

private:
    rlimit m_before{};
    void (*m_handler)(int) = nullptr;
};

TEST(ExrWriter, KeepsFloatPixelsAndBothWindowsExactly) {
    const Scratch scratch;
    const AovFrame frame = overscan_frame();
    const Image beauty = ramp(frame.data_window, 4), overlay = ramp(frame.data_window, 3, 1e30f);
    const std::string file = scratch.file("out.exr");
    write_exr(file, frame,
              {{{"R", "G", "B", "A"}, &beauty}, {{"burnish_spec.R", "burnish_spec.G", "burnish_spec.B"}, &overlay}},
              PixelType::float32);

    OIIO::ImageBuf read(file);
    ASSERT_TRUE(read.read(0, 0, true, OIIO::TypeFloat)) << read.geterror();
    EXPECT_EQ(read.roi(), OIIO::ROI(-2, 3, -1, 3, 0, 1, 0, 7));
    EXPECT_EQ(read.roi_full(), OIIO::ROI(0, 10, 0, 8, 0, 1, 0, 7));
    EXPECT_EQ(read.spec().get_string_attribute("compression"), "zip");
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x)
            for (int c = 0; c < 7; ++c) {
                const std::string name = read.spec().channelnames[c];
                const int own = static_cast<int>(std::string("RGBA").find(name.back()));
                const Image& source = name.size() == 1 ? beauty : overlay;
                EXPECT_EQ(read.getchannel(x - 2, y - 1, 0, c), source.at(x, y)[own]) << name;
            }
    EXPECT_EQ(scratch.file_count(), 1u);
}

TEST(ExrWriter, ClampsHalfToItsLargestValue) {
    const Scratch scratch;
    AovFrame frame;
    frame.data_window = frame.display_window = {0, 0, 4, 1};
    Image image(4, 1, 1);
    image.data = {1e9f, -std::numeric_limits<float>::infinity(), 65519.0f, 0.5f};
    write_exr(scratch.file("half.exr"), frame, {{{"Y"}, &image}}, PixelType::half);
    const OIIO::ImageBuf read(scratch.file("half.exr"));
    EXPECT_EQ(read.spec().format, OIIO::TypeHalf);
    EXPECT_EQ(read.getchannel(0, 0, 0, 0), 65504.0f);
    EXPECT_EQ(read.getchannel(1, 0, 0, 0), -65504.0f);
    EXPECT_EQ(read.getchannel(2, 0, 0, 0), 65504.0f);
    EXPECT_EQ(read.getchannel(3, 0, 0, 0), 0.5f);
}

AovFrame frame_with_metadata() {
    AovFrame frame = overscan_frame();
    auto metadata = std::make_shared<Metadata>();
    OIIO::ImageSpec& spec = metadata->spec;
    spec.attribute("Scene", "shot 12");
    spec.attribute("PixelAspectRatio", 2.0f);
    const unsigned int timecode[2] = {0x01020304, 0};
    spec.attribute("smpte:TimeCode", OIIO::TypeTimeCode, timecode);
    const float turn[16] = {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 5, 20, 1};
    spec.attribute("worldtocamera", OIIO::TypeMatrix, turn);
    spec.attribute("cryptomatte/0/name", "CryptoObject");
    spec.attribute("BlenderMultiChannel", "Blender V2.55.1 and newer");
    spec.attribute("compression", "dwaa:200");
    spec.attribute("oiio:subimagename", "rgba_left");
    spec.attribute("Software", "someone else");
    frame.metadata = metadata;
    return frame;
}

TEST(ExrWriter, KeepsWhatStillHoldsOfTheMetadataAndDropsTheRest) {
    const Scratch scratch;
    const AovFrame frame = frame_with_metadata();
    const Image image = ramp(frame.data_window, 1);
    write_exr(scratch.file("out.exr"), frame, {{{"Y"}, &image}}, PixelType::half);
    const OIIO::ImageBuf read(scratch.file("out.exr"));
    const OIIO::ImageSpec& spec = read.spec();
    EXPECT_EQ(spec.get_string_attribute("Scene"), "shot 12");
    EXPECT_EQ(spec.get_float_attribute("PixelAspectRatio"), 2.0f);
    EXPECT_TRUE(spec.find_attribute("smpte:TimeCode", OIIO::TypeTimeCode));
    EXPECT_EQ(spec.get_string_attribute("compression"), "zip");
    EXPECT_EQ(spec.get_string_attribute("Software").substr(0, 8), "burnish ");
    for (const char* gone : {"cryptomatte/0/name", "BlenderMultiChannel", "oiio:subimagename", "name"})
        EXPECT_FALSE(spec.find_attribute(gone)) << gone;
}

TEST(ExrWriter, NeverTurnsACameraToWorldMatrixIntoWorldToCamera) {
    const Scratch scratch;
    const AovFrame frame = frame_with_metadata();
    const Image image = ramp(frame.data_window, 1);
    write_exr(scratch.file("out.exr"), frame, {{{"Y"}, &image}}, PixelType::half);
    const OIIO::ImageBuf read(scratch.file("out.exr"));
    Metadata metadata{read.spec()};
    EXPECT_FALSE(matrix_attribute(metadata, "worldToCamera"));
    ASSERT_TRUE(matrix_attribute(metadata, "worldtocamera"));  // how OpenImageIO shows cameraTransform
    EXPECT_EQ((*matrix_attribute(metadata, "worldtocamera"))[3][2], 20.0f);
}

TEST(ExrWriter, AddsOneHistoryLineEachTime) {
    const Scratch scratch;
    AovFrame frame = overscan_frame();
    const Image image = ramp(frame.data_window, 1);
    write_exr(scratch.file("first.exr"), frame, {{{"Y"}, &image}}, PixelType::half);
    const OIIO::ImageBuf first(scratch.file("first.exr"));
    frame.metadata = std::make_shared<Metadata>(Metadata{first.spec()});
    frame.file = scratch.file("first.exr");
    write_exr(scratch.file("second.exr"), frame, {{{"Z"}, &image}}, PixelType::half);
    const OIIO::ImageBuf second(scratch.file("second.exr"));
    const std::string history = second.spec().get_string_attribute("burnish/history");
    EXPECT_NE(history.find("beauty.0001.exr -> Y\nburnish "), std::string::npos) << history;
    EXPECT_TRUE(history.ends_with("first.exr -> Z")) << history;
}

TEST(ExrWriter, WritesTheSameBytesAtAnyTime) {
    const Scratch scratch;
    const AovFrame frame = overscan_frame();
    const Image image = ramp(frame.data_window, 3);
    write_exr(scratch.file("a.exr"), frame, {{{"R", "G", "B"}, &image}}, PixelType::half);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // a time stamp would have changed
    write_exr(scratch.file("b.exr"), frame, {{{"R", "G", "B"}, &image}}, PixelType::half);
    EXPECT_EQ(bytes_of(scratch.file("a.exr")), bytes_of(scratch.file("b.exr")));
}

TEST(ExrWriter, RefusesLayersOfAnotherSize) {
    const Scratch scratch;
    const AovFrame frame = overscan_frame();
    const Image image(3, 3, 1);
    EXPECT_EQ(code_of([&] {
                  write_exr(scratch.file("out.exr"), frame, {{{"Y"}, &image}}, PixelType::half);
              }),
              ErrorCode::size_mismatch);
    EXPECT_EQ(scratch.file_count(), 0u);
}

TEST(ExrWriter, RefusesNamesThatOtherPackagesWouldChange) {
    const Scratch scratch;
    const AovFrame frame = overscan_frame();
    const Image image = ramp(frame.data_window, 1);
    for (const char* name : {"ViewLayer.Spec.R", "my spec.R", "1spec.R", "", ".R", "spec."})
        EXPECT_EQ(code_of([&] {
                      write_exr(scratch.file("out.exr"), frame, {{{name}, &image}}, PixelType::half);
                  }),
                  ErrorCode::bad_argument)
            << name;
    EXPECT_EQ(code_of([&] {
                  write_exr(scratch.file("out.exr"), frame, {{{"Y"}, &image}, {{"Y"}, &image}}, PixelType::half);
              }),
              ErrorCode::bad_argument);
}

TEST(ExrWriter, MakesTheOutputFolder) {
    const Scratch scratch;
    const AovFrame frame = overscan_frame();
    const Image image = ramp(frame.data_window, 1);
    write_exr(scratch.file("comp/v001/out.exr"), frame, {{{"Y"}, &image}}, PixelType::half);
    EXPECT_TRUE(std::filesystem::exists(scratch.file("comp/v001/out.exr")));
}

TEST(ExrWriter, LeavesNothingBehindWhenTheDiskIsFull) {
    const Scratch scratch;
    AovFrame frame;
    frame.data_window = frame.display_window = {0, 0, 256, 256};
    Image noise(256, 256, 3);
    uint32_t state = 1;
    for (float& value : noise.data) value = static_cast<float>(state = state * 1664525u + 1013904223u);
    write_text(scratch.file("out.exr"), "the older file");
    for (const rlim_t bytes : {100, 5000, 200000}) {
        const FileSizeLimit full(bytes);
        EXPECT_EQ(code_of([&] {
                      write_exr(scratch.file("out.exr"), frame, {{{"R", "G", "B"}, &noise}}, PixelType::float32);
                  }),
                  ErrorCode::write_failed);
        EXPECT_EQ(code_of([&] { write_text(scratch.file("out.exr"), std::string(400000, 'x')); }), ErrorCode::write_failed);
    }
    EXPECT_EQ(scratch.file_count(), 1u);
    EXPECT_EQ(bytes_of(scratch.file("out.exr")), "the older file");
}

TEST(ExrWriter, RefusesTargetsThatCannotHoldAFile) {
    const Scratch scratch;
    write_text(scratch.file("plain"), "text");
    for (const std::string& target : {std::string("/proc/out.exr"), scratch.file("plain/out.exr"), std::string("/dev/full"),
                                      scratch.path().string(), std::string()})
        EXPECT_EQ(code_of([&] { write_text(target, "text"); }), ErrorCode::write_failed) << target;
    EXPECT_EQ(scratch.file_count(), 1u);
}

TEST(ExrWriter, WritesThroughASymbolicLink) {
    const Scratch scratch;
    write_text(scratch.file("real.txt"), "old");
    std::filesystem::create_symlink("real.txt", scratch.path() / "link.txt");
    write_text(scratch.file("link.txt"), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(scratch.path() / "link.txt"));
    EXPECT_EQ(bytes_of(scratch.file("real.txt")), "new");
}

TEST(ExrWriter, WritesPartsOfDifferentSizes) {
    const Scratch scratch;
    const AovFrame frame = overscan_frame();
    const Image fine = ramp(frame.data_window, 1), coarse = ramp({0, 0, 3, 2}, 1, 2.0f);
    const std::string file = scratch.file("parts.exr");
    write_exr_parts(file, frame, {{"full", {{{"level.X"}, &fine}}}, {"half", {{{"level.X"}, &coarse}}}}, PixelType::float32);
    OIIO::ImageBuf first(file, 0, 0), second(file, 1, 0);
    ASSERT_TRUE(first.read(0, 0) && second.read(1, 0)) << second.geterror();
    EXPECT_EQ(first.nsubimages(), 2);
    EXPECT_EQ(second.spec().get_string_attribute("oiio:subimagename"), "half");
    for (const auto& [part, image, window] :
         {std::tuple{&first, &fine, Window{-2, -1, 5, 4}}, {&second, &coarse, {-2, -1, 3, 2}}}) {
        const OIIO::ImageSpec& spec = part->spec();
        EXPECT_EQ((Window{spec.x, spec.y, spec.width, spec.height}), window);
        EXPECT_EQ(spec.full_width, 10);
        auto pixels = image->data;
        std::ranges::fill(pixels, 0.0f);
        ASSERT_TRUE(part->get_pixels(part->roi(), OIIO::TypeFloat, pixels.data()));
        EXPECT_EQ(pixels, image->data);
    }
}

}  // namespace
}  // namespace burnish
