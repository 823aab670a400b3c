#include <burnish/material/albedo.h>
#include <burnish/material/library.h>
#include <core/material/lobe_cases.h>

#include <gtest/gtest.h>

namespace burnish {

namespace {

/// Albedo of isotropic GGX with F = 1 on a plain grid of wi over the hemisphere, in double, by the textbook formula.
double ggx_albedo_by_grid(double alpha, double theta_deg) {
    const auto G1 = [&](double c) { return 2 / (1 + std::sqrt(1 + alpha * alpha * (1 - c * c) / (c * c))); };
    const double t = theta_deg * M_PI / 180;
    const Imath::V3d wo(std::sin(t), 0, std::cos(t));
    const int rows = 1500, columns = 1500;
    double sum = 0;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double c = (i + 0.5) / rows, s = std::sqrt(1 - c * c), phi = M_PI * (j + 0.5) / columns;
            const Imath::V3d h = (wo + Imath::V3d(s * std::cos(phi), s * std::sin(phi), c)).normalized();
            const double q = h.z * h.z * (alpha * alpha - 1) + 1, D = alpha * alpha / (M_PI * q * q);
            sum += D * G1(wo.z) * G1(c) / (4 * wo.z);
        }
    return sum * 2 * M_PI / rows / columns;
}

}  // namespace

TEST(Albedo, OfGgxMatchesAGridOfTheHemisphere) {
    for (const double theta_deg : {0.0, 30.0, 60.0, 75.0, 85.0}) {
        const double grid = ggx_albedo_by_grid(0.3, theta_deg);
        EXPECT_NEAR(directional_albedo(make_lobe(ModelId::ggx, 0.3f, 0.3f), direction_deg(theta_deg, 25)).x, grid, 1e-3 * grid)
            << theta_deg;
    }
}

TEST(Albedo, OfASmoothLobeIsItsFresnelReflectance) {
    for (const ModelId model : {ModelId::beckmann, ModelId::ggx}) {
        LobeParameters lobe = make_lobe(model, 1e-3f, 1e-3f);
        lobe.fresnel = {FresnelKind::dielectric, Color3f(1.5f)};
        for (const double theta_deg : {0.0, 45.0, 75.0}) {
            const Vec3f wo = direction_deg(theta_deg, 0);
            EXPECT_NEAR(directional_albedo(lobe, wo).x, lobe.fresnel(wo.z).x, 2e-4) << theta_deg;
        }
    }
}

TEST(Albedo, ScalesWithStrengthAndTint) {
    LobeParameters lobe = make_lobe(ModelId::kurt, 0.2f, 0.2f);
    const Vec3f wo = direction_deg(50, 0);
    const float plain = directional_albedo(lobe, wo).x;
    lobe.strength = 0.5f;
    lobe.tint = {1, 0.5f, 0};
    const Color3f tinted = directional_albedo(lobe, wo);
    EXPECT_NEAR(tinted.x, 0.5f * plain, 1e-6f);
    EXPECT_NEAR(tinted.y, 0.25f * plain, 1e-6f);
    EXPECT_EQ(tinted.z, 0);
}

TEST(Albedo, TurnsWithTheLobe) {
    LobeParameters lobe = make_lobe(ModelId::ggx, 0.02f, 0.6f);
    const float along = directional_albedo(lobe, direction_deg(75, 0)).x,
                across = directional_albedo(lobe, direction_deg(75, 90)).x;
    EXPECT_GT(std::abs(along - across), 0.03f);
    lobe.rotation = kPi / 2;
    EXPECT_NEAR(directional_albedo(lobe, direction_deg(75, 90)).x, along, 1e-3f);
    EXPECT_NEAR(directional_albedo(lobe, direction_deg(75, 0)).x, across, 1e-3f);
}

TEST(Albedo, SidesOfAThinSheetShareTheLight) {
    LobeParameters front = make_lobe(ModelId::ggx, 1e-3f, 1e-3f),
                   through = make_lobe(ModelId::ggx, 1e-3f, 1e-3f, Side::transmission);
    front.fresnel = through.fresnel = {FresnelKind::dielectric, Color3f(1.5f)};
    through.fresnel.complement = true;
    for (const double theta_deg : {0.0, 60.0, 80.0}) {
        const Vec3f wo = direction_deg(theta_deg, 0);
        EXPECT_NEAR(directional_albedo(front, wo).x + directional_albedo(through, wo).x, 1, 1e-3) << theta_deg;
    }
}

TEST(EnergyCheck, HoldsForEveryPreset) {
    for (const Material& preset : presets()) {
        const EnergyCheck energy = check_energy(preset);
        EXPECT_LE(energy.max_albedo, 1.001f) << preset.name << " at " << energy.theta_o_deg << " degrees";
        EXPECT_GT(energy.max_albedo, 0.1f) << preset.name;
    }
}

TEST(EnergyCheck, FindsWhereAMaterialCreatesEnergy) {
    Material material{"greedy", Color3f(0), {make_lobe(ModelId::kurt, 0.1f, 0.1f)}};
    material.lobes[0].extra = {1};
    const EnergyCheck energy = check_energy(material);
    EXPECT_GT(energy.max_albedo, 1.5f);
    EXPECT_EQ(energy.theta_o_deg, kSteepestCheck_deg);
}

TEST(EnergyCheck, AddsTheDiffusePartAndAllLobes) {
    Material material{
        "sum", Color3f(0.6f, 0.1f, 0.1f), {make_lobe(ModelId::beckmann, 0.05f, 0.05f), make_lobe(ModelId::ggx, 0.05f, 0.05f)}};
    material.lobes[0].strength = material.lobes[1].strength = 0.3f;
    EXPECT_NEAR(check_energy(material).max_albedo, 1.2f, 0.01f);
}

}  // namespace burnish
