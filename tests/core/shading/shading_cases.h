// What the tests of estimators share: lobes, settings, a fan of views, and the integral the brute way.
#pragma once

#include <burnish/base/parallel.h>
#include <burnish/material/albedo.h>
#include <burnish/material/lobe.h>
#include <burnish/shading/dense.h>
#include "core/scenes.h"

namespace burnish_test {

using namespace burnish;

inline LobeParameters lobe(ModelId model, float mx, float my) {
    LobeParameters p;
    p.model = model, p.mx = mx, p.my = my;
    if (model == ModelId::kurt) p.extra = {0.4f};
    return p;
}

inline Material material(const LobeParameters& p) { return {"test", Color3f(0, 0, 0), {p}}; }

inline EstimatorSettings estimator(EstimatorKind kind, int samples = 19) {
    EstimatorSettings settings;
    settings.kind = kind, settings.samples = samples;
    settings.tolerance = 1e-4f, settings.max_samples = 1 << 16;
    return settings;
}

inline Environment light_of(const Image& image) {
    EnvironmentSettings settings;
    settings.face_size = 256;
    return Environment::from_image(image, settings, "test light");
}

/// A row of points seen from 0 to 88 degrees: the batch a plane patch would give, n = +Z, wo in the plane of azimuth phi.
inline SurfaceBatch fan(float phi, int count = 12) {
    SurfaceBatch batch;
    for (int i = 0; i < count; ++i) {
        const float theta = 88.0f * kPi / 180 * i / (count - 1);
        batch.pixel.push_back(i);
        batch.p.push_back({0, 0, 0}), batch.n.push_back({0, 0, 1}), batch.ng.push_back({0, 0, 1}), batch.t.push_back({1, 0, 0});
        batch.wo.push_back({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
    }
    return batch;
}

inline ShadedBatch shade(const Material& m, const Environment& light, const EstimatorSettings& settings,
                         const SurfaceBatch& batch) {
    ShadedBatch out;
    MaterialShader(m, light, settings).shade(batch, out);
    return out;
}

/// Midpoint rule over the hemisphere above n and ng: an oracle that shares nothing with the estimators but the BRDF.
inline Color3f brute_force(const LobeParameters& p, const Environment& light, const Vec3f& wo, const Vec3f& ng = {0, 0, 1}) {
    return visit_lobe(p, [&](const auto& own) {
        Imath::V3d sum(0, 0, 0);
        const int steps = 1500;
        for (int iy = 0; iy < steps; ++iy)
            for (int ix = 0; ix < steps; ++ix) {
                const float z = 1 - (iy + 0.5f) / steps, phi = 2 * kPi * (ix + 0.5f) / steps, r = std::sqrt(1 - z * z);
                const Vec3f wi(r * std::cos(phi), r * std::sin(phi), z * own.side_sign);
                if (ng.dot(wi) * own.side_sign <= 0) continue;
                sum += Imath::V3d(own.eval(wo, wi) * light.radiance(wi * light.world_to_light()) * z);
            }
        return Color3f(Vec3f(sum * (2 * kPi / (static_cast<double>(steps) * steps))));
    });
}

}  // namespace burnish_test
