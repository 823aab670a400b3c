// Lobes under area lights against plain sums over the lamp, and against closed forms.
#include "shading_cases.h"

#include <burnish/shading/local_shading.h>
#include <burnish/shading/material_shader.h>

#include <gtest/gtest.h>

using namespace burnish_test;

namespace {

AreaSettings lamp(float width, float distance) {
    AreaSettings settings;
    settings.radiance = Color3f(10);
    const float w = width / 2, y = -distance,
                z = 0.6f * distance;  // facing the origin from where the fan of azimuth 90 is mirrored
    settings.corners = {{-w, y, z - 0.7f * w}, {-w, y, z + 0.7f * w}, {w, y, z + 0.7f * w}, {w, y, z - 0.7f * w}};
    return settings;
}

Image checks() {
    Image image(12, 8, 3);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 12; ++x) std::fill_n(image.at(x, y), 3, (x / 3 + y / 4) % 2 == 0 ? 1.5f : 0.2f);
    return image;
}

ShadedBatch shade_under(const AreaLight& light, const LobeParameters& p, int samples, const SurfaceBatch& batch) {
    const LightChain lights({{std::make_shared<const Light>(light), false}});
    ShadedBatch out;
    MaterialShader(std::make_shared<const MaterialTaps>(material(p), estimator(EstimatorKind::fitted, samples)), lights)
        .shade(batch, out);
    return out;
}

/// Midpoint rule over the lamp's area.
double sum_over(const AreaLight& light, const LobeParameters& p, const Vec3f& wo) {
    const std::vector<Vec3f>& corners = light.polygon().corners;
    const Vec3f u = corners[1] - corners[0], v = corners[3] - corners[0];
    return visit_lobe(p, [&](const auto& own) {
        const int steps = 300;
        double sum = 0;
        for (int y = 0; y < steps; ++y)
            for (int x = 0; x < steps; ++x) {
                const Vec3f at =
                    corners[0] + u * ((static_cast<float>(x) + 0.5f) / steps) + v * ((static_cast<float>(y) + 0.5f) / steps);
                const float r = at.length();
                const Vec3f wi = at / r;
                const float shown =
                    light.exact({{0, 0, 0}, {0, 0, 1}, wi, 0}).radiance.y * std::fabs(light.polygon().normal.dot(wi));
                sum += luminance(own.eval(wo, wi)) * std::max(wi.z, 0.0f) * shown / (r * r);
            }
        return sum * light.polygon().area / (static_cast<double>(steps) * steps);
    });
}

/// Root mean square of the error over a fan of views, over that of the truth.
double error_over_fan(const AreaLight& light, const LobeParameters& p, int samples) {
    const SurfaceBatch batch = fan(kPi / 2, 9);
    const ShadedBatch shaded = shade_under(light, p, samples, batch);
    double square = 0, whole = 0;
    for (size_t i = 0; i + 1 < batch.size(); ++i) {
        const double truth = sum_over(light, p, batch.wo[i]);
        square += std::pow(luminance(shaded.overlay[i]) - truth, 2), whole += truth * truth;
    }
    return std::sqrt(square / whole);
}

}  // namespace

TEST(AreaShading, SolidLampsAreWithinTwoPercent) {
    for (const ModelId model : {ModelId::ggx, ModelId::beckmann, ModelId::kurt})
        for (const float m : {0.05f, 0.15f, 0.5f}) {
            EXPECT_LT(error_over_fan(AreaLight(lamp(2, 3)), lobe(model, m, m), 7), 0.02) << int(model) << " " << m;
            EXPECT_LT(error_over_fan(AreaLight(lamp(0.3f, 1)), lobe(model, m, m), 7), 0.02) << int(model) << " " << m;
        }
}

TEST(AreaShading, LongLobesAreWithinFivePercent) {
    for (const ModelId model : {ModelId::ggx, ModelId::beckmann})
        EXPECT_LT(error_over_fan(AreaLight(lamp(1, 2)), lobe(model, 0.3f, 0.1f), 8), 0.05) << int(model);
}

TEST(AreaShading, PicturesAreWithinAFewPercent) {
    for (const ModelId model : {ModelId::ggx, ModelId::beckmann})
        for (const float m : {0.1f, 0.4f})
            EXPECT_LT(error_over_fan(AreaLight(lamp(2, 3), Color3f(1), checks()), lobe(model, m, m), 7), 0.08)
                << int(model) << m;
}

TEST(AreaShading, ASkyOfLampsGivesTheAlbedo) {
    std::vector<LightChain::Link> links;
    const Vec3f x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    for (const auto& [n, u, v] :
         {std::array{z, x, y}, std::array{x, y, z}, std::array{-x, y, z}, std::array{y, x, z}, std::array{-y, x, z}}) {
        AreaSettings settings;
        settings.two_sided = true;
        settings.corners = {n - u - v, n + u - v, n + u + v, n - u + v};
        links.push_back({std::make_shared<const Light>(AreaLight(settings)), false});
    }
    for (const float m : {0.1f, 0.4f}) {
        const LobeParameters p = lobe(ModelId::ggx, m, m);
        ShadedBatch out;
        const SurfaceBatch batch = fan(0.3f, 8);
        MaterialShader(std::make_shared<const MaterialTaps>(material(p), estimator(EstimatorKind::fitted, 7)),
                       LightChain(links))
            .shade(batch, out);
        for (size_t i = 0; i + 1 < batch.size(); ++i)
            EXPECT_NEAR(luminance(out.overlay[i]), luminance(directional_albedo(p, batch.wo[i])), 0.04f) << m << " " << i;
    }
}

TEST(AreaShading, TheSameBitsInAnyBatch) {
    const AreaLight light(lamp(1, 2), Color3f(1), checks());
    const LobeParameters p = lobe(ModelId::ggx, 0.2f, 0.2f);
    const SurfaceBatch all = fan(kPi / 2, 9);
    const ShadedBatch whole = shade_under(light, p, 7, all);
    for (size_t i = 0; i < all.size(); ++i) {
        SurfaceBatch one;
        one.pixel.push_back(all.pixel[i]);
        one.p.push_back(all.p[i]), one.n.push_back(all.n[i]), one.ng.push_back(all.ng[i]);
        one.t.push_back(all.t[i]), one.wo.push_back(all.wo[i]);
        EXPECT_EQ(shade_under(light, p, 7, one).overlay[0], whole.overlay[i]);
    }
}

TEST(AreaShading, ThereIsNothingBehindALamp) {
    AreaSettings settings = lamp(1, 2);
    std::reverse(settings.corners.begin(), settings.corners.end());
    const ShadedBatch out = shade_under(AreaLight(settings), lobe(ModelId::ggx, 0.3f, 0.3f), 7, fan(kPi / 2, 5));
    for (const Color3f& overlay : out.overlay) EXPECT_EQ(luminance(overlay), 0);
}
