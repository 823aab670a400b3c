#include "core/scenes.h"

#include <burnish/base/parallel.h>
#include <burnish/output/compare.h>
#include <burnish/shading/shading_plan.h>
#include <burnish/shading/sparse.h>
#include <burnish/shading/upsample.h>

#include <gtest/gtest.h>

#include <random>

using namespace burnish;

namespace {

/// A frame with all that sparse shading needs of it; materials are lobes of width m, one a rule.
struct Shot {
    Shot(AovFrame own_frame, Assignment own_assignment, const Environment& light, const std::vector<LobeParameters>& lobes,
         float safety = 1)
        : frame(std::move(own_frame)), assignment(std::move(own_assignment)), surfaces(frame, assignment, {}) {
        for (const LobeParameters& lobe : lobes) {
            const Material material{"test", Color3f(0, 0, 0), {lobe}};
            shaders.emplace_back(material, light, EstimatorSettings{});
            predictors.emplace_back(material, light,
                                    DensitySettings{ShadingDensity::sparse, PredictionKind::curvature, 0, safety});
        }
    }

    ShadedFrame dense() const { return shade_dense(surfaces, assignment, shaders, {}); }
    ShadedFrame sparse() const { return shade_sparse(frame, surfaces, assignment, shaders, predictors, {}, true); }
    Image valid() const {
        Image mask(assignment.width, assignment.height, 1);
        for (size_t i = 0; i < mask.pixel_count(); ++i) mask.data[i] = surfaces.validity(i) == Validity::valid;
        return mask;
    }

    AovFrame frame;
    Assignment assignment;
    Surfaces surfaces;
    std::vector<MaterialShader> shaders;
    std::vector<BandwidthPredictor> predictors;
};

size_t shaded_pixels(const ShadedFrame& frame) {
    return static_cast<size_t>(std::ranges::count_if(frame.samples.data, [](float n) { return n > 0; }));
}

/// Vertical stripes, each of one rule.
Assignment stripes(const AovFrame& frame, int rules, int width) {
    Assignment assignment = scenes::whole_frame(frame);
    for (size_t i = 0; i < assignment.rule.size(); ++i)
        assignment.rule[i] = static_cast<int16_t>(i % static_cast<size_t>(assignment.width) / static_cast<size_t>(width) %
                                                  static_cast<size_t>(rules));
    assignment.counts.assign(static_cast<size_t>(rules), assignment.rule.size() / static_cast<size_t>(rules));
    return assignment;
}

Environment stress() { return Environment::from_image(scenes::stress_light(3), {}, "stress"); }

TEST(Sparse, FewPixelsComeNearToAll) {
    const Environment light = stress();
    AovFrame frame = scenes::sphere_in_frame(640, 480, 220);
    for (const float m : {0.05f, 0.1f, 0.3f}) {
        const Shot shot(frame, scenes::whole_frame(frame), light, {scenes::lobe_of(ModelId::beckmann, m, m)});
        const ShadedFrame dense = shot.dense(), sparse = shot.sparse();
        const Image mask = shot.valid();
        EXPECT_GT(compare_images(sparse.overlay, dense.overlay, &mask).display_psnr_db, 45) << m;
        EXPECT_LT(static_cast<double>(shaded_pixels(sparse)), 0.35 * static_cast<double>(shot.surfaces.counts()[0])) << m;
        EXPECT_LT(sparse.lookups, 0.35 * dense.lookups);
    }
}

TEST(Sparse, MoreSafetyIsNearerAndShadesMore) {
    const Environment light = stress();
    const AovFrame frame = scenes::sphere_in_frame(480, 480, 220);
    double db = 0;
    size_t pixels = 0;
    for (const float safety : {0.5f, 1.0f, 2.0f, 4.0f}) {
        const Shot shot(frame, scenes::whole_frame(frame), light, {scenes::lobe_of(ModelId::ggx, 0.2f, 0.2f)}, safety);
        const ShadedFrame sparse = shot.sparse();
        const Image mask = shot.valid();
        const double own = compare_images(sparse.overlay, shot.dense().overlay, &mask).display_psnr_db;
        EXPECT_GT(own, db) << safety;
        EXPECT_GT(shaded_pixels(sparse), pixels) << safety;
        db = own, pixels = shaded_pixels(sparse);
    }
}

/// Shaded pixels are what dense shading makes of them, background stays empty, and every valid pixel gets its light.
TEST(Sparse, ShadedPixelsAreExactAndNoneIsLeftOut) {
    const Environment light = Environment::from_image(scenes::constant_light(1), {}, "constant");
    const AovFrame frame = scenes::sphere_in_frame(333, 215, 90);
    const Shot shot(frame, scenes::whole_frame(frame), light, {scenes::lobe_of(ModelId::beckmann, 0.2f, 0.2f)});
    const ShadedFrame dense = shot.dense(), sparse = shot.sparse();
    for (size_t i = 0; i < dense.overlay.pixel_count(); ++i) {
        const bool is_exact = shot.surfaces.validity(i) != Validity::valid || *sparse.samples.at(i) > 0;
        EXPECT_NEAR(sparse.overlay.at(i)[1], dense.overlay.at(i)[1], is_exact ? 0 : 0.02f * dense.overlay.at(i)[1]);
    }
}

/// A black lobe beside a bright one, in stripes of any width: none of either's light on the other side.
TEST(Sparse, NothingLeaksOverMaterials) {
    const Environment light = Environment::from_image(scenes::constant_light(1), {}, "constant");
    const AovFrame frame = scenes::covered_frame(200, 120);
    LobeParameters black = scenes::lobe_of(ModelId::ggx, 0.3f, 0.3f), bright = black;
    black.strength = 0;
    for (const int width : {1, 2, 3, 7, 16, 50}) {
        const Shot shot(frame, stripes(frame, 2, width), light, {black, bright});
        const ShadedFrame sparse = shot.sparse();
        for (size_t i = 0; i < sparse.overlay.pixel_count(); ++i)
            EXPECT_EQ(sparse.overlay.at(i)[0] > 0.5f, shot.assignment.rule[i] == 1) << width << " " << i;
    }
}

/// Normals that turn at random cannot be interpolated: nearly all is shaded, and the rest is still near.
TEST(Sparse, NoisyNormalsAreShadedDensely) {
    const Environment light = stress();
    AovFrame frame = scenes::covered_frame(320, 200);
    std::mt19937 random(1);
    std::normal_distribution<float> noise(0, 0.05f);
    for (float& value : frame.layers[Role::normal].data) value += noise(random);
    const Shot shot(frame, scenes::whole_frame(frame), light, {scenes::lobe_of(ModelId::ggx, 0.05f, 0.05f)});
    const ShadedFrame sparse = shot.sparse();
    EXPECT_GT(shaded_pixels(sparse), frame.layers[Role::normal].pixel_count() * 9 / 10);
    EXPECT_GT(compare_images(sparse.overlay, shot.dense().overlay, nullptr).display_psnr_db, 45);
}

TEST(Sparse, BitsDoNotDependOnThreads) {
    const Environment light = stress();
    const AovFrame frame = scenes::sphere_in_frame(500, 400, 180);
    const Shot shot(frame, stripes(frame, 2, 130), light,
                    {scenes::lobe_of(ModelId::ggx, 0.05f, 0.05f), scenes::lobe_of(ModelId::kurt, 0.2f, 0.05f)});
    const ShadedFrame two = shot.sparse();
    const ThreadLimit one(1);
    const ShadedFrame single = shot.sparse();
    EXPECT_EQ(two.overlay.data, single.overlay.data);
    EXPECT_EQ(two.samples.data, single.samples.data);
    EXPECT_EQ(two.lookups, single.lookups);
}

TEST(Sparse, ManyTinyFrames) {
    const Environment light = Environment::from_image(scenes::constant_light(1), {}, "constant");
    for (const int width : {1, 2, 15, 16, 17, 33})
        for (const int height : {1, 3, 16, 18}) {
            const AovFrame frame = scenes::covered_frame(width, height);
            const Shot shot(frame, scenes::whole_frame(frame), light, {scenes::lobe_of(ModelId::ggx, 0.3f, 0.3f)});
            const ShadedFrame dense = shot.dense(), sparse = shot.sparse();
            for (size_t i = 0; i < dense.overlay.data.size(); ++i)
                EXPECT_NEAR(sparse.overlay.data[i], dense.overlay.data[i], 0.02f) << width << "x" << height;
        }
}

/// Corners at their places, bilinear cells, and cells of several sizes that meet without a crack.
TEST(Upsample, GivesLinearImagesBack) {
    const Environment light = stress();
    AovFrame frame = scenes::sphere_in_frame(400, 300, 140);
    const Shot shot(frame, scenes::whole_frame(frame), light, {scenes::lobe_of(ModelId::ggx, 0.1f, 0.1f)});
    const CellTurning turning(shot.frame, shot.surfaces, shot.assignment, {});
    const ShadingPlan plan(turning, shot.surfaces, shot.assignment, shot.predictors);
    Image image(400, 300, 3), expected(400, 300, 3);
    size_t corners = 0;
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 400; ++x)
            for (int k = 0; k < 3; ++k) {
                expected.at(x, y)[k] =
                    0.5f + 0.01f * static_cast<float>(k + 1) * static_cast<float>(x) - 0.02f * static_cast<float>(y);
                const bool is_corner = plan.corners(x / 16, y / 16)[static_cast<size_t>(y % 16)] >> (x % 16) & 1;
                image.at(x, y)[k] = is_corner ? expected.at(x, y)[k] : -100;
                corners += is_corner;
            }
    upsample(plan, image);
    EXPECT_GT(corners, 1000u);
    for (size_t i = 0; i < image.data.size(); ++i) {
        const bool is_valid = shot.surfaces.validity(i / 3) == Validity::valid;
        EXPECT_NEAR(is_valid ? image.data[i] : expected.data[i], expected.data[i], 1e-4f);
    }
}

}  // namespace
