// Materials that show measurements: from files, from JSON, and back to JSON.
#include <burnish/base/error.h>
#include <burnish/material/albedo.h>
#include <burnish/material/library.h>
#include <burnish/material/measured/gonio_file.h>
#include <burnish/material/measured/table_files.h>
#include <core/material/lobe_cases.h>
#include <core/scratch.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace burnish {

using nlohmann::json;

namespace {

constexpr float kWidth = 0.15f;
const Color3f kBase(0.3f, 0.2f, 0.1f);

/// A varnished wall: a diffuse base and a highlight.
Color3f varnish(const Vec3f& wo, const Vec3f& wi) {
    LobeParameters lobe = make_lobe(ModelId::ggx, kWidth, kWidth);
    lobe.fresnel = {FresnelKind::dielectric, Color3f(1.5f)};
    return kBase / kPi + Ggx(lobe).eval(wo, wi);
}

/// A folder with the varnish as a MERL table.
struct TableFolder {
    Scratch folder;
    std::string file = folder.file("varnish.binary");
    TableFolder() { MerlTable(varnish).write(file); }
};

const TableFolder& varnish_folder() {
    static const TableFolder folder;
    return folder;
}

std::string complaint(const json& material) {
    try {
        material_from_json(material, "x", "x");
    } catch (const Error& error) {
        return error.what();
    }
    return "no complaint";
}

}  // namespace

TEST(TableMaterial, TakesItsDiffusePartOutOfTheLobe) {
    const Material material = find_material(varnish_folder().file);
    EXPECT_EQ(material.name, "varnish");
    ASSERT_EQ(material.lobes.size(), 1u);
    const LobeParameters& lobe = material.lobes.front();
    EXPECT_LT((material.kd - kBase).length(), 0.02f) << material.kd;
    EXPECT_NEAR(lobe.mx, kWidth, 0.1f * kWidth);
    EXPECT_EQ(lobe.mx, lobe.my);
    const Vec3f wo = direction_deg(40, 30), wi = direction_deg(43, 205);
    const Color3f shown = visit_lobe(lobe, [&](const auto& f) { return f.eval(wo, wi); }) + material.kd / kPi;
    EXPECT_LT((shown - varnish(wo, wi)).length(), 0.03f * varnish(wo, wi).length());
    LobeParameters gloss = make_lobe(ModelId::ggx, kWidth, kWidth);
    gloss.fresnel = {FresnelKind::dielectric, Color3f(1.5f)};
    const float whole = directional_albedo(gloss, wo).y + kBase.y;
    EXPECT_NEAR(directional_albedo(lobe, wo).y + material.kd.y, whole, 0.005f * whole);
}

TEST(TableMaterial, TheLobesOwnFunctionsFollowTheTable) {
    const LobeParameters lobe = find_material(varnish_folder().file).lobes.front();
    const LobeParameters gloss = make_lobe(ModelId::ggx, kWidth, kWidth);
    visit_lobe(lobe, [&](const auto& f) {
        for (const double theta_deg : {0.0, 5.0, 15.0}) {
            const Vec3f h = direction_deg(theta_deg, 70);
            EXPECT_NEAR(f.model.D(h), Ggx(gloss).D(h), 0.15f * Ggx(gloss).D(h)) << theta_deg;
        }
    });
}

TEST(TableMaterial, SurvivesJson) {
    const Material material = find_material(varnish_folder().file);
    const json written = material_to_json(material);
    EXPECT_EQ(written["lobes"][0]["table"], varnish_folder().file);
    const Material again = material_from_json(json::parse(written.dump()), "varnish", "again");
    EXPECT_EQ(material_to_json(again), written);
    const Vec3f wo = direction_deg(50, 0), wi = direction_deg(45, 190);
    const auto eval = [&](const Material& m) { return visit_lobe(m.lobes[0], [&](const auto& f) { return f.eval(wo, wi); }); };
    EXPECT_EQ(eval(again), eval(material));
}

TEST(TableMaterial, JsonMayGiveTheDiffusePartAndTheWidth) {
    const std::string file = varnish_folder().file;
    const Material whole = material_from_json({{"model", "table"}, {"table", file}, {"kd", 0}}, "x", "x");
    EXPECT_EQ(whole.kd, Color3f(0));
    const Vec3f wo = direction_deg(20, 0), aside = direction_deg(60, 90);
    const Color3f f = visit_lobe(whole.lobes[0], [&](const auto& lobe) { return lobe.eval(wo, aside); });
    EXPECT_LT((f - varnish(wo, aside)).length(), 0.05f * f.length());
    const Material wide = material_from_json({{"model", "table"}, {"table", file}, {"m", 0.3}}, "x", "x");
    EXPECT_EQ(wide.lobes[0].mx, 0.3f);
    EXPECT_LT((wide.kd - kBase).length(), 0.02f);
    const Vec3f up(0, 0, 1);
    EXPECT_NEAR(directional_albedo(wide.lobes[0], up).x, directional_albedo(find_material(file).lobes[0], up).x, 0.002f);
}

TEST(TableMaterial, PathsAreRelativeToTheFileThatNamesThem) {
    const auto& folder = varnish_folder().folder;
    std::ofstream(folder.file("wall.json"))
        << R"({"kd": "auto", "lobes": [{"model": "table", "table": "varnish.binary", "ks": 0.5}]})";
    const Material material = find_material(folder.file("wall.json"));
    EXPECT_EQ(table_of(material.lobes.front()), varnish_folder().file);
    EXPECT_EQ(material.lobes.front().strength, 0.5f);
    EXPECT_LT((material.kd - kBase).length(), 0.02f);
}

TEST(TableMaterial, AnisotropicTablesHaveTwoWidths) {
    const LobeParameters brushed = make_lobe(ModelId::beckmann, 0.1f, 0.3f);
    std::vector<BrdfSample> samples;
    for (int i = 0; i < 10; ++i)
        for (int phi_i = 0; phi_i < 360; phi_i += 30)
            for (int theta_o = 0; theta_o < 90; theta_o += 4)
                for (int phi_o = 0; phi_o < 360; phi_o += 10) {
                    const Vec3f wi = direction_deg(8 * i, phi_i), wo = direction_deg(theta_o, phi_o);
                    samples.push_back({wo, wi, Beckmann(brushed).eval(wo, wi)});
                }
    const auto table = std::make_shared<GonioTable>(samples, false);
    const Material material = table_material(table, "brushed");
    EXPECT_NEAR(material.lobes[0].mx, 0.1f, 0.03f);
    EXPECT_NEAR(material.lobes[0].my, 0.3f, 0.06f);
    const Vec3f wo = direction_deg(35, 20);
    EXPECT_NEAR(directional_albedo(material.lobes[0], wo).x, directional_albedo(brushed, wo).x, 0.05f);
}

TEST(TableMaterial, TransmittedLightIsALobeOfItsOwn) {
    std::vector<BrdfSample> samples;
    for (int theta_i = 0; theta_i < 80; theta_i += 10)
        for (int theta_o = 0; theta_o < 180; theta_o += 5)
            for (int phi_o = 0; phi_o <= 180; phi_o += 15) {
                const Vec3f incident = direction_deg(theta_i, 0), outgoing = direction_deg(theta_o, phi_o);
                if (theta_o < 90) samples.push_back({outgoing, incident, Color3f(0.1f)});
                if (theta_o > 90) samples.push_back({incident, outgoing, Color3f(0.2f)});
            }
    const Material sheet = table_material(std::make_shared<GonioTable>(samples, true), "sheet");
    ASSERT_EQ(sheet.lobes.size(), 2u);
    EXPECT_NEAR(sheet.kd.x, 0.1f * kPi, 1e-3f);
    const Vec3f wo = direction_deg(30, 0);
    EXPECT_NEAR(directional_albedo(sheet.lobes[0], wo).x, 0, 1e-3f);
    EXPECT_NEAR(directional_albedo(sheet.lobes[1], wo).x, 0.2f * kPi, 0.01f);
}

TEST(TableMaterial, WhatIsWrongIsNamed) {
    const auto expect = [](const std::string& message, const char* part) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };
    expect(complaint({{"model", "table"}}), "x.table: expected the file of a measurement");
    expect(complaint({{"model", "table"}, {"table", "no.binary"}}), "no.binary: no such file");
    expect(complaint({{"model", "ggx"}, {"table", "no.binary"}}), "table");
    expect(complaint({{"model", "ggx"}, {"kd", "auto"}}), "\"auto\" is for materials with a table");
    expect(complaint({{"model", "table"}, {"table", varnish_folder().file}, {"kt", 1}}), "no transmitted light");
    LobeParameters empty;
    empty.model = ModelId::table;
    EXPECT_THROW(AnyModel{empty}, Error);
}

}  // namespace burnish
