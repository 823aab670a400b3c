// Parametrisations as data: what every row promises.
#include <burnish/base/error.h>
#include <burnish/factor/factors.h>

#include <gtest/gtest.h>

namespace burnish {
namespace {

/// Random unit vectors, those of a BRDF above the surface.
std::vector<DirectionPair> pairs(FactoredFunction of, int count) {
    std::vector<DirectionPair> all;
    uint32_t state = 1;
    const auto next = [&] { return static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0f; };
    const auto direction = [&](float least) {
        const float z = least + (1 - least) * next(), phi = 2 * kPi * next(), r = std::sqrt(std::max(1 - z * z, 0.0f));
        return Vec3f(r * std::cos(phi), r * std::sin(phi), z);
    };
    while (static_cast<int>(all.size()) < count) {
        const float least = of == FactoredFunction::brdf ? 0.0f : -1.0f;
        const DirectionPair pair{direction(least), direction(least)};
        if (of == FactoredFunction::brdf || pair.a.dot(pair.b) > 0) all.push_back(pair);
    }
    return all;
}

TEST(Parametrization, ProjectsToUnitVectorsWhereTheMapsAre) {
    FactorGuide guide;
    guide.dominant = Vec3f(1, 2, 3) / std::sqrt(14.0f);
    for (const ProjectedDirection& direction : projected_directions())
        for (const DirectionPair& pair : pairs(direction.of, 500)) {
            const Vec3f d = direction.project(pair, guide);
            EXPECT_NEAR(d.length(), 1, 1e-4f) << direction.name;
            EXPECT_TRUE(direction.domain == DirectionDomain::sphere || d.z >= -1e-4f) << direction.name;
        }
}

TEST(Parametrization, HalfAndDifferenceTellThePair) {
    for (const DirectionPair& pair : pairs(FactoredFunction::brdf, 200)) {
        const Parametrization& hd = parametrization_by_name("hd");
        const Vec3f h = hd.factors[0].direction->project(pair, {}), d = hd.factors[1].direction->project(pair, {});
        const Vec3f wi = Frame::along(h, {1, 0, 0}).to_world(d);
        EXPECT_LT((wi - pair.a).length(), 1e-4f);
        EXPECT_LT((h * (2 * h.dot(wi)) - wi - pair.b).length(), 1e-4f);
    }
}

TEST(Parametrization, SeesOneLightTheSameFromAllSides) {
    // Turned about the light, an isotropic surface lit by it alone looks the same: so do the dominant directions.
    FactorGuide guide;
    const Vec3f dominant = guide.dominant = Vec3f(2, -1, 2) / 3.0f;
    const auto turned = [&](const Vec3f& v, float angle) {
        return v * std::cos(angle) + dominant.cross(v) * std::sin(angle) + dominant * (dominant.dot(v) * (1 - std::cos(angle)));
    };
    for (const Factor& factor : parametrization_by_name("nrhd").factors) {
        if (!factor.direction->needs_dominant) continue;
        for (const DirectionPair& pair : pairs(FactoredFunction::lighting, 100)) {
            if (std::fabs(pair.a.dot(dominant)) > 0.99f || pair.b.dot(dominant) < -0.9f) continue;
            const Vec3f d = factor.direction->project(pair, guide);
            const Vec3f other = factor.direction->project({turned(pair.a, 1), turned(pair.b, 1)}, guide);
            EXPECT_LT((d - other).length(), 1e-3f) << factor.direction->name;
        }
    }
}

TEST(Parametrization, CountsMapsAndTheirUses) {
    const Parametrization& pqp = parametrization_by_name("pqp");
    EXPECT_EQ(pqp.map_count(), 2);
    EXPECT_EQ(pqp.uses(0), 2);
    EXPECT_EQ(pqp.uses(1), 1);
    EXPECT_TRUE(parametrization_by_name("nrhd").needs_dominant());
    EXPECT_FALSE(parametrization_by_name("nrv").needs_dominant());
    EXPECT_THROW(parametrization_by_name("nvr2"), Error);
}

TEST(Factors, MultiplyTheirLookups) {
    for (const Parametrization& parametrization : parametrizations()) {
        Factors factors = uniform_factors(parametrization, Mapping::cube, 8, Color3f(2, 1, 0.5f));
        const float count = static_cast<float>(parametrization.factors.size());
        for (const DirectionPair& pair : pairs(parametrization.of, 20)) {
            EXPECT_NEAR(factors(pair).x, std::pow(2.0f, count), 1e-3f);
            EXPECT_NEAR(factors(pair).z, std::pow(0.5f, count), 1e-3f);
        }
        factors.terms.push_back(uniform_factors(parametrization, Mapping::cube, 8, Color3f(-100, -1, 0)).terms[0]);
        EXPECT_GE(factors(pairs(parametrization.of, 1)[0]).x, 0) << parametrization.name;
    }
}

}  // namespace
}  // namespace burnish
