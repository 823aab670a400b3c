// The models' equations against the papers' own form in double precision, published vectors, and what is known of their energy.
#include <burnish/material/albedo.h>
#include <core/data.h>
#include <core/material/lobe_cases.h>

#include <gtest/gtest.h>

#include <fstream>

namespace burnish {

namespace {

struct Angles {
    double cos_theta, tan_theta, cos_phi2, sin_phi2;
    explicit Angles(const Imath::V3d& w) : cos_theta(w.z) {
        const double s2 = w.x * w.x + w.y * w.y;
        tan_theta = std::sqrt(s2) / w.z;
        cos_phi2 = s2 > 0 ? w.x * w.x / s2 : 1;
        sin_phi2 = 1 - cos_phi2;
    }
    /// Projected width along the azimuth.
    double alpha(const LobeParameters& p) const { return std::sqrt(cos_phi2 * p.mx * p.mx + sin_phi2 * p.my * p.my); }
    /// tan^2 (cos^2 / mx^2 + sin^2 / my^2)
    double exponent(const LobeParameters& p) const {
        return tan_theta * tan_theta * (cos_phi2 / p.mx / p.mx + sin_phi2 / p.my / p.my);
    }
};

/// Walter 2007, eq. 25 and 33, anisotropic as in Heitz 2014.
double textbook_D(const LobeParameters& p, const Imath::V3d& h) {
    const Angles a(h);
    const double peak = 1 / (M_PI * p.mx * p.my * std::pow(a.cos_theta, 4));
    if (p.model == ModelId::ggx) return peak / std::pow(1 + a.exponent(p), 2);
    return peak * std::exp(-a.exponent(p));
}

/// Walter 2007, eq. 27 and 34.
double textbook_G1(const LobeParameters& p, const Imath::V3d& w) {
    const Angles angles(w);
    const double at = angles.alpha(p) * angles.tan_theta;
    if (p.model == ModelId::ggx) return 2 / (1 + std::sqrt(1 + at * at));
    const double a = 1 / at;
    return a < 1.6 ? (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a) : 1;
}

double textbook_brdf(const LobeParameters& p, const Imath::V3d& wo, const Imath::V3d& wi) {
    const Imath::V3d h = (wo + wi).normalized();
    const double D = textbook_D(p, h);
    if (p.model == ModelId::kurt) return D / (4 * wo.dot(h) * std::pow(wo.z * wi.z, double(p.extra[0])));
    return D * textbook_G1(p, wo) * textbook_G1(p, wi) / (4 * wo.z * wi.z);
}

float G1(const LobeParameters& p, const Vec3f& w) { return p.model == ModelId::ggx ? Ggx(p).G1(w) : Beckmann(p).G1(w); }

float albedo(float alpha, float m, double theta_deg) {
    LobeParameters p = make_lobe(ModelId::kurt, m, m);
    p.extra = {alpha};
    return directional_albedo(p, direction_deg(theta_deg, 0)).x;
}

}  // namespace

TEST(Equations, EvalIsThePapersForm) {
    for (const LobeParameters& lobe : lobe_grid({Side::reflection}))
        visit_lobe(lobe, [&](const auto& f) {
            for (const double theta_deg : {0.0, 25.0, 60.0, 85.0})
                for (const double offset : {0.0, 0.3, 1.0, 2.5})
                    for (const double turn_deg : {0.0, 50.0, 90.0}) {  // off the mirror direction by about `offset` widths
                        const double away_deg = offset * lobe.mx * 57, t = std::min(89.0, theta_deg + away_deg);
                        const Vec3f wo = direction_deg(theta_deg, turn_deg), wi = direction_deg(t, turn_deg + 180 + away_deg);
                        const double expected = textbook_brdf(lobe, Imath::V3d(wo), Imath::V3d(wi));
                        EXPECT_NEAR(f.eval(wo, wi).x, expected, 2e-3 * expected + 1e-6)
                            << label(lobe, theta_deg) << " offset " << offset;
                    }
        });
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
                        return chart.integral(
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
