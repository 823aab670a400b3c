// The ladder of sample counts: ascending, complete, and the rung asked for.
#include <burnish/sampling/sample_ladder.h>

#include <gtest/gtest.h>

using namespace burnish;

TEST(SampleLadder, ClimbsToTheMostByTwoThirds) {
    for (const int most : {1, 4, 5, 7, 19, 38, 64, 300}) {
        const std::vector<int> ladder = sample_ladder(most);
        EXPECT_EQ(ladder.back(), most);
        EXPECT_EQ(ladder.front(), std::min(most, kFewestLookups));
        for (size_t i = 1; i < ladder.size(); ++i) {
            EXPECT_LT(ladder[i - 1], ladder[i]) << most;
            EXPECT_LE(ladder[i], 2 * ladder[i - 1]) << most;
        }
    }
}

TEST(SampleLadder, GivesAsManyAsTheDeviationAsksFor) {
    const std::vector<int> ladder = sample_ladder(38);
    EXPECT_EQ(ladder_rung(ladder, 0, 4), 0u);
    EXPECT_EQ(ladder_rung(ladder, 4, 4), ladder.size() - 1);
    EXPECT_EQ(ladder_rung(ladder, 1e9f, 4), ladder.size() - 1);
    for (float deviation = 0; deviation < 4; deviation += 0.1f) {
        const size_t rung = ladder_rung(ladder, deviation, 4);
        const float wanted = 38 * deviation / 4;
        EXPECT_GE(static_cast<float>(ladder[rung]), wanted * 0.83f);
        if (rung > 0) {
            EXPECT_LT(static_cast<float>(ladder[rung - 1]), wanted);
        }
    }
}
