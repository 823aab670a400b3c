// Two terms over elevation in the basis of two views.
#include <burnish/factor/tell_by_views.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace burnish {
namespace {

/// A sum of two products with signs: what one sees from above (`difference` = 0) and another light nearer the horizon.
Factors two_terms(float difference) {
    Factors factors = uniform_factors(parametrization_by_name("re"), Mapping::cube, 16);
    factors.terms.push_back(factors.terms[0]);
    for (int texel = 0; texel < factors.terms[0][0].layout.texels(); ++texel) {
        const Vec3f d = factors.terms[0][0].layout.direction(texel);
        const float above = 2 + d.x, horizon = above + difference * (1.5f + d.y - d.x);
        factors.terms[0][0].texels[texel] = Color3f(0.5f * (above + horizon));
        factors.terms[1][0].texels[texel] = Color3f(horizon - above);
    }
    for (int texel = 0; texel < 16; ++texel) {
        const float z = static_cast<float>(texel) / 15;
        factors.terms[0][1].texels[texel] = Color3f(1.2f - 0.2f * z),
        factors.terms[1][1].texels[texel] = Color3f(0.6f * (0.5f - z));
    }
    return factors;
}

float least(const Factors& factors) {
    float found = 1;
    for (const FactorTerm& term : factors.terms)
        for (const FactorMap& map : term)
            for (const Color3f& texel : map.texels) found = std::min(found, texel.x);
    return found;
}

class TellByViews : public testing::TestWithParam<float> {};

TEST_P(TellByViews, KeepsTheFunctionWithoutSigns) {
    const Factors before = two_terms(GetParam());
    Factors after = before;
    tell_by_views(after);
    EXPECT_LT(least(before), GetParam() > 0 ? 0 : 1);
    EXPECT_GE(least(after), -0.08f);  // a fifteenth: the row goes on by a texel beyond the view near the horizon
    for (int i = 0; i < 200; ++i) {
        const float z = 0.01f + 0.0049f * static_cast<float>(i), s = std::sqrt(1 - z * z), phi = 0.7f * static_cast<float>(i);
        const DirectionPair pair{Frame::around(Vec3f(s * std::cos(phi), z, s * std::sin(phi))).n, {0, 1, 0}};
        EXPECT_NEAR(after(pair).x / before(pair).x, 1, 0.01f) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(, TellByViews, testing::Values(1.0f, 0.03f, 0.0f));

TEST(TermsByViews, ShowsTheLightFromAbove) {
    Factors factors = two_terms(1);
    const Factors before = factors;
    tell_by_views(factors);
    const Vec3f up(0, 0, 1);
    EXPECT_NEAR(factors.terms[0][0].lookup(up).x, before({up, up}).x, 0.02f);
}

TEST(TermsByViews, LeavesOthersAsTheyAre) {
    Factors factors = two_terms(1);
    factors.terms.resize(1);
    const std::vector<Color3f> texels = factors.terms[0][0].texels;
    tell_by_views(factors);
    EXPECT_EQ(factors.terms[0][0].texels, texels);
}

}  // namespace
}  // namespace burnish
