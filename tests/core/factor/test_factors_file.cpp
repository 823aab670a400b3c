// Factors in files: what comes back, and what is refused.
#include "core/scratch.h"

#include <burnish/base/error.h>
#include <burnish/base/json_text.h>
#include <burnish/factor/factors_file.h>
#include <burnish/input/frame.h>
#include <burnish/output/exr_writer.h>
#include <burnish/output/factors_writer.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>

namespace burnish {
namespace {

using nlohmann::json;

/// Maps of values that halves hold exactly, all texels different, second terms signed.
StoredFactors numbered_factors(const Parametrization& parametrization, Mapping sphere, int terms = 1) {
    StoredFactors stored;
    stored.factors = uniform_factors(parametrization, sphere, 8);
    while (static_cast<int>(stored.factors.terms.size()) < terms) stored.factors.terms.push_back(stored.factors.terms[0]);
    for (FactorTerm& term : stored.factors.terms)
        for (FactorMap& map : term)
            for (size_t i = 0; i < map.texels.size(); ++i) {
                const float value = static_cast<float>(i) / 1024;
                map.texels[i] = Color3f(value, 2 * value, &term == stored.factors.terms.data() ? 1 : -value);
            }
    stored.factors.guide.dominant = Vec3f(0, 0.6f, 0.8f);
    stored.factors.guide.towards_n[3] = 0.25f, stored.factors.guide.towards_r[7] = 1.5f;
    stored.world_to_map = Matrix33f(0, 1, 0, 0, 0, 1, 1, 0, 0);
    stored.gain = Color3f(2, 1, 0.5f);
    stored.made_of = R"({"material_name":"gold"})";
    return stored;
}

void expect_equal(const StoredFactors& a, const StoredFactors& b) {
    EXPECT_EQ(a.factors.parametrization, b.factors.parametrization);
    EXPECT_EQ(a.factors.guide.dominant, b.factors.guide.dominant);
    EXPECT_EQ(a.factors.guide.towards_n, b.factors.guide.towards_n);
    EXPECT_EQ(a.factors.guide.towards_r, b.factors.guide.towards_r);
    EXPECT_EQ(a.world_to_map, b.world_to_map);
    EXPECT_EQ(a.gain, b.gain);
    EXPECT_EQ(a.made_of, b.made_of);
    ASSERT_EQ(a.factors.terms.size(), b.factors.terms.size());
    for (size_t term = 0; term < a.factors.terms.size(); ++term)
        for (size_t map = 0; map < a.factors.terms[term].size(); ++map) {
            const FactorMap &x = a.factors.terms[term][map], &y = b.factors.terms[term][map];
            EXPECT_EQ(x.layout.mapping(), y.layout.mapping());
            EXPECT_EQ(x.texels, y.texels);
        }
}

std::string refusal(const std::string& file) {
    try {
        read_factors(file);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// A file of these texels under any header.
void write_with_header(const std::string& file, const std::string& header, const Image& picture) {
    AovFrame frame;
    frame.display_window = {0, 0, picture.width, picture.height};
    const std::vector<OutputPart> parts = {{"normal", {{{"R", "G", "B"}, &picture}}},
                                           {"reflection", {{{"R", "G", "B"}, &picture}}}};
    write_exr_parts(file, frame, parts, PixelType::half, {{kFactorsAttribute, header}});
}

TEST(FactorsFile, GivesBackWhatWasWritten) {
    const Scratch scratch;
    for (const Parametrization& parametrization : parametrizations())
        for (const Mapping sphere : {Mapping::double_parabolic, Mapping::cube})
            for (const int terms : {1, 2}) {
                const StoredFactors stored = numbered_factors(parametrization, sphere, terms);
                write_factors(scratch.file("maps.exr"), stored);
                expect_equal(read_factors(scratch.file("maps.exr")), stored);
            }
}

TEST(FactorsFile, KeepsTexelsBeyondHalves) {
    const Scratch scratch;
    StoredFactors stored = numbered_factors(parametrization_by_name("nr"), Mapping::cube);
    stored.factors.terms[0][1].texels[5] = Color3f(1e6f, 0, 0);
    write_factors(scratch.file("maps.exr"), stored);
    expect_equal(read_factors(scratch.file("maps.exr")), stored);
}

TEST(FactorsFile, EvaluatesInTheWorld) {
    StoredFactors stored = numbered_factors(parametrization_by_name("nr"), Mapping::cube);
    const DirectionPair pair{Vec3f(0, 0, 1), Vec3f(0.6f, 0, 0.8f)};
    const Color3f turned = stored.factors({pair.a * stored.world_to_map, pair.b * stored.world_to_map});
    EXPECT_EQ(stored(pair), turned * stored.gain);
    StoredFactors brdf = numbered_factors(parametrization_by_name("hd"), Mapping::cube);
    EXPECT_EQ(brdf(pair), brdf.factors(pair) * brdf.gain);
}

TEST(FactorsFile, RefusesHeadersThatCannotBe) {
    const Scratch scratch;
    const Image picture(16, 8, 3, 1);
    const std::string file = scratch.file("maps.exr");
    const json good = factors_to_json(numbered_factors(parametrization_by_name("nr"), Mapping::double_parabolic));
    write_with_header(file, good.dump(), picture);
    EXPECT_EQ(refusal(file), "");
    const std::pair<json, std::string> changes[] = {{{{"format", 2}}, "format"},
                                                    {{{"parametrization", "nrx"}}, "nrx"},
                                                    {{{"parametrization", "nrv"}}, "factors"},
                                                    {{{"of", "brdf"}}, "of"},
                                                    {{{"terms", 1000}}, "terms"},
                                                    {{{"dominant", {0, 0, 3}}}, "dominant"},
                                                    {{{"world_to_map", {{1, 0, 0}, {1, 0, 0}, {0, 0, 1}}}}, "world_to_map"},
                                                    {{{"reflection_curve", {1, 2}}}, "reflection_curve"},
                                                    {{{"gain", -1}}, "gain"},
                                                    {{{"maps", json::array()}}, "maps"},
                                                    {{{"extra", 1}}, "extra"}};
    for (const auto& [change, field] : changes) {
        json header = good;
        header.update(change);
        write_with_header(file, header.dump(), picture);
        EXPECT_NE(refusal(file).find(field), std::string::npos) << change << ": " << refusal(file);
    }
    for (const auto& [key, value] : std::map<std::string, json>{{"size", 1000000}, {"mapping", "parabolic"}, {"name", "n"}}) {
        json header = good;
        header["maps"][0][key] = value;
        write_with_header(file, header.dump(), picture);
        EXPECT_NE(refusal(file).find("maps[0]." + key), std::string::npos) << refusal(file);
    }
    write_with_header(file, "{", picture);
    EXPECT_NE(refusal(file).find("not valid JSON"), std::string::npos);
}

TEST(FactorsFile, RefusesMapsThatAreNotThere) {
    const Scratch scratch;
    const std::string file = scratch.file("maps.exr");
    const auto write = [&](const char* parametrization, const Image& picture) {
        const StoredFactors stored = numbered_factors(parametrization_by_name(parametrization), Mapping::double_parabolic);
        write_with_header(file, factors_to_json(stored).dump(), picture);
    };
    write("nr", Image(8, 8, 3, 1));
    EXPECT_NE(refusal(file).find("16x8"), std::string::npos) << refusal(file);
    write("nr", Image(16, 8, 3, std::numeric_limits<float>::quiet_NaN()));
    EXPECT_NE(refusal(file).find("no numbers"), std::string::npos) << refusal(file);
    write("nrv", Image(16, 8, 3, 1));
    EXPECT_NE(refusal(file).find("the map view"), std::string::npos) << refusal(file);
    EXPECT_NE(refusal(scratch.file("absent.exr")), "");
}

TEST(FactorsFile, SurvivesDamage) {
    const Scratch scratch;
    write_factors(scratch.file("whole.exr"), numbered_factors(parametrization_by_name("nr"), Mapping::double_parabolic));
    std::ifstream stream(scratch.file("whole.exr"), std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(stream), {}};
    const auto read_changed = [&](const std::string& bytes) {
        std::ofstream(scratch.file("damaged.exr"), std::ios::binary) << bytes;
        return refusal(scratch.file("damaged.exr"));
    };
    for (size_t length = 0; length < whole.size(); length += whole.size() / 10)
        EXPECT_NE(read_changed(whole.substr(0, length)), "") << length;
    for (size_t at = 0; at < whole.size();
         at += whole.size() / 24) {  // some bytes matter to nobody: no more than no crash is promised
        std::string bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ 0xff);
        EXPECT_LT(read_changed(bytes).size(), 2000u);
    }
}

TEST(FactorsFile, IsAnExr) {
    const Scratch scratch;
    EXPECT_THROW(write_factors(scratch.file("maps.png"), numbered_factors(parametrization_by_name("nr"), Mapping::cube)),
                 Error);
    EXPECT_EQ(scratch.file_count(), 0u);
}

}  // namespace
}  // namespace burnish
