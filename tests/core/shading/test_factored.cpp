// The `factored` estimator as a whole: against `reference`, under turned light, by given maps, and where it has to refuse.
#include "core/scenes.h"

#include <burnish/base/display.h>
#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/shading/dense.h>
#include <burnish/shading/factored.h>
#include <burnish/shading/local_shading.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace burnish;
using scenes::lobe_of;

namespace {

EstimatorSettings by_maps(const std::string& parametrization = "nre") {
    EstimatorSettings settings;
    settings.kind = EstimatorKind::factored, settings.parametrization = parametrization, settings.map_size = 16;
    return settings;
}

Material rough(float m = 0.3f) { return {"rough", Color3f(0), {lobe_of(ModelId::ggx, m, m)}}; }

MaterialShader by(const Material& material, const Environment& light, const Factors& maps) {
    return MaterialShader(std::make_shared<const FactoredShader>(material, light, maps));
}

Environment spots() {
    EnvironmentSettings settings;
    settings.face_size = 64;
    return Environment::from_image(scenes::stress_light(7, 128), settings, "spots");
}

/// A sphere of one material under one light.
class Sphere {
public:
    AovFrame frame = scenes::sphere_frame(32);
    Assignment assignment = scenes::whole_frame(frame);

    PixelVector<float> shade(const MaterialShader& shader) const {
        const Surfaces surfaces(frame, assignment, {});
        return shade_dense(surfaces, assignment, {shader}, {}).overlay.data;
    }
};

/// Of the display signal, the truth's mean at middle grey; over the sphere.
double psnr_db(const PixelVector<float>& picture, const PixelVector<float>& truth) {
    double mean = 0, square = 0, count = 0;
    for (const float value : truth) mean += value, count += value > 0;
    const double exposure = kMiddleGrey * count / mean;
    for (size_t i = 0; i < truth.size(); ++i)
        square += std::pow(display_encoded(picture[i] * exposure) - display_encoded(truth[i] * exposure), 2);
    return -10 * std::log10(square / count);
}

std::string refusal(const Material& material, const Environment& light) {
    try {
        MaterialShader(material, light, by_maps());
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_argument);
        return error.what();
    }
    return "";
}

}  // namespace

TEST(Factored, IsAsCloseAsItsParametrisationAllows) {
    const Environment light = spots();
    const Sphere sphere;
    EstimatorSettings reference;
    reference.kind = EstimatorKind::reference, reference.tolerance = 0.01f;
    const PixelVector<float> truth = sphere.shade(MaterialShader(rough(), light, reference));
    for (const auto& [name, floor] : {std::pair("nr", 28.0), {"nre", 28.0}, {"nrv", 28.0}, {"nrhd", 28.0}})
        EXPECT_GT(psnr_db(sphere.shade(MaterialShader(rough(), light, by_maps(name))), truth), floor) << name;
}

TEST(Factored, CostsTheSameForAnyNumberOfLobes) {
    const Environment light = spots();
    Material varnished = rough();
    varnished.lobes.push_back(lobe_of(ModelId::beckmann, 0.2f, 0.2f));
    SurfaceBatch batch;
    batch.pixel.push_back(0), batch.n.push_back({0, 0, 1}), batch.wo.push_back({0, 0.6f, 0.8f});
    ShadedBatch one, two;
    MaterialShader(rough(), light, by_maps("nr")).shade(batch, one);
    MaterialShader(varnished, light, by_maps("nr")).shade(batch, two);
    EXPECT_EQ(one.samples[0], 2);
    EXPECT_EQ(two.samples[0], 2);
    EXPECT_GT(two.overlay[0].y, one.overlay[0].y);
}

/// Maps know the light's own axes, so that they serve it however it is turned, flipped, scaled and tinted.
TEST(Factored, KeepsItsMapsWhenTheLightIsTurned) {
    const Environment light = spots();
    EnvironmentSettings turned = light.settings();
    turned.rotate_deg = 50, turned.flip = true, turned.scale = 3, turned.tint = Color3f(1, 0.5f, 0.25f);
    const Environment other = light.relit(turned);
    const Factors maps = factored_light(rough(), light, by_maps());
    const Sphere sphere;
    const PixelVector<float> kept = sphere.shade(by(rough(), other, maps));
    EXPECT_EQ(kept, sphere.shade(MaterialShader(rough(), other, by_maps())));
    EXPECT_NE(kept, sphere.shade(by(rough(), light, maps)));
}

TEST(Factored, TakesTintAndWeightOfTheWholeMaterialFromLayers) {
    const Environment light = spots();
    Material layered = rough();
    layered.lobes[0].per_pixel.weight = layered.lobes[0].per_pixel.tint = true;
    SurfaceBatch batch;
    batch.pixel.push_back(0), batch.n.push_back({0, 0, 1}), batch.wo.push_back({0, 0.6f, 0.8f});
    ShadedBatch plain, shaded;
    const Factors maps = factored_light(rough(), light, by_maps("nr"));
    by(rough(), light, maps).shade(batch, plain);
    batch.weight.push_back(0.5f), batch.tint.push_back({1, 0.5f, 0});
    by(layered, light, maps).shade(batch, shaded);
    EXPECT_EQ(shaded.overlay[0], plain.overlay[0] * Color3f(1, 0.5f, 0) * 0.5f);
    by(rough(), light, maps).shade(batch, shaded);
    EXPECT_EQ(shaded.overlay[0], plain.overlay[0]);
}

TEST(Factored, IsBlackWithoutLightAndFollowsItsScale) {
    const Image dark = scenes::constant_light(0);
    const Sphere sphere;
    const PixelVector<float> black =
        sphere.shade(MaterialShader(rough(), Environment::from_image(dark, {}, "dark"), by_maps()));
    EXPECT_TRUE(std::ranges::all_of(black, [](float value) { return value == 0; }));
    const auto shade = [&](float scale) {
        Image picture = scenes::stress_light(7, 64);
        for (float& value : picture.data) value *= scale;
        const Environment light = Environment::from_image(picture, {}, "scaled");
        return sphere.shade(MaterialShader(rough(), light, by_maps("nr")));
    };
    const PixelVector<float> known = shade(1);
    for (const float scale : {1e-20f, 1e20f}) {
        PixelVector<float> scaled = shade(scale);
        for (float& value : scaled) value /= scale;
        EXPECT_GT(psnr_db(scaled, known), 60) << scale;
    }
}

TEST(Factored, RefusesWhatMapsCannotHold) {
    const Environment light = spots();
    Material brushed = rough(), layered = rough(), coated = rough();
    brushed.lobes[0].my = 0.1f;
    layered.lobes[0].per_pixel.roughness = true;
    coated.lobes.push_back(lobe_of(ModelId::ggx, 0.1f, 0.1f)), coated.lobes[1].per_pixel.weight = true;
    EXPECT_NE(refusal(brushed, light).find("anisotropic"), std::string::npos);
    EXPECT_NE(refusal(layered, light).find("layer"), std::string::npos);
    EXPECT_NE(refusal(coated, light).find("some of its lobes"), std::string::npos);
    EXPECT_THROW(MaterialTaps(rough(), by_maps()), Error);
    EXPECT_THROW(by(rough(), light, uniform_factors(parametrization_by_name("io"), Mapping::cube, 8)), Error);
}

TEST(Factored, IsTheSameForAnyThreadCount) {
    const Environment light = spots();
    const Sphere sphere;
    const auto shade = [&](int threads) {
        const ThreadLimit limit(threads);
        return sphere.shade(MaterialShader(rough(), light, by_maps("nr")));
    };
    EXPECT_EQ(shade(1), shade(2));
}
