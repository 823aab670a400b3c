// What the wavelet predictions make of lights and lobes that are easy to judge.
#include "core/scenes.h"

#include <burnish/frequency/lobe_bandwidth.h>
#include <burnish/shading/wavelet_prediction.h>
#include <burnish/surface/surfaces.h>

#include <gtest/gtest.h>

using namespace burnish;

namespace {

Material material_of(float m, ModelId model = ModelId::beckmann) {
    return {"test", Color3f(0, 0, 0), {scenes::lobe_of(model, m, m)}};
}

Environment environment(const Image& picture) { return Environment::from_image(picture, {}, "made"); }

/// Stripes of one degree over the half x > 0 of all directions, grey elsewhere.
Image half_striped() {
    Image light(512, 256, 3, 1.0f);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) std::fill_n(light.at(x, y), 3, x / 2 % 2 ? 1.9f : 0.1f);
    return light;
}

/// Points whose normals look along the given directions, seen straight on.
SurfaceBatch facing(const std::vector<Vec3f>& directions) {
    SurfaceBatch batch;
    for (const Vec3f& n : directions) {
        batch.pixel.push_back(static_cast<uint32_t>(batch.size()));
        batch.p.push_back(n), batch.n.push_back(n), batch.ng.push_back(n), batch.wo.push_back(n);
        batch.t.push_back(Frame::around(n).t);
    }
    return batch;
}

std::vector<PathBandwidth> paths_of(const Material& material, const Environment& light, const SurfaceBatch& batch,
                                    int directions = 0) {
    DensitySettings settings;
    settings.directions = directions;
    std::vector<PathBandwidth> paths(batch.size());
    WaveletPrediction(material, light, settings).predict(batch, std::span(paths));
    return paths;
}

/// Directions spread over the sphere.
SurfaceBatch all_round() {
    std::vector<Vec3f> directions;
    for (int i = 0; i < 64; ++i) {
        const float z = 1 - (2 * i + 1) / 64.0f, phi = 2.39996f * i, r = std::sqrt(1 - z * z);
        directions.push_back({r * std::cos(phi), r * std::sin(phi), z});
    }
    return facing(directions);
}

}  // namespace

TEST(WaveletPrediction, ConstantLightHasNoBandwidthAndTheLobesOwnVariance) {
    const Environment light = environment(scenes::constant_light(2));
    for (const PathBandwidth& path : paths_of(material_of(0.2f), light, all_round())) {
        EXPECT_LT(path.nu_l, 1e-3f);
        EXPECT_LT(path.nu_kept, 1e-3f);
        EXPECT_GT(path.variance, 0);
        EXPECT_NEAR(path.preconvolved_variance, 2 * path.variance, 1e-2f * path.variance) << "nu_l + nu_rho against 2 nu_rho";
    }
}

TEST(WaveletPrediction, LightIsSharpWhereItIsAndRoughLobesKeepWhatTheyLetThrough) {
    const Environment light = environment(half_striped());
    const Vec3f probe(0, 0, 1);
    for (const int directions : {1, 4, 16})
        for (const float m : {0.02f, 0.1f, 0.3f}) {
            const float rho = LobeBandwidth(scenes::lobe_of(ModelId::beckmann, m, m)).nu_rho(probe.z);
            // The picture's left and right quarter: its middle columns as directions of the world.
            const Matrix33f to_world = light.world_to_light().transposed();
            const Vec3f left = Vec3f(1, 0, 0) * to_world, right = Vec3f(-1, 0, 0) * to_world;
            std::vector<PathBandwidth> paths = paths_of(material_of(m), light, facing({left, right}), directions);
            if (paths[0].nu_l < paths[1].nu_l) std::swap(paths[0], paths[1]);
            EXPECT_GT(paths[0].nu_l, 10) << "stripes of 1.4 degrees: 20 cycles a radian";
            EXPECT_LT(paths[1].nu_l, m < 0.2f ? 0.3f * paths[0].nu_l : paths[0].nu_l) << directions << " " << m;
            EXPECT_NEAR(paths[0].nu_kept, std::min(rho, paths[0].nu_l), 0.02f * rho);
        }
}

TEST(WaveletPrediction, WidthsFromALayerAreLikeTheLobesOwn) {
    const Environment light = environment(scenes::stress_light(3, 256));
    SurfaceBatch batch = all_round();
    const std::vector<PathBandwidth> own = paths_of(material_of(0.2f), light, batch, 8);
    Material layered = material_of(0.05f);
    layered.lobes[0].per_pixel.roughness = true;
    batch.roughness.assign(batch.size(), 0.2f);
    const std::vector<PathBandwidth> from_layer = paths_of(layered, light, batch, 8);
    for (size_t i = 0; i < batch.size(); ++i) EXPECT_NEAR(from_layer[i].nu_kept, own[i].nu_kept, 0.2f * own[i].nu_kept + 0.05f);
}

TEST(WaveletPrediction, ASunIsADirectionOfItsOwn) {
    Image picture(1024, 512, 3, 0.01f);
    for (int y = 128; y < 130; ++y)
        for (int x = 700; x < 702; ++x) std::fill_n(picture.at(x, y), 3, 1e6f);
    const Environment light = environment(picture);
    ASSERT_EQ(light.discs().size(), 1u);
    const Vec3f sun = light.discs()[0].direction * light.world_to_light().transposed();
    const std::vector<PathBandwidth> paths = paths_of(material_of(0.1f), light, facing({sun, -sun}));
    EXPECT_GT(paths[0].nu_l, 10);
    EXPECT_LT(paths[1].nu_l, 1);
    EXPECT_GT(paths[0].variance, 1e4f * paths[1].variance);
}

TEST(WaveletPrediction, PlansGetSafetySourceAboveCorrelatedAndTheSameBitsInEveryBatch) {
    const Environment light = environment(scenes::stress_light(3, 256));
    const Material material = material_of(0.15f, ModelId::ggx);
    const SurfaceBatch batch = all_round();
    const auto predicted = [&](PredictionKind kind, float safety, const SurfaceBatch& pixels) {
        DensitySettings settings;
        settings.prediction = kind, settings.safety = safety;
        std::vector<AngularPrediction> out(pixels.size());
        BandwidthPredictor(material, light, settings).predict(pixels, out);
        return out;
    };
    const auto correlated = predicted(PredictionKind::correlated, 1, batch),
               safe = predicted(PredictionKind::correlated, 3, batch), source = predicted(PredictionKind::source, 1, batch);
    for (size_t i = 0; i < batch.size(); ++i) {
        EXPECT_FLOAT_EQ(safe[i].nu_a, 3 * correlated[i].nu_a);
        EXPECT_GE(source[i].nu_a, correlated[i].nu_a);
        EXPECT_GT(correlated[i].reach, 0);
        SurfaceBatch one = facing({batch.n[i]});
        EXPECT_EQ(predicted(PredictionKind::correlated, 1, one)[0].nu_a, correlated[i].nu_a);
    }
}
