// The `fitted` and `split_sum` estimators as a whole: spheres against `reference` and against the other estimators.
#include "core/scenes.h"

#include <burnish/base/parallel.h>
#include <burnish/material/albedo.h>
#include <burnish/material/model.h>
#include <burnish/shading/dense.h>

#include <gtest/gtest.h>

using namespace burnish;
using scenes::lobe_of;

namespace {

EstimatorSettings estimator(EstimatorKind kind, int samples = 0) {
    EstimatorSettings settings;
    settings.kind = kind, settings.samples = samples, settings.tolerance = 0.01f, settings.max_samples = 4096;
    return settings;
}

/// A sphere of one lobe under one light.
class Sphere {
public:
    Sphere(int size, const Environment& light)
        : m_frame(scenes::sphere_frame(size)), m_assignment(scenes::whole_frame(m_frame)), m_light(light) {}

    AovFrame& frame() { return m_frame; }
    ShadedFrame shade(const LobeParameters& lobe, const EstimatorSettings& settings) const {
        const Surfaces surfaces(m_frame, m_assignment, {});
        return shade_dense(surfaces, m_assignment, {MaterialShader({"sphere", Color3f(0), {lobe}}, m_light, settings)}, {});
    }

private:
    AovFrame m_frame;
    Assignment m_assignment;
    const Environment& m_light;
};

/// Root of mean (a - b)^2 over mean b^2, all channels.
double relative_rms(const ShadedFrame& a, const ShadedFrame& b) {
    double square = 0, power = 0;
    for (size_t i = 0; i < a.overlay.data.size(); ++i) {
        const double d = a.overlay.data[i] - b.overlay.data[i], truth = b.overlay.data[i];
        square += d * d, power += truth * truth;
    }
    return std::sqrt(square / power);
}

Environment stress(uint32_t seed, int face = 128) {
    EnvironmentSettings settings;
    settings.face_size = face;
    return Environment::from_image(scenes::stress_light(seed, 512), settings, "stress");
}

Environment constant() {
    EnvironmentSettings settings;
    settings.face_size = 16;
    return Environment::from_image(scenes::constant_light(1), settings, "constant");
}

}  // namespace

TEST(Fitted, KeepsTheAlbedoUnderConstantLight) {
    const Environment light = constant();
    for (const ModelId model : {ModelId::kurt, ModelId::beckmann, ModelId::ggx})
        for (const float m : {0.02f, 0.1f, 0.4f}) {
            const LobeParameters lobe = lobe_of(model, m, m);
            SurfaceBatch batch;
            for (const float theta : {0.0f, 0.5f, 1.0f, 1.3f, 1.48f}) {
                batch.pixel.push_back(0), batch.p.push_back({0, 0, 0}), batch.t.push_back({1, 0, 0});
                batch.n.push_back({0, 0, 1}), batch.ng.push_back({0, 0, 1});
                batch.wo.push_back({std::sin(theta), 0, std::cos(theta)});
            }
            ShadedBatch out;
            MaterialShader({"furnace", Color3f(0), {lobe}}, light, estimator(EstimatorKind::fitted)).shade(batch, out);
            for (size_t i = 0; i < batch.size(); ++i)
                EXPECT_NEAR(out.overlay[i].y / directional_albedo(lobe, batch.wo[i], 1 << 14).y, 1, 0.006)
                    << model_info(model).name << " m " << m << " cos " << batch.wo[i].z;
        }
}

/// Fits have taps of negative weight, which may meet a lamp that the others miss.
TEST(Fitted, TakesNoLightAway) {
    const Environment light = stress(7);
    for (const LobeParameters& lobe : {lobe_of(ModelId::beckmann, 0.1f, 0.1f), lobe_of(ModelId::beckmann, 0.3f, 0.3f)}) {
        SurfaceBatch batch;
        for (int i = 0; i < 64 * 24; ++i) {
            const float phi = 2 * kPi * static_cast<float>(i % 64) / 64, z = 0.005f + 0.006f * static_cast<float>(i / 64);
            const float across = std::sqrt(1 - z * z);
            batch.pixel.push_back(0), batch.p.push_back({0, 0, 0}), batch.t.push_back({1, 0, 0});
            batch.n.push_back({0, 0, 1}), batch.ng.push_back({0, 0, 1});
            batch.wo.push_back({across * std::cos(phi), across * std::sin(phi), z});
        }
        ShadedBatch out;
        MaterialShader({"rim", Color3f(0), {lobe}}, light, estimator(EstimatorKind::fitted)).shade(batch, out);
        for (size_t i = 0; i < batch.size(); ++i) EXPECT_GE(luminance(out.overlay[i]), 0) << "cos " << batch.wo[i].z;
    }
}

/// The bars of the estimator: four lookups do what sixteen regular ones do, seven have a third of filtered importance's error.
TEST(Fitted, NeedsFarFewerLookups) {
    const Environment light = stress(7);
    const Sphere sphere(24, light);
    for (const ModelId model : {ModelId::beckmann, ModelId::ggx})
        for (const float m : {0.05f, 0.2f}) {
            const LobeParameters lobe = lobe_of(model, m, m);
            const ShadedFrame truth = sphere.shade(lobe, estimator(EstimatorKind::reference));
            const auto error = [&](EstimatorKind kind, int samples) {
                return relative_rms(sphere.shade(lobe, estimator(kind, samples)), truth);
            };
            EXPECT_LT(error(EstimatorKind::fitted, 4), error(EstimatorKind::regular, 16)) << model_info(model).name << m;
            EXPECT_LT(error(EstimatorKind::fitted, 7), error(EstimatorKind::filtered_importance, 7) / 3) << m;
            EXPECT_LT(error(EstimatorKind::fitted, 4), error(EstimatorKind::split_sum, 1) / 2) << m;
        }
}

TEST(Fitted, FollowsAnisotropicLobes) {
    const Environment light = stress(7);
    const Sphere sphere(24, light);
    const LobeParameters lobe = lobe_of(ModelId::beckmann, 0.2f, 0.075f);
    const ShadedFrame truth = sphere.shade(lobe, estimator(EstimatorKind::reference));
    const double fitted = relative_rms(sphere.shade(lobe, estimator(EstimatorKind::fitted, 8)), truth);
    EXPECT_LT(fitted, relative_rms(sphere.shade(lobe, estimator(EstimatorKind::regular, 30)), truth));
}

TEST(Fitted, TakesRoughnessFromALayer) {
    const Environment light = stress(8);
    Sphere sphere(24, light);
    LobeParameters lobe = lobe_of(ModelId::ggx, 0.1f, 0.1f);
    const ShadedFrame uniform = sphere.shade(lobe, estimator(EstimatorKind::fitted));
    sphere.frame().layers[Role::roughness] = Image(24, 24, 1, std::sqrt(0.1f));
    lobe.per_pixel.roughness = true, lobe.mx = lobe.my = 0.5f;
    EXPECT_LT(relative_rms(sphere.shade(lobe, estimator(EstimatorKind::fitted)), uniform), 0.02);
}

/// A thin sheet in front of the light: transmission is the reflection mirrored at the surface.
TEST(Fitted, MirrorsTransmission) {
    Environment light = constant();
    LobeParameters lobe = lobe_of(ModelId::beckmann, 0.2f, 0.2f);
    lobe.side = Side::transmission;
    const Sphere sphere(16, light);
    const ShadedFrame truth = sphere.shade(lobe, estimator(EstimatorKind::reference));
    EXPECT_LT(relative_rms(sphere.shade(lobe, estimator(EstimatorKind::fitted)), truth), 0.01);
    const Environment spots = stress(9);
    const Sphere lit(24, spots);
    EXPECT_LT(
        relative_rms(lit.shade(lobe, estimator(EstimatorKind::fitted)), lit.shade(lobe, estimator(EstimatorKind::reference))),
        0.12);
}

/// Fits cannot be made for every pixel, so such lobes are shaded by `regular`.
TEST(Fitted, LeavesAnisotropyFromALayerToRegular) {
    const Environment light = stress(8, 64);
    Sphere sphere(16, light);
    sphere.frame().layers[Role::anisotropy] = Image(16, 16, 1, 0.5f);
    LobeParameters lobe = lobe_of(ModelId::ggx, 0.2f, 0.2f);
    lobe.per_pixel.anisotropy = true;
    const ShadedFrame fitted = sphere.shade(lobe, estimator(EstimatorKind::fitted)),
                      regular = sphere.shade(lobe, estimator(EstimatorKind::regular));
    EXPECT_EQ(fitted.overlay.data, regular.overlay.data);
    EXPECT_EQ(fitted.lookups, regular.lookups);
}

TEST(Fitted, IsTheSameForAnyThreadCount) {
    const Environment light = stress(8, 64);
    const Sphere sphere(24, light);
    const auto shade = [&](int threads, EstimatorKind kind) {
        const ThreadLimit limit(threads);
        return sphere.shade(lobe_of(ModelId::ggx, 0.2f, 0.05f), estimator(kind)).overlay.data;
    };
    for (const EstimatorKind kind : {EstimatorKind::fitted, EstimatorKind::split_sum})
        EXPECT_EQ(shade(1, kind), shade(2, kind));
}

TEST(SplitSum, IsRightFromAboveAndWrongAtGrazingAngles) {
    const Environment light = stress(10);
    const LobeParameters lobe = lobe_of(ModelId::ggx, 0.15f, 0.15f);
    const auto error_at = [&](float theta) {
        SurfaceBatch batch;
        for (int i = 0; i < 200; ++i) {  // normals all over the sphere, seen from `theta`
            const float z = 1 - 2 * (static_cast<float>(i) + 0.5f) / 200, r = std::sqrt(1 - z * z),
                        phi = 2.4f * static_cast<float>(i);
            const Vec3f n(r * std::cos(phi), r * std::sin(phi), z);
            const Frame frame = Frame::around(n);
            batch.pixel.push_back(0), batch.p.push_back({0, 0, 0}), batch.n.push_back(n), batch.ng.push_back(n);
            batch.t.push_back(frame.t), batch.wo.push_back(frame.to_world({std::sin(theta), 0, std::cos(theta)}));
        }
        const auto shade = [&](EstimatorKind kind) {
            ShadedBatch out;
            MaterialShader({"points", Color3f(0), {lobe}}, light, estimator(kind)).shade(batch, out);
            return out.overlay;
        };
        const auto split = shade(EstimatorKind::split_sum), truth = shade(EstimatorKind::reference);
        double square = 0, power = 0;
        for (size_t i = 0; i < truth.size(); ++i)
            square += std::pow(split[i].y - truth[i].y, 2.0), power += std::pow(truth[i].y, 2.0);
        return std::sqrt(square / power);
    };
    EXPECT_LT(error_at(0.05f), 0.05);
    EXPECT_GT(error_at(1.2f), 0.2);
}
