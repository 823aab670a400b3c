// A coupled diffuse part: what the lobes leave of the light, at every angle of view.
#include <burnish/material/albedo.h>
#include <burnish/material/diffuse_reflectance.h>
#include <burnish/material/library.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

using namespace burnish;
using nlohmann::json;

namespace {

Material varnish(bool coupled) {
    const json lobe = {{"model", "ggx"}, {"m", 0.2}, {"r0", 0.05}, {"tint", {1, 0.5, 0.25}}};
    return material_from_json({{"kd", {0.8, 0.6, 0.4}}, {"kd_coupled", coupled}, {"lobes", {lobe}}}, "varnish", "varnish");
}

}  // namespace

TEST(DiffuseReflectance, GivesWayToTheLobes) {
    const Material material = varnish(true);
    const DiffuseReflectance kd(material);
    EXPECT_TRUE(kd.depends_on_view());
    for (const float cos_o : {0.05f, 0.13f, 0.37f, 0.71f, 1.0f}) {
        const Color3f rho = directional_albedo(material.lobes[0], {std::sqrt(1 - cos_o * cos_o), 0, cos_o}, 16384);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(kd.at(cos_o)[k], material.kd[k] * (1 - rho[k]), 2e-3f) << cos_o;
    }
    EXPECT_LT(kd.at(0.1f).x, 0.8f * kd.at(1.0f).x);
}

TEST(DiffuseReflectance, IsTheSameForAllViewsUnlessCoupled) {
    const DiffuseReflectance kd(varnish(false));
    EXPECT_FALSE(kd.depends_on_view());
    EXPECT_EQ(kd.at(0.1f), Color3f(0.8f, 0.6f, 0.4f));
}

TEST(DiffuseReflectance, NeverIsNegative) {
    Material bright = varnish(true);
    bright.lobes[0].strength = 100;
    const DiffuseReflectance kd(bright);
    for (const float cos_o : {0.0f, 0.5f, 1.0f}) EXPECT_GE(kd.at(cos_o).x, 0.0f);
}

TEST(DiffuseReflectance, CoupledMaterialsCreateNoEnergyWithTheirKd) {
    Material white = varnish(false);
    white.kd = Color3f(1, 1, 1), white.lobes[0].tint = Color3f(1, 1, 1);
    EXPECT_GT(check_energy(white).max_albedo, 1.04f);
    white.kd_coupled = true;
    EXPECT_NEAR(check_energy(white).max_albedo, 1.0f, 1e-3f);
}

TEST(DiffuseReflectance, IsOfTheMaterialsJson) {
    EXPECT_TRUE(material_from_json(material_to_json(varnish(true)), "again", "again").kd_coupled);
    EXPECT_FALSE(material_to_json(varnish(false)).contains("kd_coupled"));
    EXPECT_TRUE(material_from_json({{"kd", 0.5}, {"kd_coupled", true}}, "plain", "plain").lobes.empty());
    EXPECT_ANY_THROW(material_from_json({{"kd", 0.5}, {"kd_coupled", 1}}, "plain", "plain"));
}
