#include "core/scratch.h"

#include <burnish/base/error.h>
#include <burnish/input/frames.h>

#include <gtest/gtest.h>

#include <fstream>

using namespace burnish;

namespace {

using Frames = std::vector<int>;

std::string complaint(const std::string& text) {
    try {
        parse_frames(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_argument);
        return error.what();
    }
    return {};
}

void touch(const Scratch& scratch, const std::string& name) {
    std::filesystem::create_directories((scratch.path() / name).parent_path());
    std::ofstream(scratch.file(name)) << "x";
}

}  // namespace

TEST(Frames, ParseAsArtistsWriteThem) {
    EXPECT_EQ(parse_frames("7"), Frames({7}));
    EXPECT_EQ(parse_frames("1-5"), Frames({1, 2, 3, 4, 5}));
    EXPECT_EQ(parse_frames("1-6x2"), Frames({1, 3, 5}));
    EXPECT_EQ(parse_frames("7-20:5"), Frames({7, 12, 17}));
    EXPECT_EQ(parse_frames("1,3,5-7"), Frames({1, 3, 5, 6, 7}));
    EXPECT_EQ(parse_frames(" 3, 5-6 9 "), Frames({3, 5, 6, 9}));
    EXPECT_EQ(parse_frames("99999-100001"), Frames({99999, 100000, 100001}));
}

TEST(Frames, MayBeNegative) {
    EXPECT_EQ(parse_frames("-2"), Frames({-2}));
    EXPECT_EQ(parse_frames("-2-1"), Frames({-2, -1, 0, 1}));
    EXPECT_EQ(parse_frames("-3--1"), Frames({-3, -2, -1}));
}

TEST(Frames, KeepTheGivenOrderAndComeOnce) { EXPECT_EQ(parse_frames("5,1-3,2,5"), Frames({5, 1, 2, 3})); }

TEST(Frames, AreRefusedWithAReason) {
    for (const char* text : {"a", "1-", "1--", "1-5x", "1-5y2", "1-5x2x3", "1.5", "0x10-20", "-", "1;2", "99999999999"})
        EXPECT_NE(complaint(text), "") << text;
    EXPECT_NE(complaint("").find("no frame"), std::string::npos);
    EXPECT_NE(complaint("9-1").find("backwards"), std::string::npos);
    EXPECT_NE(complaint("1-9x0").find("step"), std::string::npos);
    EXPECT_NE(complaint("1-9x-2").find("step"), std::string::npos);
    EXPECT_NE(complaint("1-2000000000").find("million"), std::string::npos);
    EXPECT_NE(complaint("-2147483648-2147483647").find("million"), std::string::npos);
}

TEST(Frames, EndAtTheLargestInteger) { EXPECT_EQ(parse_frames("2147483645-2147483647x2"), Frames({2147483645, 2147483647})); }

TEST(FramePattern, NamesAFileForEveryForm) {
    for (const char* pattern :
         {"shot.####.exr", "shot.#.exr", "shot.@@@@.exr", "shot.%04d.exr", "shot.$F4.exr", "shot.<f4>.exr"}) {
        EXPECT_TRUE(has_frame_token(pattern));
        EXPECT_EQ(frame_file(pattern, 7), "shot.0007.exr") << pattern;
        EXPECT_EQ(frame_file(pattern, 12345), "shot.12345.exr") << pattern;
        EXPECT_EQ(frame_file(pattern, -5), "shot.-005.exr") << pattern;
    }
    EXPECT_EQ(frame_file("a.@@@.exr", 7), "a.007.exr");
    EXPECT_EQ(frame_file("a.##.exr", 7), "a.07.exr");
    for (const char* pattern : {"a.%d.exr", "a.$F.exr", "a.<f>.exr", "a.@.exr"}) EXPECT_EQ(frame_file(pattern, 7), "a.7.exr");
}

TEST(FramePattern, FillsEveryTokenOfAPath) { EXPECT_EQ(frame_file("/x/####/a_$F2.%03d.exr", 7), "/x/0007/a_07.007.exr"); }

TEST(FramePattern, LeavesAloneWhatIsNoFrame) {
    for (const char* name : {"shot.0001.exr", "tex.<UDIM>.exr", "a@b/shot.exr", "$FOO/a.exr", "$FF.exr", "100%.exr", "%s.exr",
                             "%99999999999d.exr", "<frame>.exr", "$"}) {
        EXPECT_FALSE(has_frame_token(name)) << name;
        EXPECT_EQ(frame_file(name, 7), name);
    }
}

TEST(FramePattern, FindsItsFramesOnDisk) {
    const Scratch scratch;
    for (const char* name :
         {"shot.0001.exr", "shot.0010.exr", "shot.12345.exr", "shot.-005.exr", "shot.7.exr", "shot.0002.exr.tmp",
          "other.0003.exr", "shot.0004.png", "shot..exr", ".shot.0005.exr", "shot.00006.exr"})
        touch(scratch, name);
    std::filesystem::create_directory(scratch.path() / "shot.0099.exr");
    EXPECT_EQ(frames_on_disk(scratch.file("shot.####.exr")), Frames({-5, 1, 10, 12345}));
    EXPECT_EQ(frames_on_disk(scratch.file("shot.%d.exr")), Frames({7, 12345}));
    EXPECT_EQ(frames_on_disk(scratch.file("none.####.exr")), Frames());
    EXPECT_EQ(frames_on_disk(scratch.file("absent/none.####.exr")), Frames());
    EXPECT_THROW(frames_on_disk(scratch.file("shot.0001.exr")), Error);
}

TEST(FramePattern, FindsFramesInNumberedFolders) {
    const Scratch scratch;
    touch(scratch, "0001/beauty.001.exr");
    touch(scratch, "0002/beauty.003.exr");
    touch(scratch, "0004/beauty.004.exr");
    EXPECT_EQ(frames_on_disk(scratch.file("####/beauty.@@@.exr")), Frames({1, 4}));
}
