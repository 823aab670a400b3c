#include <burnish/base/error.h>
#include <burnish/input/assign.h>
#include <burnish/input/cryptomatte.h>

#include <gtest/gtest.h>

#include <bit>

using namespace burnish;

namespace {

Cryptomatte cryptomatte(const std::string& name, const std::vector<std::pair<std::string, float>>& first_rank,
                        const std::vector<std::pair<std::string, float>>& second_rank) {
    Cryptomatte result;
    result.name = name;
    for (const auto& entries : {first_rank, second_rank}) {
        Image rank(static_cast<int>(entries.size()), 1, 2);
        for (size_t i = 0; i < entries.size(); ++i) {
            const auto& [object, coverage] = entries[i];
            rank.at(i)[0] = object.empty() ? 0 : std::bit_cast<float>(cryptomatte_id(object));
            rank.at(i)[1] = coverage;
            if (!object.empty()) result.manifest[object] = cryptomatte_id(object);
        }
        result.ranks.push_back(rank);
    }
    return result;
}

/// Four pixels: ball; ball .6 and table .4; table; table .3 and nothing.
AovFrame frame() {
    AovFrame result;
    result.file = "shot.exr";
    result.data_window = {0, 0, 4, 1};
    result.cryptomattes = {cryptomatte("ViewLayer.CryptoObject", {{"ball", 1}, {"ball", .6f}, {"table", 1}, {"table", .3f}},
                                       {{"", 0}, {"table", .4f}, {"", 0}, {"", 0}}),
                           cryptomatte("ViewLayer.CryptoMaterial", {{"brass", 1}, {"brass", .6f}, {"wood", 1}, {"wood", .3f}},
                                       {{"", 0}, {"wood", .4f}, {"", 0}, {"", 0}})};
    result.layers[Role::object_id] = Image(4, 1, 1);
    result.layers[Role::object_id].data = {7, 7, 3, 3};
    result.layers[Role::material_id] = Image(4, 1, 1);
    result.layers[Role::material_id].data = {1, 1, 1, 2};
    return result;
}

AssignRule named(const std::string& pattern) { return {"m", {}, {}, pattern}; }
AssignRule object(int index) { return {"m", index, {}, ""}; }

void expect_assignment(const std::vector<AssignRule>& rules, const PixelVector<int16_t>& rule,
                       const std::vector<float>& coverage) {
    const Assignment found = assign_rules(frame(), rules);
    EXPECT_EQ(found.rule, rule);
    ASSERT_EQ(found.coverage.size(), coverage.size());
    for (size_t i = 0; i < coverage.size(); ++i) EXPECT_FLOAT_EQ(found.coverage[i], coverage[i]) << i;
    std::vector<size_t> counts(rules.size());
    for (int16_t r : rule)
        if (r >= 0) ++counts[static_cast<size_t>(r)];
    EXPECT_EQ(found.counts, counts);
}

std::string complaint(const AovFrame& f, const AssignRule& rule) {
    try {
        assign_rules(f, {rule});
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::missing_channel);
        return error.what();
    }
    return {};
}

}  // namespace

TEST(AssignRules, TakesTheWholeFrameWithoutASelector) { expect_assignment({{"m", {}, {}, ""}}, {0, 0, 0, 0}, {1, 1, 1, 1}); }

TEST(AssignRules, SelectsByIndex) {
    expect_assignment({object(7)}, {0, 0, -1, -1}, {1, 1, 0, 0});
    expect_assignment({{"m", {}, 2, ""}}, {-1, -1, -1, 0}, {0, 0, 0, 1});
}

TEST(AssignRules, SelectsByCryptomatteWithItsCoverage) {
    expect_assignment({named("ball")}, {0, 0, -1, -1}, {1, .6f, 0, 0});
    expect_assignment({named("*")}, {0, 0, 0, 0}, {1, 1, 1, .3f});
}

TEST(AssignRules, SelectsWhatAllSelectorsOfARuleSelect) {
    expect_assignment({{"m", 3, 2, "table"}}, {-1, -1, -1, 0}, {0, 0, 0, .3f});
}

TEST(AssignRules, LetsTheLastRuleTakeAnObject) {
    expect_assignment({named("*"), named("ball")}, {1, 1, 0, 0}, {1, .6f, 1, .3f});
    expect_assignment({named("ball"), named("*")}, {1, 1, 1, 1}, {1, 1, 1, .3f});
}

TEST(AssignRules, GivesAnEdgePixelToWhatCoversMostOfIt) {
    expect_assignment({named("ball"), named("table")}, {0, 0, 1, 1}, {1, .6f, 1, .3f});
    expect_assignment({{"m", {}, {}, ""}, named("table")}, {0, 0, 1, 0}, {1, .6f, 1, .7f});
}

TEST(AssignRules, LooksInTheCryptomatteThatListsTheName) {
    expect_assignment({named("brass")}, {0, 0, -1, -1}, {1, .6f, 0, 0});
    expect_assignment({named("CryptoMaterial:w*")}, {-1, 0, 0, 0}, {0, .4f, 1, .3f});
    expect_assignment({named("ViewLayer.CryptoObject:wood")}, {-1, -1, -1, -1}, {0, 0, 0, 0});
}

TEST(AssignRules, FindsNamesByHashWhenNoManifestListsThem) {
    AovFrame bare = frame();
    bare.cryptomattes[0].manifest.clear();
    EXPECT_EQ(assign_rules(bare, {named("table")}).rule, (PixelVector<int16_t>{-1, 0, 0, 0}));
    EXPECT_THROW(assign_rules(bare, {named("tab*")}), Error);
}

TEST(AssignRules, SaysWhichIdsAreMissing) {
    AovFrame bare = frame();
    bare.layers.clear();
    bare.cryptomattes.clear();
    EXPECT_NE(complaint(bare, object(3)).find("shot.exr: assign[0] (material m) needs an object index layer"),
              std::string::npos);
    EXPECT_NE(complaint(bare, {"m", {}, 3, ""}).find("IndexMA"), std::string::npos);
    EXPECT_NE(complaint(bare, named("x")).find("needs a cryptomatte"), std::string::npos);
}
