// MERL tables against closed forms, and their files byte by byte.
#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/material/measured/merl_names.h>
#include <burnish/material/measured/merl_table.h>
#include <core/material/lobe_cases.h>
#include <core/scratch.h>

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

namespace burnish {
namespace {

std::string bytes_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void write_bytes(const std::string& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }

/// Smooth in the table's coordinates, another in each channel.
Color3f smooth(const Vec3f& wo, const Vec3f& wi) {
    const HalfDifference a = half_difference(wo, wi);
    const float base = std::exp(-2 * a.theta_h) * (1 + 0.5f * a.theta_d * a.theta_d) * (1 + 0.1f * std::cos(2 * a.phi_d));
    return {base, 0.5f * base, 0.25f * base * (1 + a.theta_d)};
}

const MerlTable& smooth_table() {
    static const MerlTable table(smooth);
    return table;
}

std::string complaint(const std::string& file) {
    try {
        MerlTable::read(file);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::read_failed);
        return error.what();
    }
    return "no complaint";
}

/// The bytes of a table whose numbers are all `number`, red, green and blue.
std::string uniform_file(double number) {
    std::string bytes(MerlTable::kFileSize, '\0');
    const int32_t dimensions[] = {90, 90, 180};
    std::memcpy(bytes.data(), dimensions, sizeof(dimensions));
    for (size_t at = sizeof(dimensions); at < bytes.size(); at += sizeof(number))
        std::memcpy(&bytes[at], &number, sizeof(number));
    return bytes;
}

}  // namespace

TEST(HalfDifference, AnglesAndDirectionsAreInverses) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (int i = 0; i < 1000; ++i) {
        const HalfDifference a{1.5f * uniform(random), 6 * uniform(random) - 3, 1.5f * uniform(random),
                               6 * uniform(random) - 3};
        const DirectionPair pair = directions(a);
        const HalfDifference b = half_difference(pair.wo, pair.wi);
        EXPECT_NEAR(a.theta_h, b.theta_h, 2e-6f);
        EXPECT_NEAR(a.theta_d, b.theta_d, 2e-6f);
        EXPECT_NEAR(a.phi_h, b.phi_h, 2e-5f / std::sin(a.theta_h) / std::cos(a.theta_d));
        EXPECT_NEAR(a.phi_d, b.phi_d, 2e-5f / std::sin(a.theta_h) / std::sin(a.theta_d));
    }
}

TEST(HalfDifference, StaysExactNearTheMirrorDirection) {
    const double theta = 1.0, off = 2e-4;  // the half vector leans by off / 2
    const Vec3f wo(-std::sin(theta), 0, std::cos(theta)), wi(std::sin(theta + off), 0, std::cos(theta + off));
    EXPECT_NEAR(half_difference(wo, wi).theta_h, off / 2, 1e-6 * off + 1e-7);
}

TEST(MerlTable, AgreesWithTheFunctionBetweenTheMiddlesOfItsCells) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 2000; ++i) {
        const Vec3f wo = direction_deg(80 * uniform(random), 360 * uniform(random));
        const Vec3f wi = direction_deg(80 * uniform(random), 360 * uniform(random));
        const Color3f expected = smooth(wo, wi), found = smooth_table().eval(wo, wi);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 0.005f * expected[c]) << wo << " " << wi;
    }
}

TEST(MerlTable, GivesBackTheMiddlesOfItsCells) {
    for (const MerlTable::Cell cell : {MerlTable::Cell{0, 10, 0}, {5, 20, 179}, {40, 3, 90}, {60, 30, 17}}) {
        const DirectionPair pair = MerlTable::directions(cell);
        const Color3f expected = smooth(pair.wo, pair.wi);
        ASSERT_TRUE(smooth_table().at(cell).has_value());
        for (int c = 0; c < 3; ++c) {
            EXPECT_FLOAT_EQ((*smooth_table().at(cell))[c], expected[c]);
            EXPECT_NEAR(smooth_table().eval(pair.wo, pair.wi)[c], expected[c], 1e-3f * expected[c]);
        }
    }
}

TEST(MerlTable, IsReciprocalAndIsotropic) {
    const Vec3f wo = direction_deg(50, 10), wi = direction_deg(65, 200);
    const Vec3f wo_turned = direction_deg(50, 130), wi_turned = direction_deg(65, 320);
    const float f = smooth_table().eval(wo, wi).x;
    EXPECT_NEAR(smooth_table().eval(wi, wo).x, f, 1e-5f * f);
    EXPECT_NEAR(smooth_table().eval(wo_turned, wi_turned).x, f, 1e-5f * f);
}

TEST(MerlTable, IsBlackFromAndToBelowTheSurface) {
    const Vec3f above = direction_deg(30, 0), below = direction_deg(120, 0);
    EXPECT_EQ(smooth_table().eval(above, below), Color3f(0));
    EXPECT_EQ(smooth_table().eval(below, above), Color3f(0));
}

TEST(MerlTable, FillsWhatWasNotMeasuredUpToTheHorizon) {
    const MerlTable table([](const Vec3f& wo, const Vec3f& wi) {  // nothing beyond 80 degrees
        return wo.z > 0.17f && wi.z > 0.17f ? Color3f(0.5f, 0.25f, 1) : Color3f(std::numeric_limits<float>::quiet_NaN());
    });
    EXPECT_GT(table.measured_cells(), 500000);
    for (const double theta_deg : {10.0, 79.0, 85.0, 89.9})
        for (const double phi_deg : {0.0, 45.0, 180.0}) {
            const Color3f f = table.eval(direction_deg(theta_deg, 0), direction_deg(theta_deg, phi_deg));
            EXPECT_LT((f - Color3f(0.5f, 0.25f, 1)).length(), 1e-5f) << theta_deg << " " << phi_deg << " " << f;
        }
    for (const BrdfSample& sample : table.samples()) EXPECT_GT(std::min(sample.wo.z, sample.wi.z), 0.17f);
}

TEST(MerlTable, SamplesAreSomeHundredThousandPairsAboveTheSurface) {
    const std::vector<BrdfSample> samples = smooth_table().samples();
    EXPECT_GT(samples.size(), 100000u);
    EXPECT_LT(samples.size(), 160000u);
    for (size_t i = 0; i < samples.size(); i += 997) {
        EXPECT_GT(std::min(samples[i].wo.z, samples[i].wi.z), 0.0f);
        EXPECT_NEAR(samples[i].f.x, smooth(samples[i].wo, samples[i].wi).x, 1e-5f);
    }
}

TEST(MerlTable, IsTheSameForAnyThreadCount) {
    const Scratch folder;
    const ThreadLimit limit(1);
    MerlTable(smooth).write(folder.file("one.binary"));
    smooth_table().write(folder.file("all.binary"));
    EXPECT_TRUE(bytes_of(folder.file("one.binary")) == bytes_of(folder.file("all.binary")));
}

TEST(MerlTable, WritesTheBytesItRead) {
    const Scratch folder;
    std::string bytes = uniform_file(300);
    const double odd[] = {-1,    -0.0,  std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                          1e300, 5e-324};
    std::memcpy(&bytes[12 + 8 * 1000], odd, sizeof(odd));
    write_bytes(folder.file("in.binary"), bytes);
    const auto table = MerlTable::read(folder.file("in.binary"));
    EXPECT_EQ(table->file(), folder.file("in.binary"));
    table->write(folder.file("out.binary"));
    EXPECT_TRUE(bytes_of(folder.file("out.binary")) == bytes);
    EXPECT_EQ(table->measured_cells(), MerlTable::kCells - 4);
    const Color3f f = table->eval(direction_deg(20, 0), direction_deg(40, 100));
    EXPECT_LT((f - Color3f(0.2f, 0.23f, 0.332f)).length(), 1e-6f);
}

TEST(MerlTable, RefusesWhatIsNoTable) {
    const Scratch folder;
    const std::string file = folder.file("x.binary");
    EXPECT_NE(complaint(file).find("no such file"), std::string::npos);
    EXPECT_NE(complaint(folder.path().string()).find("no such file"), std::string::npos);
    write_bytes(file, uniform_file(1).substr(0, 1000));
    EXPECT_NE(complaint(file).find("expected 34992012 bytes"), std::string::npos) << complaint(file);
    std::string bytes = uniform_file(1);
    bytes[0] = 91;
    write_bytes(file, bytes);
    EXPECT_NE(complaint(file).find("found 91 90 180"), std::string::npos) << complaint(file);
    for (const double number : {-1.0, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
        write_bytes(file, uniform_file(number));
        EXPECT_NE(complaint(file).find("none of its numbers"), std::string::npos) << complaint(file);
    }
}

TEST(MerlNames, TheHashIsSha256) {
    const Scratch folder;
    write_bytes(folder.file("abc"), "abc");  // FIPS 180-2, example B.1
    EXPECT_EQ(sha256_of(folder.file("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(merl_name(folder.file("abc")), "");
    EXPECT_THROW(sha256_of(folder.file("none")), Error);
    EXPECT_THROW(sha256_of(folder.path().string()), Error);
}

TEST(MerlNames, KnowsTheHundred) {
    ASSERT_EQ(merl_files().size(), 100u);
    for (const MerlFile& file : merl_files()) EXPECT_EQ(file.sha256.size(), 64u) << file.name;
}

}  // namespace burnish
