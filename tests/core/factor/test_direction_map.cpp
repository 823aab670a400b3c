// The mappings of directions: inverses, Jacobians, seams.
#include <burnish/base/error.h>
#include <burnish/factor/direction_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace burnish {
namespace {

class EveryMapping : public testing::TestWithParam<Mapping> {};
class FullMapping : public testing::TestWithParam<Mapping> {};  // of both angles

/// A golden spiral over the sphere, or its upper half.
std::vector<Vec3f> directions(int count, bool whole_sphere) {
    std::vector<Vec3f> all;
    for (int i = 0; i < count; ++i) {
        const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(count),
                    z = whole_sphere ? 1 - 2 * share : 1 - share;
        const float phi = 2.39996323f * static_cast<float>(i), r = std::sqrt(1 - z * z);
        all.emplace_back(r * std::cos(phi), r * std::sin(phi), z);
    }
    return all;
}

Vec3f blended_direction(const DirectionMap& map, const BlendedTexels& blend) {
    Vec3f sum(0, 0, 0);
    for (int i = 0; i < 4; ++i) sum += map.direction(blend.texel[i]) * blend.weight[i];
    return sum / sum.length();
}

TEST_P(EveryMapping, GivesDirectionsBackAtTexelMiddles) {
    const DirectionMap map(GetParam(), 16);
    for (int texel = 0; texel < map.texels(); ++texel) {
        if (!map.holds(texel)) continue;
        const MapPlace place = map.place(map.direction(texel));
        EXPECT_NEAR(place.x, static_cast<float>(texel % map.width()) + 0.5f, 1e-3f) << texel;
        EXPECT_NEAR(place.y, static_cast<float>(texel / map.width()) + 0.5f, 1e-3f) << texel;
    }
}

TEST_P(FullMapping, BlendsTexelsAroundTheDirection) {
    const DirectionMap map(GetParam(), 64);
    const bool steep = GetParam() == Mapping::hemispherical;  // texels are long where it nears the horizon
    for (const Vec3f& d : directions(2000, map.is_whole_sphere())) {
        if (steep && d.z < 0.3f) continue;
        const BlendedTexels blend = map.lookup(d);
        EXPECT_NEAR(std::accumulate(blend.weight.begin(), blend.weight.end(), 0.0f), 1, 1e-5f);
        EXPECT_GT(blended_direction(map, blend).dot(d), std::cos(0.02f)) << d;
    }
}

TEST_P(EveryMapping, CoversItsDirectionsOnce) {
    const DirectionMap map(GetParam(), 128);
    double sum = 0, moment = 0;  // of z over the upper half: pi
    for (int texel = 0; texel < map.texels(); ++texel) {
        sum += map.solid_angle(texel);
        moment += map.solid_angle(texel) * std::max(map.direction(texel).z, 0.0f);
    }
    const double all = (map.is_whole_sphere() ? 4 : 2) * std::numbers::pi;
    const bool ends = GetParam() != Mapping::hemispherical;  // its Jacobian has no end at the horizon
    EXPECT_TRUE(!ends || std::fabs(sum / all - 1) < 0.01) << sum / all;
    EXPECT_NEAR(moment / std::numbers::pi, 1, 0.01);
}

TEST_P(FullMapping, IsContinuousAcrossSeams) {
    const DirectionMap map(GetParam(), 32);
    std::vector<float> texels(map.texels());
    const auto value = [](const Vec3f& d) { return d.x + 0.5f * d.y - 0.7f * d.z + d.x * d.y; };
    for (int texel = 0; texel < map.texels(); ++texel) texels[texel] = value(map.direction(texel));
    for (const DirectionMap::Seam& seam : map.seams()) {
        float repeated = 0;
        for (int i = 0; i < 4; ++i) repeated += seam.repeats.weight[i] * texels[seam.repeats.texel[i]];
        EXPECT_NEAR(repeated, texels[seam.texel], 0.02f);
    }
    const auto read = [&](const Vec3f& d) {
        const BlendedTexels blend = map.lookup(d);
        float sum = 0;
        for (int i = 0; i < 4; ++i) sum += blend.weight[i] * texels[blend.texel[i]];
        return sum;
    };
    for (const Vec3f& d : directions(4000, map.is_whole_sphere())) {
        if (GetParam() == Mapping::hemispherical && d.z < 0.4f) continue;
        EXPECT_NEAR(read(d), value(d), 0.03f) << d;
    }
}

TEST_P(EveryMapping, KeepsLookupsInside) {
    const DirectionMap map(GetParam(), 8);
    for (const Vec3f& d : directions(500, true))
        for (const int texel : map.lookup(d).texel) {
            EXPECT_GE(texel, 0);
            EXPECT_LT(texel, map.texels());
        }
}

TEST_P(EveryMapping, NamesNeighboursBothWays) {
    const DirectionMap map(GetParam(), 8);
    for (int texel = 0; texel < map.texels(); ++texel)
        for (const int other : map.neighbours(texel)) {
            const std::vector<int> back = map.neighbours(other);
            EXPECT_NE(std::ranges::find(back, texel), back.end()) << texel << " " << other;
        }
}

TEST_P(EveryMapping, HasAName) { EXPECT_EQ(mapping_by_name(mapping_name(GetParam())), GetParam()); }

constexpr auto kName = [](const testing::TestParamInfo<Mapping>& info) { return std::string(mapping_name(info.param)); };

INSTANTIATE_TEST_SUITE_P(, EveryMapping,
                         testing::Values(Mapping::hemispherical, Mapping::parabolic, Mapping::double_parabolic, Mapping::cube,
                                         Mapping::elevation),
                         kName);
INSTANTIATE_TEST_SUITE_P(, FullMapping,
                         testing::Values(Mapping::hemispherical, Mapping::parabolic, Mapping::double_parabolic, Mapping::cube),
                         kName);

TEST(DirectionMap, OfElevationsIsLinearInTheCosine) {
    const DirectionMap map(Mapping::elevation, 9);
    EXPECT_EQ(map.texels(), 9);
    const BlendedTexels blend = map.lookup({0.6f, -0.8f * std::sqrt(1 - 0.3f * 0.3f / 0.64f), 0.3f});
    float z = 0;
    for (int i = 0; i < 4; ++i) z += blend.weight[i] * map.direction(blend.texel[i]).z;
    EXPECT_NEAR(z, 0.3f, 1e-6f);
}

TEST(DirectionMap, RefusesWhatCannotBe) {
    EXPECT_THROW(DirectionMap(Mapping::cube, 3), Error);
    EXPECT_THROW(DirectionMap(Mapping::cube, 100000), Error);
    EXPECT_THROW(mapping_by_name("octahedral"), Error);
}

}  // namespace
}  // namespace burnish
