#include <burnish/base/error.h>
#include <burnish/material/describe.h>
#include <burnish/material/library.h>
#include <burnish/material/metals.h>
#include <burnish/material/model.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace burnish {

using nlohmann::json;

namespace {

Material parsed(const char* text) { return material_from_json(json::parse(text), "brass", "shot.json: materials.brass"); }

/// What reading `text` complains about.
std::string complaint(const char* text) {
    try {
        parsed(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_argument);
        return error.what();
    }
    return "no complaint";
}

void expect_same(const Fresnel& a, const Fresnel& b) {
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.eta, b.eta);
    EXPECT_EQ(a.k, b.k);
    EXPECT_EQ(a.complement, b.complement);
    EXPECT_EQ(a.power, b.power);
}

void expect_same(const LobeParameters& a, const LobeParameters& b) {
    EXPECT_EQ(a.model, b.model);
    EXPECT_EQ(a.side, b.side);
    EXPECT_EQ(a.strength, b.strength);
    EXPECT_EQ(a.tint, b.tint);
    EXPECT_EQ(Vec2f(a.mx, a.my), Vec2f(b.mx, b.my));
    EXPECT_FLOAT_EQ(a.rotation, b.rotation);
    EXPECT_EQ(a.extra, b.extra);
    EXPECT_EQ(a.per_pixel.roughness, b.per_pixel.roughness);
    EXPECT_EQ(a.per_pixel.anisotropy, b.per_pixel.anisotropy);
    EXPECT_EQ(a.per_pixel.rotation, b.per_pixel.rotation);
    EXPECT_EQ(a.per_pixel.tint, b.per_pixel.tint);
    EXPECT_EQ(a.per_pixel.weight, b.per_pixel.weight);
    expect_same(a.fresnel, b.fresnel);
}

struct TemporaryFile {
    std::filesystem::path path;
    TemporaryFile(const std::string& name, const std::string& text) : path(std::filesystem::temp_directory_path() / name) {
        std::ofstream(path) << text;
    }
    ~TemporaryFile() { std::filesystem::remove(path); }
};

}  // namespace

TEST(MaterialJson, ReadsTheShotFilesForm) {
    const Material m = parsed(R"({"model": "kurt", "kd": [0.1, 0.2, 0.3],
        "lobes": [{"ks": 0.8, "tint": [1, 0.5, 0.25], "mx": 0.1, "my": 0.2, "r0": 0.05, "alpha": 0.3, "rotation_deg": 90},
                  {"model": "ggx", "kt": 0.5, "m": 0.05, "ior": 1.5, "per_pixel": ["tint", "roughness"]}]})");
    EXPECT_EQ(m.name, "brass");
    EXPECT_EQ(m.kd, Color3f(0.1f, 0.2f, 0.3f));
    ASSERT_EQ(m.lobes.size(), 2u);
    EXPECT_EQ(m.lobes[0].model, ModelId::kurt);
    EXPECT_EQ(m.lobes[0].strength, 0.8f);
    EXPECT_EQ(m.lobes[0].tint, Color3f(1, 0.5f, 0.25f));
    EXPECT_EQ(Vec2f(m.lobes[0].mx, m.lobes[0].my), Vec2f(0.1f, 0.2f));
    EXPECT_EQ(m.lobes[0].extra, std::vector<float>{0.3f});
    EXPECT_FLOAT_EQ(m.lobes[0].rotation, kPi / 2);
    expect_same(m.lobes[0].fresnel, {FresnelKind::schlick, Color3f(0.05f)});
    EXPECT_EQ(m.lobes[1].model, ModelId::ggx);
    EXPECT_EQ(m.lobes[1].side, Side::transmission);
    EXPECT_EQ(m.lobes[1].strength, 0.5f);
    expect_same(m.lobes[1].fresnel, {FresnelKind::dielectric, Color3f(1.5f), Color3f(0), true});
    EXPECT_TRUE(m.lobes[1].per_pixel.tint && m.lobes[1].per_pixel.roughness && !m.lobes[1].per_pixel.weight);
}

TEST(MaterialJson, ReadsALobesFieldsAtTheTop) {
    const Material m = parsed(R"({"model": "ggx", "roughness": 0.5, "metal": "gold"})");
    ASSERT_EQ(m.lobes.size(), 1u);
    EXPECT_EQ(Vec2f(m.lobes[0].mx, m.lobes[0].my), Vec2f(0.25f));
    EXPECT_EQ(m.lobes[0].fresnel.kind, FresnelKind::conductor);
    EXPECT_GT(m.lobes[0].fresnel(1).x, 2 * m.lobes[0].fresnel(1).z);
    EXPECT_TRUE(parsed(R"({"kd": 0.5})").lobes.empty());
}

TEST(MaterialJson, FillsInTheModelsOwnDefaults) {
    EXPECT_EQ(parsed(R"({"m": 0.1})").lobes[0].extra, std::vector<float>{model_info(ModelId::kurt).parameters[0].value});
}

TEST(MaterialJson, StretchesWidthsAsCyclesDoes) {
    const auto widths = [](const char* text) { return Vec2f(parsed(text).lobes[0].mx, parsed(text).lobes[0].my); };
    const Vec2f stretched = widths(R"({"m": 0.1, "anisotropy": 0.7})"), other = widths(R"({"m": 0.1, "anisotropy": -0.7})");
    EXPECT_FLOAT_EQ(stretched.x, 0.03f);
    EXPECT_FLOAT_EQ(stretched.y, 0.1f / 0.3f);
    EXPECT_EQ(other, Vec2f(stretched.y, stretched.x));
    EXPECT_EQ(widths(R"({"roughness": 0, "anisotropy": 1})").x, 1e-4f);
    EXPECT_LE(widths(R"({"m": 1, "anisotropy": 1})").y, 1);
}

TEST(MaterialJson, ComplaintsNameFieldExpectedFoundAndNearest) {
    const std::pair<const char*, const char*> cases[] = {
        {R"({"rougness": 0.5})", "shot.json: materials.brass: unknown field \"rougness\" (did you mean \"roughness\"?)"},
        {R"({"model": "gxx"})",
         "materials.brass.model: unknown name \"gxx\" (did you mean \"ggx\"?); known: kurt, beckmann, ggx"},
        {R"({"model": "ggx", "alpha": 0.5})", "unknown field \"alpha\""},
        {R"({"lobes": [{"ks": 1}, {"mx": "wide", "my": 1}]})",
         "brass.lobes[1].mx: expected a number from 0.0001 to 1, found \"wide\""},
        {R"({"m": 1.5})", "brass.m: expected a number from 0.0001 to 1, found 1.5"},
        {R"({"m": 0})", "brass.m: expected a number from 0.0001 to 1, found 0"},
        {R"({"alpha": -1})", "brass.alpha: expected a number from 0 to 1, found -1"},
        {R"({"kd": [1, 2]})", "brass.kd: expected a number from 0 to 1 or a list of three, found [1,2]"},
        {R"({"tint": [1, 0, null]})", "brass.tint: expected"},
        {R"({"ks": -0.1})", "brass.ks: expected"},
        {R"({"ks": true})", "brass.ks: expected a number from 0 to 1000, found true"},
        {R"({"ks": 1, "kt": 1})", "both \"ks\" and \"kt\" are given"},
        {R"({"m": 0.1, "roughness": 0.1})", "both \"m\" and \"roughness\" are given"},
        {R"({"mx": 0.1, "my": 0.1, "anisotropy": 0.1})", "both \"mx\" and \"anisotropy\" are given"},
        {R"({"mx": 0.1})", "field \"my\" is missing"},
        {R"({"r0": 0.1, "metal": "gold"})", "both \"r0\" and \"metal\" are given"},
        {R"({"eta": 0.1})", "field \"k\" is missing"},
        {R"({"metal": "golt"})", "brass.metal: unknown name \"golt\" (did you mean \"gold\"?)"},
        {R"({"per_pixel": "tint"})", "brass.per_pixel: expected a list"},
        {R"({"per_pixel": ["tint", "ruoghness"]})",
         "brass.per_pixel[1]: unknown name \"ruoghness\" (did you mean \"roughness\"?)"},
        {R"({"lobes": {}})", "brass.lobes: expected a list of lobes"},
        {R"({"lobes": [], "ks": 1})", "unknown field \"ks\""},
        {R"({"lobes": [[]]})", "brass.lobes[0]: expected an object {...}, found []"},
        {R"([1, 2, 3, 4, 5])", "materials.brass: expected an object {...}, found a list of 5 entries"},
        {R"({})", "materials.brass: expected a lobe"},
        {R"({"model": "blinn_phong"})", "did you mean \"blinn-phong\"?"},
        {R"({"model": "lewis", "mx": 0.1, "my": 0.2})", "brass.model: lewis is a round lobe; give it one width m"},
        {R"({"model": "oren-nayar", "m": 0.1, "anisotropy": 0.5})", "brass.model: oren-nayar is a round lobe"},
        {R"({"model": "phong", "per_pixel": ["anisotropy"]})", "brass.model: phong is a round lobe"},
        {R"({"model": "abc", "C": -1})", "brass.C: expected a number from 0 to 10, found -1"},
        {R"({"r0": 0.5, "f1": 0.1, "dip": 0.1})", "both \"f1\" and \"dip\" are given"},
        {R"({"f1": 0.1})", "field \"r0\" is missing"},
        {R"({"r0": 0.5, "dip": 0.1, "dip_power": 0})", "brass.dip_power: expected a number from 1 to 20, found 0"},
    };
    for (const auto& [text, expected] : cases)
        EXPECT_NE(complaint(text).find(expected), std::string::npos) << text << "\n" << complaint(text);
}

TEST(MaterialJson, RoundTripsEveryPresetAndModel) {
    std::vector<Material> all(presets().begin(), presets().end());
    all.push_back(parsed(R"({"lobes": [{"ks": 0.3, "mx": 0.123, "my": 0.7, "eta": [1, 2, 3], "k": 4.5, "rotation_deg": -33.3},
                                       {"model": "beckmann", "kt": 2, "per_pixel": ["weight", "anisotropy", "rotation"]}]})"));
    for (const Material& material : all) {
        const json written = material_to_json(material);
        const Material again = material_from_json(json::parse(written.dump()), material.name, "again");
        EXPECT_EQ(again.kd, material.kd);
        ASSERT_EQ(again.lobes.size(), material.lobes.size()) << material.name;
        for (size_t i = 0; i < again.lobes.size(); ++i) expect_same(again.lobes[i], material.lobes[i]);
    }
}

TEST(MaterialJson, RoundTripsEveryParameterOfEveryModel) {
    for (const ModelInfo& model : models()) {
        Material material{"all", Color3f(0), {LobeParameters{}}};
        LobeParameters& lobe = material.lobes[0];
        lobe.model = model_by_name(model.name);
        if (lobe.model == ModelId::table) continue;  // shows a file, which no number stands for
        lobe.mx = 0.25f, lobe.my = model.anisotropic ? 0.125f : 0.25f;
        for (const ModelParameter& parameter : model.parameters)
            for (const float share : {0.2f, 0.4f, 0.7f})
                if (share == 0.2f || parameter.per_channel)
                    lobe.extra.push_back(parameter.min + share * (parameter.max - parameter.min));
        const Material again = material_from_json(json::parse(material_to_json(material).dump()), "all", "again");
        expect_same(again.lobes.at(0), lobe);
    }
}

TEST(MaterialJson, RoundTripsCurvesThatBend) {
    const Material m = parsed(R"({"lobes": [{"r0": [0.9, 1.5, 2], "f1": [-0.1, 0.7, 1]}, {"r0": 0.9, "dip": 1.6},
                                            {"r0": 0.9, "dip": [1.5, 1.6, 1.7], "dip_power": 6.5}]})");
    expect_same(m.lobes[0].fresnel, {FresnelKind::generalised_schlick, {0.9f, 1.5f, 2}, {-0.1f, 0.7f, 1}});
    expect_same(m.lobes[1].fresnel, {FresnelKind::lazanyi, Color3f(0.9f), Color3f(1.6f)});
    expect_same(m.lobes[2].fresnel, {FresnelKind::lazanyi, Color3f(0.9f), {1.5f, 1.6f, 1.7f}, false, 6.5f});
    const Material again = material_from_json(json::parse(material_to_json(m).dump()), "brass", "again");
    for (size_t i = 0; i < 3; ++i) expect_same(again.lobes.at(i), m.lobes[i]);
}

TEST(MaterialJson, GivesModelsOfTheirOwnWidthTheirWidth) {
    const float own = parsed(R"({"model": "abc", "B": 200, "C": 1.2})").lobes[0].mx;
    EXPECT_NEAR(own, std::acos(1 - std::expm1(1 / 1.2) / 200), 0.01f);
    EXPECT_EQ(parsed(R"({"model": "abc", "B": 200, "C": 1.2, "m": 0.3})").lobes[0].mx, 0.3f);
}

TEST(MaterialJson, WritesShortNumbers) {
    EXPECT_EQ(material_to_json(parsed(R"({"m": 0.1, "ks": 0.7, "alpha": 0.3})"))["lobes"][0].dump(),
              R"({"alpha":0.3,"ks":0.7,"model":"kurt","mx":0.1,"my":0.1,"tint":1.0})");
}

TEST(Library, HoldsTheNamedPresetsSorted) {
    const auto all = presets();
    EXPECT_GE(all.size(), 14u);
    EXPECT_TRUE(std::ranges::is_sorted(all, {}, &Material::name));
    for (const char* name :
         {"chrome", "gold", "silver", "copper", "aluminium", "brushed-aluminium", "brushed-steel", "plastic-gloss",
          "plastic-satin", "varnish", "lacquer", "porcelain", "rubber", "car-paint", "frosted-glass", "clear-glass"})
        EXPECT_EQ(find_material(name).name, name);
}

TEST(Library, KeepsKurtPresetsWhereMeasuredMaterialsLive) {
    for (const Material& preset : presets())
        for (const LobeParameters& lobe : preset.lobes) {
            if (lobe.model != ModelId::kurt) continue;
            EXPECT_TRUE(lobe.extra[0] >= 0.3f && lobe.extra[0] <= 0.6f) << preset.name;
        }
}

TEST(Library, ReadsAMaterialFromAFile) {
    const TemporaryFile file("burnish-test-brass.json", R"({"model": "ggx", "m": 0.2})");
    const Material material = find_material(file.path.string());
    EXPECT_EQ(material.name, "burnish-test-brass");
    EXPECT_EQ(material.lobes[0].mx, 0.2f);
}

TEST(Library, UnknownNamesGetTheNearestPreset) {
    try {
        find_material("crome");
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("\"crome\" (did you mean \"chrome\"?)"), std::string::npos) << error.what();
    }
}

TEST(Library, BadFilesEndInOneError) {
    const TemporaryFile cut("burnish-test-cut.json", R"({"model": "ggx", )"),
        deep("burnish-test-deep.json", std::string(200000, '[')), big("burnish-test-big.json", std::string(2 << 20, ' ')),
        huge("burnish-test-huge.json", R"({"m": 1e999})"), binary("burnish-test-binary.json", std::string("\0\xff\xfe\x01", 4)),
        key("burnish-test-key.json", "{\"m\xc3\": 1}");
    for (const auto* file : {&cut, &deep, &big, &huge, &binary, &key})
        EXPECT_THROW(find_material(file->path.string()), Error) << file->path;
    EXPECT_THROW(find_material("no/such/file.json"), Error);
    EXPECT_THROW(find_material(std::filesystem::temp_directory_path().string()), Error);
    EXPECT_THROW(find_material(""), Error);
}

TEST(Library, DescribesEveryModelParameterAndPreset) {
    const std::string text = describe_models();
    for (const ModelInfo& model : models()) {
        EXPECT_NE(text.find(model.summary), std::string::npos) << model.name;
        for (const ModelParameter& parameter : model.parameters)
            EXPECT_NE(text.find(parameter.help), std::string::npos) << parameter.name;
    }
    const auto marked = [&](std::string_view mark) {
        std::ptrdiff_t count = 0;
        for (size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) ++count;
        return count;
    };
    EXPECT_EQ(marked("; round only"), std::ranges::count(models(), false, &ModelInfo::anisotropic));
    EXPECT_EQ(marked("; not reciprocal"), std::ranges::count(models(), false, &ModelInfo::reciprocal));
    EXPECT_EQ(marked("; has a width of its own"), std::ranges::count(models(), true, &ModelInfo::own_width));
    for (const Material& preset : presets()) EXPECT_NE(text.find("  " + preset.name + " "), std::string::npos) << preset.name;
}

}  // namespace burnish
