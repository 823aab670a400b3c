#include <burnish/base/nearest_name.h>

#include <gtest/gtest.h>

#include <array>

namespace burnish {

constexpr std::array<std::string_view, 4> kKnown{"roughness", "rotation_deg", "r0", "tint"};

TEST(NearestName, FindsMistypedNames) {
    EXPECT_EQ(nearest_name("rougness", kKnown), "roughness");    // dropped
    EXPECT_EQ(nearest_name("roughnness", kKnown), "roughness");  // doubled
    EXPECT_EQ(nearest_name("ruoghness", kKnown), "roughness");   // swapped
    EXPECT_EQ(nearest_name("ROUGHNESS", kKnown), "roughness");   // shouted
    EXPECT_EQ(nearest_name("tnit", kKnown), "tint");
}

TEST(NearestName, HasNoOpinionOnStrangers) {
    EXPECT_EQ(nearest_name("colour", kKnown), "");
    EXPECT_EQ(nearest_name("", kKnown), "");
    EXPECT_EQ(nearest_name(std::string(100000, 'r'), kKnown), "");
    EXPECT_EQ(did_you_mean("colour", kKnown), "");
}

TEST(NearestName, ReadsAsPartOfASentence) { EXPECT_EQ(did_you_mean("tin", kKnown), " (did you mean \"tint\"?)"); }

}  // namespace burnish
