// Files nobody vouches for: each is read or refused with burnish::Error, soon and in bounded memory.
#include <burnish/base/error.h>
#include <burnish/input/exr_header.h>
#include <burnish/input/exr_reader.h>

#include <core/data.h>
#include <core/input/synthetic_frame.h>
#include <core/scratch.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include <sys/resource.h>
#include <unistd.h>

namespace burnish {
namespace {

constexpr int kRead = 10, kRefused = 11;

/// Reads all of the file under limits and ends this process: a crash, a hang or a memory bomb shows as another exit.
[[noreturn]] void read_and_exit(const std::string& file) {
#ifndef __SANITIZE_ADDRESS__  // which reserves terabytes of address space
    const rlimit memory{rlim_t{6} << 30, rlim_t{6} << 30};
    setrlimit(RLIMIT_AS, &memory);
#endif
    alarm(20);
    try {
        ReadOptions options;
        options.cryptomattes = true;
        read_frame(file, options);
        _exit(kRead);
    } catch (const Error& error) {
        const std::string message = error.what();
        const bool is_clear =
            error.code() == ErrorCode::read_failed && message.starts_with(file + ": ") && message.size() < 600;
        _exit(is_clear ? kRefused : 1);
    } catch (...) {
        _exit(2);
    }
}

struct Ended {
    std::vector<int> codes;
    bool operator()(int status) const {
        return WIFEXITED(status) && std::find(codes.begin(), codes.end(), WEXITSTATUS(status)) != codes.end();
    }
};

std::vector<std::string> files_in(const std::filesystem::path& folder) {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() != ".json") files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

class UntrustedFiles : public testing::TestWithParam<const char*> {};

TEST_P(UntrustedFiles, AreReadOrRefusedWithinLimits) {
    const auto folder = data_path(GetParam());
    if (!folder) GTEST_SKIP() << "no test data: set BURNISH_DATA";
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    for (const std::string& file : files_in(*folder)) EXPECT_EXIT(read_and_exit(file), (Ended{{kRead, kRefused}}), "") << file;
}

INSTANTIATE_TEST_SUITE_P(Public, UntrustedFiles, testing::Values("public/exr_aov", "public/exr_spec", "public/exr_bad"));

TEST(DamagedFiles, AreAllRefused) {
    const auto folder = data_path("public/exr_bad");
    if (!folder) GTEST_SKIP() << "no test data: set BURNISH_DATA";
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    for (const std::string& file : files_in(*folder)) EXPECT_EXIT(read_and_exit(file), (Ended{{kRefused}}), "") << file;
}

std::string refusal_of(const std::string& file) {
    try {
        read_frame(file, {});
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::read_failed);
        return error.what();
    }
    return "(was read)";
}

void expect_refusal(const std::string& file, const std::string& reason) {
    const std::string message = refusal_of(file);
    EXPECT_NE(message.find(reason), std::string::npos) << message;
    EXPECT_NE(message.find(file), std::string::npos) << message;
}

TEST(RefusedFiles, AreNamedWithTheReasonAndTheRemedy) {
    const Scratch scratch;
    std::ofstream(scratch.file("text.exr")) << "not a picture";
    std::ofstream(scratch.file("empty.exr")) << "";
    expect_refusal(scratch.file("absent.exr"), "there is no such file");
    expect_refusal(scratch.path().string(), "is not a file");
    expect_refusal(scratch.file("text.exr"), "is not an OpenEXR file");
    expect_refusal(scratch.file("empty.exr"), "is not an OpenEXR file");
    const std::map<std::string, std::string> reasons = {{"exr_aov/Trunks.exr", "is a deep file; flatten it"},
                                                        {"exr_spec/Flowers.exr", "is subsampled"},
                                                        {"exr_spec/partial.exr", "is missing"},
                                                        {"exr_bad/memory_DOS_1", "too large"}};
    for (const auto& [name, reason] : reasons)
        if (const auto file = data_path("public/" + name)) expect_refusal(file->string(), reason);
}

/// A file whose header speaks of `width` x `height` pixels while the pixels are those of a small one.
std::string with_claimed_size(const Scratch& scratch, int width, int height) {
    const std::string file = write_synthetic(scratch.file("bomb.exr"), {{{{{"R", "G", "B"}, Image(8, 8, 3, 0.5f)}}}});
    std::stringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    std::string text = bytes.str();
    for (const std::string& name : {std::string("dataWindow\0box2i\0", 17), std::string("displayWindow\0box2i\0", 20)}) {
        const size_t box = text.find(name) + name.size() + 4;
        const int32_t high[2] = {width - 1, height - 1};
        std::memcpy(text.data() + box + 8, high, sizeof(high));
    }
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

TEST(RefusedFiles, ClaimMorePixelsThanTheirBytesCanHold) {
    const Scratch scratch;
    expect_refusal(with_claimed_size(scratch, 16000, 16000), "more than its");
    expect_refusal(with_claimed_size(scratch, 4000, 2000), "more than its");
    expect_refusal(with_claimed_size(scratch, 40000, 40000), "more than the");
    expect_refusal(with_claimed_size(scratch, 8, 2000000), "too large");
    EXPECT_EQ(refusal_of(with_claimed_size(scratch, 8, 8)), "(was read)");
}

TEST(RefusedFiles, AreThoseCutOffAnywhere) {
    const Scratch scratch;
    const SyntheticFrame scene;
    const std::string whole =
        write_synthetic(scratch.file("whole.exr"),
                        {{{{{"R", "G", "B", "A"}, scene.beauty}, {xyz("N"), scene.normal}, {xyz("P"), scene.position}}}});
    const auto bytes = std::filesystem::file_size(whole);
    for (uintmax_t kept = 0; kept < bytes; kept += std::max<uintmax_t>(bytes / 97, 1)) {
        const std::string cut = scratch.file("cut.exr");
        std::filesystem::copy_file(whole, cut, std::filesystem::copy_options::overwrite_existing);
        std::filesystem::resize_file(cut, kept);
        EXPECT_NE(refusal_of(cut), "(was read)") << kept << " of " << bytes << " bytes";
    }
}

TEST(DamagedBytes, NeverCrashTheReader) {
    const Scratch scratch;
    const SyntheticFrame scene;
    const std::string whole = write_synthetic(
        scratch.file("whole.exr"), {{{{{"R", "G", "B", "A"}, scene.beauty, OIIO::TypeHalf}, {xyz("P"), scene.position}}}});
    std::stringstream stream;
    stream << std::ifstream(whole, std::ios::binary).rdbuf();
    const std::string bytes = stream.str();
    uint32_t state = 7;
    const auto random = [&](uint32_t below) { return ((state = state * 1664525u + 1013904223u) >> 8) % below; };
    for (int round = 0; round < 400; ++round) {
        std::string damaged = bytes;
        const uint32_t reach = round % 2 ? 600u : static_cast<uint32_t>(bytes.size());  // the header as often as the pixels
        for (int hits = 0; hits < 1 + round % 4; ++hits) damaged[random(reach)] = static_cast<char>(random(256));
        std::ofstream(scratch.file("damaged.exr"), std::ios::binary) << damaged;
        refusal_of(scratch.file("damaged.exr"));  // read or refused: both are fine
    }
}

}  // namespace
}  // namespace burnish
