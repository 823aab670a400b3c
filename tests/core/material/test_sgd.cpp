// Shifted gamma slopes and the sgd lobe against independent forms: Boost's gamma functions, brute force, the published rows.
#include <burnish/base/error.h>
#include <burnish/material/albedo.h>
#include <burnish/material/any_model.h>
#include <burnish/material/library.h>
#include <burnish/material/measured_library.h>
#include <burnish/material/sgd/sgd_data.h>
#include <core/material/lobe_cases.h>
#include <core/material/sgd_rows.h>

#include <gtest/gtest.h>
#include <boost/math/special_functions/expint.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <random>
#include <set>

namespace burnish {
namespace {

constexpr const char* kPublished = "sgd_bagher2012_bbm.csv";
constexpr std::pair<double, double> kSpread[] = {{1.6e-5, 0.3}, {1e-4, 1.7}, {0.01, 0}, {0.01, 1}, {0.1, 0.5}, {0.85, 1.2}};

/// Gamma(s, x) by Boost, which has s > 0 and s = 0: below, by Gamma(s, x) = (Gamma(s + 1, x) - x^s e^-x) / s.
double boost_upper_gamma(double s, double x) {
    if (s > 0) return boost::math::tgamma(s, x);
    if (s == 0) return boost::math::expint(1, x);
    return (boost_upper_gamma(s + 1, x) - std::pow(x, s) * std::exp(-x)) / s;
}

/// Integral of (w . m) D(m) over the normals that w sees, from its definition: slopes (s cos phi, s sin phi), midpoints.
double projected_area(const ShiftedGamma& slopes, double theta) {
    const int radii = 3000, azimuths = 512;
    const double low = std::log(std::sqrt(slopes.shift()) * 1e-5),
                 step = (std::log(7 * std::sqrt(slopes.decay())) - low) / radii;
    double sum = 0;
    for (int i = 0; i < radii; ++i) {
        const double s = std::exp(low + (i + 0.5) * step);
        double seen = 0;
        for (int j = 0; j < azimuths; ++j)
            seen += std::max(std::cos(theta) - std::sin(theta) * s * std::cos(2 * M_PI * (j + 0.5) / azimuths), 0.0) / azimuths;
        sum += seen * slopes.density(s * s) * 2 * s * s * step;
    }
    return sum;
}

/// f of a row as the authors wrote it, in double.
double published_f(const SgdRow& row, int k, const Vec3f& wo, const Vec3f& wi) {
    const Imath::V3d o(wo), i(wi), h = (o + i).normalized();
    const auto G1 = [&](double z) {
        const double theta = std::acos(std::min(z, 1.0)), lambda = row.at("lambda", k), above = theta - row.at("theta0", k);
        return std::clamp(1 + lambda * (1 - std::exp(row.at("c", k) * std::pow(std::max(above, 0.0), row.at("k", k)))), 0.0,
                          1.0);
    };
    const double alpha = row.at("alpha", k), z2 = h.z * h.z, x = (1 - z2) / z2, ax = alpha + x / alpha, c = o.dot(h);
    const double D = row.at("kap", k) * std::exp(-ax) / (M_PI * std::pow(ax, row.at("p", k)) * z2 * z2);
    const double F = row.at("F0", k) - row.at("F1", k) * c + (1 - row.at("F0", k)) * std::pow(1 - c, 5);
    return std::max(F, 0.0) * D * G1(o.z) * G1(i.z) / (M_PI * o.z * i.z);
}

/// Lobes of real materials, narrow to wide, at their own width and stretched.
std::vector<LobeParameters> real_lobes() {
    const std::set<std::string> wanted{"chrome-steel", "brass", "red-phenolic", "gold-paint", "blue-rubber", "pink-felt"};
    std::vector<LobeParameters> lobes;
    for (const SgdRow& row : sgd_rows(kPublished)) {
        if (!wanted.contains(row.material)) continue;
        LobeParameters lobe = sgd_lobe(row, false);
        lobe.mx = lobe.my = prepare(lobe);
        lobes.push_back(lobe);
        lobe.mx *= 0.4f;
        lobes.push_back(lobe);
    }
    return lobes;
}

}  // namespace

TEST(Sgd, IncompleteGammaMatchesBoost) {
    for (const double s : {2.5, 1.0, 0.5, 0.05, 0.0, -0.3, -0.78})
        for (const double x : {1.6e-5, 1e-3, 0.1, 1.0, 30.0})
            EXPECT_NEAR(upper_gamma(s, x) / boost_upper_gamma(s, x), 1, 1e-12) << s << " " << x;
}

TEST(Sgd, SlopesIntegrateToOneAndToTheirShares) {
    for (const auto& [alpha, p] : kSpread) {
        const ShiftedGamma slopes(alpha, p);
        const double low = 2 * std::log(alpha) - 30, step = (std::log(40 * alpha) - low) / 20000;
        double mass = 0, beyond = 0;
        for (int i = 0; i < 20000; ++i) {
            const double x = std::exp(low + (i + 0.5) * step), share = slopes.density(x) * x * step;
            mass += share, beyond += x > 0.1 * alpha ? share : 0;
        }
        EXPECT_NEAR(mass, 1, 1e-9) << alpha << " " << p;
        EXPECT_NEAR(slopes.share_beyond(0), 1, 1e-12);
        EXPECT_NEAR(slopes.share_beyond(0.1 * alpha), beyond, 2e-3) << alpha << " " << p;  // of a cell
    }
}

TEST(Sgd, ShadowingIsSmithsOfTheProjectedArea) {
    for (const auto& [alpha, p] : kSpread) {
        const ShiftedGamma slopes(alpha, p);
        const SmithTable table(slopes);
        for (const double theta_deg : {20.0, 60.0, 80.0, 88.0, 89.7}) {
            const double theta = theta_deg * M_PI / 180, brute = std::cos(theta) / projected_area(slopes, theta);
            EXPECT_NEAR(slopes.G1(1 / std::tan(theta)), brute, 2e-5) << alpha << " " << p << " " << theta_deg;
            EXPECT_NEAR(table.G1(static_cast<float>(1 / std::tan(theta))), slopes.G1(1 / std::tan(theta)), 2e-6) << theta_deg;
        }
        EXPECT_EQ(table.G1(0), 0);
        EXPECT_EQ(table.G1(std::numeric_limits<float>::infinity()), 1);
    }
}

TEST(Sgd, FourParametersFitSmithsShadowing) {
    for (const auto& [alpha, p] : {std::pair{1.6e-5, 0.3}, {0.01, 1.2}, {0.3, 0.78}, {0.85, 0.9}}) {
        const ShadowingFit fit = fit_g1(alpha, p);
        EXPECT_LT(fit.l2, 1e-6) << alpha << " " << p;
        EXPECT_EQ(shadowing_error(FittedShadowing(fit.lambda, fit.c, fit.k), ShiftedGamma(alpha, p)), fit.l2);
    }
}

TEST(Sgd, TranscriptionsOfThePublishedFitsAgree) {
    const std::vector<SgdRow> rows = sgd_rows(kPublished), others = sgd_rows("sgd_bagher2012.csv");
    if (rows.empty()) GTEST_SKIP() << "no test data";
    ASSERT_EQ(rows.size(), 100u);
    ASSERT_EQ(others.size(), 100u);
    for (size_t i = 0; i < rows.size(); ++i)
        for (const auto& [column, values] : rows[i].columns)
            for (int k = 0; k < 3; ++k) {
                const double value = rows[i].at(column, k), other = others[i].at(column, k);
                const bool rounded = rows[i].material == "chrome" || rows[i].material == "chrome-steel" || other == 1e38;
                EXPECT_TRUE(rounded || std::abs(value - other) <= 1e-5 * std::abs(value)) << rows[i].material << " " << column;
            }
}

TEST(Sgd, PublishedScaleIsTheClosedForm) {
    for (const SgdRow& row : sgd_rows(kPublished))
        for (int k = 0; k < 3; ++k) {
            const double alpha = row.at("alpha", k), closed = 1 / (alpha * upper_gamma(1 - row.at("p", k), alpha));
            EXPECT_NEAR(row.at("kap", k) / closed, 1, 6e-6) << row.material;
        }
}

TEST(Sgd, EvaluatesThePublishedFitsAsTheirAuthorsDo) {
    for (const SgdRow& row : sgd_rows(kPublished)) {
        LobeParameters lobe = sgd_lobe(row, true);
        if (lobe.extra[9] == 1e38f || lobe.extra[10] == 1e38f || lobe.extra[11] == 1e38f) continue;  // c beyond float
        lobe.mx = lobe.my = prepare(lobe);
        const AnyModel model(lobe);
        for (const auto& [o, i, phi] :
             {std::tuple{0.0, 0.5, 0.0}, {30.0, 30.3, 180.0}, {20.0, 60.0, 100.0}, {70.0, 72.0, 178.0}}) {
            const Vec3f wo = direction_deg(o, 0), wi = direction_deg(i, phi), f(model.eval(wo, wi));
            for (int k = 0; k < 3; ++k) {
                const double expected = published_f(row, k, wo, wi);
                EXPECT_NEAR(f[k], expected, 1e-3 * expected + 1e-6) << row.material << " " << o << " " << i;
            }
        }
    }
}

TEST(Sgd, LibraryHoldsThePublishedNumbers) {
    EXPECT_EQ(library_names().size(), 100u);
    for (const SgdRow& row : sgd_rows(kPublished)) {
        const Material material = find_material("merl:" + row.material);
        const LobeParameters &lobe = material.lobes.at(0), expected = sgd_lobe(row, false);
        EXPECT_TRUE(std::equal(lobe.extra.begin(), lobe.extra.begin() + 9, expected.extra.begin())) << row.material;
        EXPECT_EQ(lobe.tint, expected.tint) << row.material;
        EXPECT_EQ(lobe.fresnel.kind, expected.fresnel.kind);
        EXPECT_EQ(lobe.fresnel.eta, expected.fresnel.eta);
        EXPECT_EQ(lobe.fresnel.k, expected.fresnel.k);
        EXPECT_EQ(lobe.mx, AnyModel(lobe).own_width());
        for (int k = 0; k < 3; ++k) EXPECT_EQ(material.kd[k], static_cast<float>(row.at("rhoD", k))) << row.material;
    }
}

TEST(Sgd, MistypedLibraryNamesGetTheNearestOnes) {
    const auto complaint = [](const char* name) {
        try {
            find_material(name);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("no complaint");
    };
    EXPECT_NE(complaint("merl:bras").find("did you mean \"merl:brass\"?"), std::string::npos) << complaint("merl:bras");
    EXPECT_NE(complaint("brass").find("did you mean \"merl:brass\"?"), std::string::npos) << complaint("brass");
    EXPECT_NE(complaint("merl:phenolic").find("merl:red-phenolic"), std::string::npos) << complaint("merl:phenolic");
}

TEST(Sgd, SamplesRealMaterialsAsItsPdfSays) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (const LobeParameters& lobe : real_lobes())
        for (const double theta_deg : {0.0, 50.0, 85.0}) {
            const Vec3f wo = direction_deg(theta_deg, 40);
            const HalfVectorChart chart(lobe, wo);
            const AnyModel f(lobe);
            const auto draw = [&] { return chart.square(f.sample(wo, {uniform(random), uniform(random)})); };
            const auto density = [&](const SquarePoint& s) {
                double solid_angle = 0;
                const Vec3f wi = chart.direction(s, solid_angle);
                return solid_angle > 0 ? solid_angle * f.pdf(wo, wi) : 0;
            };
            const ChiSquare test = chi_square(20000, 24, draw, density);
            EXPECT_GT(test.p_value, 1e-4) << label(lobe, theta_deg) << " chi2 " << test.statistic << " of " << test.degrees;
        }
}

TEST(Sgd, AlbedoOfRealMaterialsMatchesBruteForce) {
    for (const LobeParameters& lobe : real_lobes())
        for (const double theta_deg : {0.0, 60.0, 85.0}) {
            const Vec3f wo = direction_deg(theta_deg, 40);
            const AnyModel f(lobe);
            const double brute = integral(
                HalfVectorChart(lobe, wo), [&](const Vec3f& wi) { return f.eval(wo, wi).y * std::abs(wi.z); }, 1024);
            EXPECT_NEAR(directional_albedo(lobe, wo, 16384).y, lobe.tint.y * brute, 0.006 * brute) << label(lobe, theta_deg);
        }
}

TEST(Sgd, CopiesWithEditedNumbersMakeTheirOwnData) {
    LobeParameters lobe = make_lobe(ModelId::sgd, 0.1f, 0.1f);
    prepare(lobe);
    EXPECT_EQ(AnyModel(lobe).data(), lobe.data);
    LobeParameters wider = lobe, fresh = lobe;
    wider.extra[0] = fresh.extra[0] = 0.3f;
    fresh.data = nullptr;
    const Vec3f wo = direction_deg(50, 20), wi = direction_deg(45, 210);
    EXPECT_NE(AnyModel(wider).eval(wo, wi), AnyModel(lobe).eval(wo, wi));
    EXPECT_EQ(AnyModel(wider).eval(wo, wi), AnyModel(fresh).eval(wo, wi));
    EXPECT_EQ(AnyModel(wider).own_width(), AnyModel(fresh).own_width());
}

}  // namespace burnish
