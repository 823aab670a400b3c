#include "core/data.h"
#include "core/read_layer.h"
#include "core/scratch.h"

#include <burnish/base/error.h>
#include <burnish/input/cryptomatte.h>
#include <burnish/input/name_pattern.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <fstream>

using namespace burnish;

namespace {

CryptomatteSource source_of(const std::filesystem::path& file) {
    CryptomatteSource source;
    source.file = file.string();
    const auto input = OIIO::ImageInput::open(source.file);
    if (!input) throw std::runtime_error(source.file + " does not open");
    const OIIO::ImageSpec& spec = input->spec();
    for (const OIIO::ParamValue& attribute : spec.extra_attribs)
        if (attribute.type() == OIIO::TypeString)
            source.attributes.push_back({attribute.name().string(), attribute.get_string()});
    for (int c = 0; c < spec.nchannels; ++c)
        source.channels.push_back({spec.channel_name(c), spec.channelformat(c) == OIIO::TypeFloat});
    return source;
}

/// "ball" covers 1 and 0.25, "table" 0 and 0.5 of two pixels.
Image small_layer() {
    Image layer(2, 1, 4);
    const float ball = std::bit_cast<float>(cryptomatte_id("ball")), table = std::bit_cast<float>(cryptomatte_id("table"));
    layer.data = {ball, 1, 0, 0, table, 0.5f, ball, 0.25f};
    return layer;
}

/// With the pixels of the file, or of small_layer() where there is none.
std::vector<Cryptomatte> decode(const CryptomatteSource& source, std::vector<std::string>& warnings) {
    auto result = decode_cryptomattes(source, warnings);
    for (Cryptomatte& matte : result) {
        const bool is_small = !std::filesystem::exists(source.file);
        const Image layers = is_small ? small_layer() : read_layer(source.file, matte.channels);
        for (int first = 0; first < layers.channels; first += 2) {
            Image& rank = matte.ranks.emplace_back(layers.width, layers.height, 2);
            for (size_t i = 0; i < layers.pixel_count(); ++i) std::copy_n(layers.at(i) + first, 2, rank.at(i));
        }
    }
    return result;
}

std::vector<Cryptomatte> decode(const CryptomatteSource& source) {
    std::vector<std::string> warnings;
    auto result = decode(source, warnings);
    for (const std::string& warning : warnings) ADD_FAILURE() << warning;
    return result;
}

/// A cryptomatte of one layer, made in memory.
CryptomatteSource small_source() {
    CryptomatteSource source;
    source.file = "small.exr";
    source.attributes = {{"cryptomatte/abc/name", "obj"},
                         {"cryptomatte/abc/hash", "MurmurHash3_32"},
                         {"cryptomatte/abc/conversion", "uint32_to_float32"}};
    for (const char* component : {"R", "G", "B", "A"}) source.channels.push_back({std::string("obj00.") + component, true});
    return source;
}

bool matches(const char* pattern, const char* name) { return NamePattern(pattern).matches(name); }

std::vector<std::string> warnings_of(const CryptomatteSource& source, size_t expected_cryptomattes) {
    std::vector<std::string> warnings;
    EXPECT_EQ(decode_cryptomattes(source, warnings).size(), expected_cryptomattes);
    return warnings;
}

}  // namespace

TEST(CryptomatteId, AgreesWithTheSpecificationAndWithBlender) {
    EXPECT_EQ(cryptomatte_id("torus"), 4053562365u);
    EXPECT_EQ(cryptomatte_id("равнина"), 2518896926u);
    EXPECT_EQ(cryptomatte_id("Ball A"), 0x45855625u);
    EXPECT_EQ(cryptomatte_id("Floor"), 0x6a2fb16eu);
}

TEST(CryptomatteId, IsAlwaysANormalFloat) {
    size_t turned = 0;
    for (int i = 0; i < 200000; ++i) {
        const float id = std::bit_cast<float>(cryptomatte_id(std::to_string(i)));
        ASSERT_TRUE(std::isnormal(id)) << i;
        turned += std::fabs(id) < 3e-38f;
    }
    EXPECT_GT(turned, 0u) << "some of 200 000 names need the exponent's bit flipped";
}

TEST(NamePattern, MatchesAsShellsDo) {
    EXPECT_TRUE(matches("table*", "table"));
    EXPECT_TRUE(matches("table*", "table_leg"));
    EXPECT_TRUE(matches("*leg*", "table_leg_1"));
    EXPECT_TRUE(matches("leg_?", "leg_1"));
    EXPECT_TRUE(matches("a*b*c", "a_b_b_c"));
    EXPECT_FALSE(matches("leg_?", "leg_12"));
    EXPECT_FALSE(matches("Table*", "table")) << "case matters";
    EXPECT_FALSE(matches("a*b*c", "a_b_c_d"));
    EXPECT_FALSE(matches("", "a"));
    EXPECT_TRUE(matches("*", ""));
}

TEST(NamePattern, TakesBracketsAndEscapedCharactersAsTheyAre) {
    EXPECT_TRUE(matches("rect_[_top", "rect_[_top"));
    EXPECT_TRUE(matches("has_\\*", "has_*"));
    EXPECT_FALSE(matches("has_\\*", "has_n"));
    EXPECT_FALSE(NamePattern("has_\\*").has_wildcards());
    EXPECT_TRUE(matches("?авнина", "равнина")) << "one character of two bytes";
}

TEST(NamePattern, SplitsAtCommasButNotAtEscapedOnes) {
    const auto patterns = name_patterns(" ball , table*,,a\\,b ");
    ASSERT_EQ(patterns.size(), 3u);
    EXPECT_EQ(patterns[0].literal(), "ball");
    EXPECT_TRUE(patterns[1].has_wildcards());
    EXPECT_EQ(patterns[2].literal(), "a,b");
}

TEST(NamePattern, StaysFastOnHostilePatterns) {
    std::string pattern;
    for (int i = 0; i < 200; ++i) pattern += "a*";
    EXPECT_FALSE(NamePattern(pattern + "b").matches(std::string(5000, 'a')));
}

TEST(Cryptomatte, CoversByNameWithoutAManifest) {
    const Cryptomatte matte = decode(small_source()).at(0);
    EXPECT_EQ(matte.ranks.size(), 2u);
    EXPECT_EQ(cryptomatte_coverage(matte, matching_ids(matte, "ball")).data, (PixelVector<float>{1.0f, 0.25f}));
    EXPECT_EQ(cryptomatte_coverage(matte, matching_ids(matte, "ball, table")).data, (PixelVector<float>{1.0f, 0.75f}));
    EXPECT_EQ(cryptomatte_coverage(matte, matching_ids(matte, "chair")).data, (PixelVector<float>{0.0f, 0.0f}));
    EXPECT_THROW(matching_ids(matte, "b*"), Error) << "wildcards need the names";
}

TEST(Cryptomatte, UsesTheManifestOfTheHeader) {
    CryptomatteSource source = small_source();
    char text[80];
    std::snprintf(text, sizeof(text), R"({"ball":"%08x","ta,ble":"%08x"})", cryptomatte_id("ball"), cryptomatte_id("table"));
    source.attributes.push_back({"cryptomatte/abc/manifest", text});
    const Cryptomatte matte = decode(source).at(0);
    EXPECT_EQ(matching_ids(matte, "b*"), std::vector{cryptomatte_id("ball")});
    EXPECT_EQ(matching_ids(matte, "ta,ble"), std::vector{cryptomatte_id("table")}) << "a listed name may hold a comma";
    EXPECT_EQ(matching_ids(matte, "*").size(), 2u);
}

TEST(Cryptomatte, TakesHashesOfAManifestForTheIdsThatPixelsShow) {
    CryptomatteSource source = small_source();
    source.attributes.push_back({"cryptomatte/abc/manifest", R"({"pr_glass":"005c9ec5","infinite":"7f800001"})"});
    const Cryptomatte matte = decode(source).at(0);
    EXPECT_EQ(matching_ids(matte, "pr_glass"), std::vector<uint32_t>{0x00dc9ec5});
    EXPECT_EQ(cryptomatte_id("pr_glass"), 0x00dc9ec5u);
    EXPECT_EQ(matching_ids(matte, "inf*"), std::vector<uint32_t>{0x7f000001});
}

TEST(Cryptomatte, SurvivesHostileManifests) {
    const std::string deep = std::string(2000000, '[');
    const std::string hostile[] = {"{",
                                   "null",
                                   "[1,2]",
                                   "\"x\"",
                                   deep,
                                   "{\"a\":" + deep,
                                   R"({"a":{"b":{}}})",
                                   "{\"\xff\xfe\":\"00000001\"}",
                                   "{\"a\":\"zz\"}",
                                   R"({"a":12})",
                                   R"({"a":"123456789"})",
                                   R"({"a":"-1234567"})",
                                   R"({"a":"0x123456"})",
                                   std::string("{\0}", 3)};
    for (const std::string& manifest : hostile) {
        CryptomatteSource source = small_source();
        source.attributes.push_back({"cryptomatte/abc/manifest", manifest});
        std::vector<std::string> warnings;
        const auto mattes = decode(source, warnings);
        ASSERT_EQ(mattes.size(), 1u);
        EXPECT_TRUE(mattes[0].manifest.empty());
        EXPECT_EQ(warnings.size(), 1u) << manifest.substr(0, 40);
        EXPECT_EQ(cryptomatte_coverage(mattes[0], matching_ids(mattes[0], "ball")).data[0], 1) << "names still work by hash";
    }
}

TEST(Cryptomatte, OpensManifestFilesOnlyBesideTheExr) {
    const Scratch scratch;
    std::filesystem::create_directory(scratch.path() / "shot");
    std::ofstream(scratch.file("secret.json")) << R"({"ball":"01000001"})";
    std::ofstream(scratch.file("shot/names.json")) << R"({"ball":"01000001"})";
    CryptomatteSource source = small_source();
    source.file = scratch.file("shot/small.exr");
    source.attributes.push_back({"cryptomatte/abc/manif_file", "names.json"});
    EXPECT_EQ(decode(source).at(0).manifest.at("ball"), 0x01000001u);
    for (const std::string& name : {std::string("../secret.json"), scratch.file("secret.json"), std::string("absent.json"),
                                    std::string("."), std::string("a/../../secret.json")}) {
        source.attributes.back().value = name;
        EXPECT_EQ(warnings_of(source, 1).size(), 1u) << name;
    }
}

TEST(Cryptomatte, LeavesOutWhatCannotHoldIds) {
    CryptomatteSource half = small_source();
    half.channels[2].is_float = false;
    EXPECT_NE(warnings_of(half, 0).at(0).find("32-bit float"), std::string::npos);
    CryptomatteSource incomplete = small_source();
    incomplete.channels.pop_back();
    EXPECT_NE(warnings_of(incomplete, 0).at(0).find("no layer obj00"), std::string::npos);
    CryptomatteSource other_hash = small_source();
    other_hash.attributes[1].value = "SHA1";
    EXPECT_NE(warnings_of(other_hash, 0).at(0).find("MurmurHash3_32"), std::string::npos);
    CryptomatteSource nameless = small_source();
    nameless.attributes.erase(nameless.attributes.begin());
    EXPECT_EQ(warnings_of(nameless, 0).size(), 1u);
}

TEST(Cryptomatte, PutsObjectsFirst) {
    CryptomatteSource source = small_source();
    source.attributes[0].value = "crypto_object";
    source.attributes.insert(source.attributes.begin(), {"cryptomatte/aaa/name", "crypto_asset"});
    for (const char* layer : {"crypto_object00.", "ViewLayer.crypto_asset00."})
        for (const char* component : {"red", "green", "blue", "alpha"})
            source.channels.push_back({std::string(layer) + component, true});
    const auto mattes = decode(source);
    ASSERT_EQ(mattes.size(), 2u);
    EXPECT_EQ(mattes[0].name, "crypto_object");
}

namespace {

struct RealFile {
    const char* file;
    size_t cryptomattes;
    const char* covered;  // an object that covers some pixels, by the file's manifest
};

const RealFile kRealFiles[] = {
    {"multichannel.exr", 3, "/obj/box:polygons:1"},
    {"special_chars.exr", 1, "name, with, comma"},
    {"sidecar_manifest.exr", 1, "*"},
    {"arnold_three_crypto.exr", 3, "Sphere001"},
    {"clarisse_two_crypto.exr", 2, "build://project/SHOT_NAME/DUMMY/Dragon_2_obj"},
    {"karma_cpu_solaris_one_crypto.exr", 1, "/cube1"},
    {"cornellBox_CryptoWildcard.0001.exr", 1, "sphere_?_2"},
    {"cryptomatte.exr", 2, "/GAFFERBOT/C_torso_GRP/*"},
};

}  // namespace

TEST(Cryptomatte, DecodesTheFilesOfRealRenderers) {
    const auto folder = data_path("public/exr_aov");
    if (!folder) GTEST_SKIP() << "no test data; set BURNISH_DATA";
    for (const RealFile& expected : kRealFiles) {
        SCOPED_TRACE(expected.file);
        const auto mattes = decode(source_of(*folder / expected.file));
        ASSERT_EQ(mattes.size(), expected.cryptomattes);
        bool covers = false;
        for (const Cryptomatte& matte : mattes) {
            for (const auto& [name, id] : matte.manifest) EXPECT_EQ(cryptomatte_id(name), id) << name;
            float largest = 0;
            for (size_t i = 0; i < matte.ranks[0].pixel_count(); ++i) {
                float sum = 0;
                for (const Image& rank : matte.ranks) sum += rank.at(i)[1];
                largest = std::max(largest, sum);
            }
            EXPECT_LE(largest, 1.001f) << matte.name;
            if (matte.manifest.empty()) continue;
            const Image coverage = cryptomatte_coverage(matte, matching_ids(matte, expected.covered));
            covers |= *std::max_element(coverage.data.begin(), coverage.data.end()) > 0.99f;
        }
        EXPECT_TRUE(covers) << expected.covered;
    }
}

TEST(Cryptomatte, FindsEveryPixelOfEveryObjectThatAManifestLists) {
    const auto file = data_path("public/exr_aov/special_chars.exr");
    if (!file) GTEST_SKIP() << "no test data; set BURNISH_DATA";
    const Cryptomatte matte = decode(source_of(*file)).at(0);
    ASSERT_EQ(matte.manifest.size(), 4u);
    Image sum(matte.ranks[0].width, matte.ranks[0].height, 1);
    for (const char* name : {"name containing a \"quote\"  ", "name_containing/slash", "равнина", "name, with, comma"}) {
        const Image coverage = cryptomatte_coverage(matte, matching_ids(matte, name));
        EXPECT_GT(*std::max_element(coverage.data.begin(), coverage.data.end()), 0.9f) << name;
        for (size_t i = 0; i < sum.data.size(); ++i) sum.data[i] += coverage.data[i];
    }
    const Image all = cryptomatte_coverage(matte, matching_ids(matte, "*"));
    for (size_t i = 0; i < sum.data.size(); ++i) EXPECT_NEAR(sum.data[i], all.data[i], 1e-5f);
}
