// The models' equations against the papers' own form in double precision, published vectors, and what is known of their energy.
#include <burnish/material/albedo.h>
#include <core/data.h>
#include <core/material/lobe_cases.h>
#include <core/material/textbook.h>

#include <gtest/gtest.h>

#include <fstream>
#include <set>

namespace burnish {

namespace {

float G1(const LobeParameters& p, const Vec3f& w) { return p.model == ModelId::ggx ? Ggx(p).G1(w) : Beckmann(p).G1(w); }

/// What a direction in float means: of length one in double, too.
Imath::V3d unit(const Vec3f& w) { return Imath::V3d(w).normalized(); }

float albedo(float alpha, float m, double theta_deg) {
    LobeParameters p = make_lobe(ModelId::kurt, m, m);
    p.extra = {alpha};
    return directional_albedo(p, direction_deg(theta_deg, 0)).x;
}

}  // namespace

TEST(Equations, EvalIsThePapersForm) {
    std::set<ModelId> compared;
    for (const LobeParameters& lobe : lobe_grid({Side::reflection}))
        visit_lobe(lobe, [&](const auto& f) {
            for (const double theta_deg : {0.0, 25.0, 60.0, 85.0})
                for (const double offset : {0.0, 0.3, 1.0, 2.5})
                    for (const double turn_deg : {0.0, 50.0, 90.0}) {  // off the mirror direction by about `offset` widths
                        const double away_deg = offset * lobe.mx * 57, t = std::min(89.0, theta_deg + away_deg);
                        const Vec3f wo = direction_deg(theta_deg, turn_deg), wi = direction_deg(t, turn_deg + 180 + away_deg);
                        const auto expected = textbook::brdf(lobe, unit(wo), unit(wi));
                        if (!expected) continue;
                        compared.insert(lobe.model);
                        EXPECT_NEAR(f.eval(wo, wi).x, *expected, 2e-3 * *expected + 1e-6)
                            << label(lobe, theta_deg) << " offset " << offset;
                    }
        });
    EXPECT_EQ(compared.size(), 12u);
}

TEST(Equations, LafortuneTurnsItsAxisAsPrinted) {
    for (const auto& [cxy, cz] : {std::pair(-0.579f, 0.574f), {-0.6f, 0.5f}, {-0.5f, 0.6f}, {0.7f, 0.7f}, {-0.7f, 1e-6f}})
        for (const float m : {0.03f, 0.2f, 0.6f}) {
            LobeParameters lobe = make_lobe(ModelId::lafortune, m, m);
            lobe.extra = {cxy, cz};
            for (const double theta_deg : {0.0, 20.0, 50.0, 80.0})
                for (const double azimuth_deg : {0.0, 170.0, 180.0}) {
                    const Vec3f wo = direction_deg(theta_deg, 30), wi = direction_deg(theta_deg + 5, 30 + azimuth_deg);
                    const double expected = *textbook::brdf(lobe, unit(wo), unit(wi));
                    EXPECT_NEAR(visit_lobe(lobe, [&](const auto& f) { return f.eval(wo, wi).x; }), expected,
                                2e-3 * expected + 1e-6)
                        << label(lobe, theta_deg) << " cxy " << cxy << " cz " << cz;
                }
        }
}

TEST(Equations, AbcIsThePapersFormAtItsOwnWidth) {
    for (const float B : {5.0f, 300.0f, 1e5f})
        for (const float C : {0.02f, 0.9999999f, 1.0f, 1.5f, 2.7f}) {
            LobeParameters lobe = make_lobe(ModelId::abc, 0.1f, 0.1f);
            lobe.extra = {B, C};
            lobe.mx = lobe.my = prepare(lobe);
            for (const double theta_deg : {0.0, 40.0, 80.0})
                for (const double away_deg : {0.0, 1.0, 30.0, 80.0}) {
                    const Vec3f wo = direction_deg(theta_deg, 20), wi = direction_deg(theta_deg, 200 + away_deg);
                    const Imath::V3d o = unit(wo), i = unit(wi), h = (o + i).normalized();
                    const double expected = textbook::abc_D(B, C, h) * textbook::groove_G(o, i, h) / (4 * o.z * i.z);
                    EXPECT_NEAR(visit_lobe(lobe, [&](const auto& f) { return f.eval(wo, wi).x; }), expected, 1e-3 * expected)
                        << "B " << B << " C " << C << " theta " << theta_deg << " away " << away_deg;
                }
        }
}

TEST(Equations, AbcStretchedToAnotherWidthHasItsSlopesStretched) {
    LobeParameters own = make_lobe(ModelId::abc, 0.1f, 0.1f);
    own.mx = own.my = prepare(own);
    LobeParameters wide = own;
    wide.mx = 2 * own.mx, wide.my = 3 * own.my;
    for (const float x : {0.0f, 0.02f, 0.3f})
        for (const float y : {0.0f, 0.05f}) {
            const auto slope_density = [&](const LobeParameters& lobe, float sx, float sy) {
                const Vec3f wm = Vec3f(sx, sy, 1).normalized();
                return visit_lobe(lobe, [&](const auto& f) { return f.D(wm) * std::pow(wm.z, 4.0f); });
            };
            const float expected = slope_density(own, x, y) / 6;
            EXPECT_NEAR(slope_density(wide, 2 * x, 3 * y), expected, 1e-5f * expected) << x << " " << y;
        }
}

TEST(Equations, MasksAsManyMicrofacetsAsTurnAway) {
    for (const ModelId model : {ModelId::ggx, ModelId::beckmann})
        for (const float m : {0.05f, 0.3f, 1.0f})
            for (const float stretch : {1.0f, 0.25f})
                for (const double theta_deg : {0.0, 45.0, 75.0, 87.0}) {
                    const LobeParameters p = make_lobe(model, m, m * stretch);
                    const Vec3f wo = direction_deg(theta_deg, 30);
                    const HalfVectorChart chart(p, wo);
                    const double seen = visit_lobe(p, [&](const auto& f) {  // integral of D (wo.wm)+ dwm, dwi = 4 (wo.wm) dwm
                        return integral(
                            chart,
                            [&](const Vec3f& wi) {
                                const Vec3f wm = HalfVector(wo, wi).wm;
                                return f.model.D(wm.z > 0 ? wm : -wm) / 4;
                            },
                            1024);
                    });
                    const double tolerance = model == ModelId::ggx ? 2e-4 : 4e-3;  // Beckmann: the rational fit
                    EXPECT_NEAR(G1(p, wo), wo.z / seen, tolerance) << label(p, theta_deg);
                    if (model != ModelId::beckmann) continue;
                    EXPECT_NEAR(visible_area(BeckmannDistribution(p.mx, p.my), wo), seen, 2e-4 * seen) << label(p, theta_deg);
                }
}

TEST(Equations, MatchMitsubasMicrofacetVectors) {
    const auto file = data_path("public/reference/mitsuba_microfacet_vectors.csv");
    if (!file) GTEST_SKIP() << "set BURNISH_DATA to the data folder for public/reference/mitsuba_microfacet_vectors.csv";
    std::ifstream csv(*file);
    std::string line, field;
    std::getline(csv, line);
    int rows = 0;
    for (; std::getline(csv, line); ++rows) {
        std::istringstream text(line);
        std::vector<std::string> v;
        while (std::getline(text, field, ',')) v.push_back(field);
        ASSERT_EQ(v.size(), 7u);
        const LobeParameters p = make_lobe(model_by_name(v[0]), std::stof(v[1]), std::stof(v[2]));
        const double degrees = 180 / M_PI;
        const Vec3f w = direction_deg(std::stod(v[4]) * degrees, std::stod(v[5]) * degrees);
        const double expected = std::stod(v[6]);
        double found = 0;
        if (v[3] == "G1")
            found = G1(p, w);
        else
            found = visit_lobe(p, [&](const auto& f) { return f.model.D(w) * (v[3] == "D" ? 1 : w.z); });
        EXPECT_NEAR(found, expected, 1e-4 * expected + 1e-5) << line;
    }
    EXPECT_EQ(rows, 320);
}

TEST(Kurt, WithAlphaZeroNeverCreatesEnergyAndFallsLikeTheCosine) {
    for (const float m : {0.01f, 0.05f, 0.2f, 0.5f, 1.0f})
        for (const double theta_deg : {0.0, 30.0, 60.0, 75.0, 85.0, 89.0})
            EXPECT_LE(albedo(0, m, theta_deg), 1.001) << m << " " << theta_deg;
    EXPECT_NEAR(albedo(0, 0.05f, 75), 0.26f, 0.01f);
    for (const double theta_deg : {30.0, 60.0, 75.0})
        EXPECT_NEAR(albedo(0, 0.02f, theta_deg) / std::cos(theta_deg * M_PI / 180), 1, 0.01) << theta_deg;
}

TEST(Kurt, GrowsBrighterAtGrazingAnglesWithAlphaUntilItCreatesEnergy) {
    for (const double theta_deg : {60.0, 75.0, 85.0})
        EXPECT_LT(albedo(0.3f, 0.1f, theta_deg), albedo(0.6f, 0.1f, theta_deg)) << theta_deg;
    EXPECT_LT(albedo(0.5f, 0.1f, 80), 1);
    EXPECT_GT(albedo(1, 0.1f, 85), 1);
}

}  // namespace burnish
