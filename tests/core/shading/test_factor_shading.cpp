// The kernel of factored maps against Factors::operator(), for every parametrisation, mapping and instruction set.
#include "core/light/light_pictures.h"
#include "core/scenes.h"
#include "core/simd_targets.h"

#include <burnish/base/error.h>
#include <burnish/shading/factor_shading.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace burnish;
using burnish_test::Directions;

namespace {

/// Maps of noise: no two texels are alike, and terms after the first have both signs.
Factors noise(const Parametrization& parametrization, Mapping sphere, int size, int terms) {
    Directions random;
    Factors factors = uniform_factors(parametrization, sphere, size);
    static const FactorGuide rough = FactorGuide::of({"rough", Color3f(0), {scenes::lobe_of(ModelId::ggx, 0.4f, 0.4f)}});
    factors.guide = rough;
    factors.guide.dominant = Vec3f(2, -1, 2) / 3.0f;
    factors.terms.resize(static_cast<size_t>(terms), factors.terms[0]);
    for (size_t term = 0; term < factors.terms.size(); ++term)
        for (FactorMap& map : factors.terms[term])
            for (Color3f& texel : map.texels)
                for (int k = 0; k < 3; ++k) texel[k] = random.uniform() - (term > 0 ? 0.5f : 0.0f);
    return factors;
}

/// Normals all around with views above them, some at the horizon, along the normal and along the axes.
SurfaceBatch all_around(int count, const Matrix33f& light_to_world) {
    Directions random(3);
    SurfaceBatch batch;
    for (int i = 0; i < count; ++i) {
        Vec3f n = random.next(), wo = random.next();
        if (i % 7 == 0) n = Vec3f(0, 0, i % 2 ? 1.0f : -1.0f);
        if (i % 11 == 0) wo = n;
        if (n.dot(wo) < 0) wo = -wo;
        batch.pixel.push_back(static_cast<uint32_t>(i)), batch.n.push_back(n * light_to_world),
            batch.wo.push_back(wo * light_to_world);
    }
    return batch;
}

const Matrix33f kTurned{0, 1, 0, 0, 0, 1, -1, 0, 0};  // a flip, too

std::vector<Color3f> shaded(const Factors& factors, const SurfaceBatch& batch) {
    std::vector<Color3f> radiance(batch.size());
    FactorShading(factors).shade(batch, kTurned, radiance);
    return radiance;
}

void expect_as_the_factors_say(const Factors& factors, const std::string& what) {
    const SurfaceBatch batch = all_around(501, kTurned.transposed());
    const std::vector<Color3f> found = shaded(factors, batch);
    for (size_t i = 0; i < batch.size(); ++i) {
        const Color3f expected = factors({batch.n[i] * kTurned, batch.wo[i] * kTurned});
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(found[i][k], expected[k], 1e-3f) << what << ", pixel " << i;
    }
}

}  // namespace

TEST(FactorShading, IsWhatTheFactorsSay) {
    burnish_test::for_each_target([] {
        for (const Parametrization& parametrization : parametrizations())
            for (const Mapping sphere : {Mapping::double_parabolic, Mapping::cube, Mapping::hemispherical, Mapping::parabolic})
                if (parametrization.of == FactoredFunction::lighting)
                    expect_as_the_factors_say(noise(parametrization, sphere, 9, 1),
                                              parametrization.name + " " + std::string(mapping_name(sphere)));
    });
}

TEST(FactorShading, AddsUpSignedTermsAndCutsOffBelowZero) {
    const Factors factors = noise(parametrization_by_name("nr"), Mapping::double_parabolic, 8, 3);
    expect_as_the_factors_say(factors, "three terms");
    EXPECT_EQ(FactorShading(factors).lookup_count(), 6);
    const std::vector<Color3f> found = shaded(factors, all_around(500, kTurned.transposed()));
    EXPECT_TRUE(std::ranges::any_of(found, [](const Color3f& c) { return c.x == 0; }));
}

/// A direction of a parametrisation that the kernel knows nothing of.
TEST(FactorShading, TakesDirectionsOfItsOwn) {
    static const ProjectedDirection kBetween{
        "between",
        FactoredFunction::lighting,
        DirectionDomain::sphere,
        false,
        [](const DirectionPair& p, const FactorGuide&) { return (p.a + p.b).normalized(); },
        "normalize(n + wo)"};
    const Parametrization own{"own", "", FactoredFunction::lighting, {{&kBetween, 0}, {&kBetween, 0}}};
    expect_as_the_factors_say(noise(own, Mapping::double_parabolic, 8, 1), "own");
}

TEST(FactorShading, GivesTheSameBitsInAnyBatch) {
    const Factors factors = noise(parametrization_by_name("nrhd"), Mapping::cube, 8, 1);
    const SurfaceBatch batch = all_around(203, kTurned.transposed());
    const std::vector<Color3f> together = shaded(factors, batch);
    for (size_t i = 0; i < batch.size(); ++i) {
        SurfaceBatch one;
        one.pixel.push_back(0), one.n.push_back(batch.n[i]), one.wo.push_back(batch.wo[i]);
        EXPECT_EQ(shaded(factors, one)[0], together[i]) << i;
    }
}

TEST(FactorShading, RefusesABrdf) {
    EXPECT_THROW(FactorShading{uniform_factors(parametrization_by_name("pqp"), Mapping::double_parabolic, 8)}, Error);
}
