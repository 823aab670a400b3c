// What every model of models.def promises, over a grid of widths, anisotropies, views and both sides.
#include <burnish/base/error.h>
#include <burnish/material/albedo.h>
#include <burnish/sampling/sequence.h>
#include <core/material/lobe_cases.h>

#include <gtest/gtest.h>

#include <random>

namespace burnish {

constexpr double kViews_deg[] = {0, 30, 60, 80, 89};
constexpr double kAzimuth_deg = 40;

TEST(Models, SampleFollowsItsPdf) {
    const std::vector<LobeParameters> lobes = lobe_grid({Side::reflection, Side::transmission});
    const double significance = 0.01 / static_cast<double>(lobes.size() * std::size(kViews_deg));
    std::mt19937 random(2024);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (const LobeParameters& lobe : lobes)
        for (const double theta_deg : kViews_deg) {
            const Vec3f wo = direction_deg(theta_deg, kAzimuth_deg);
            const LobeChart chart(lobe, wo);
            visit_lobe(lobe, [&](const auto& f) {
                const auto draw = [&] { return chart.square(f.sample(wo, {uniform(random), uniform(random)})); };
                const auto density = [&](const SquarePoint& s) {
                    double solid_angle = 0;
                    const Vec3f wi = chart.direction(s, solid_angle);
                    return solid_angle > 0 ? solid_angle * f.pdf(wo, wi) : 0;
                };
                const ChiSquare test = chi_square(20000, 24, draw, density);
                EXPECT_GT(test.p_value, significance)
                    << label(lobe, theta_deg) << " chi2 " << test.statistic << " of " << test.degrees;
                EXPECT_LT(test.mass, 1.004) << label(lobe, theta_deg);
            });
        }
}

TEST(Models, ChiSquareRejectsAWidthFivePercentOff) {
    const LobeParameters drawn = make_lobe(ModelId::ggx, 0.1f, 0.1f), claimed = make_lobe(ModelId::ggx, 0.105f, 0.1f);
    const Vec3f wo = direction_deg(40, kAzimuth_deg);
    const HalfVectorChart chart(drawn, wo);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform(0, 1);
    const auto draw = [&] { return chart.square(Ggx(drawn).sample(wo, {uniform(random), uniform(random)})); };
    const auto density = [&](const SquarePoint& s) {
        double solid_angle = 0;
        const Vec3f wi = chart.direction(s, solid_angle);
        return solid_angle * Ggx(claimed).pdf(wo, wi);
    };
    EXPECT_LT(chi_square(100000, 24, draw, density).p_value, 1e-6);
}

TEST(Models, AlbedoBySamplingAgreesWithBruteForce) {
    for (const LobeParameters& lobe : lobe_grid({Side::reflection}))
        for (const double theta_deg : kViews_deg) {
            const Vec3f wo = direction_deg(theta_deg, kAzimuth_deg);
            visit_lobe(lobe, [&](const auto& f) {
                const double brute =
                    integral(LobeChart(lobe, wo), [&](const Vec3f& wi) { return f.eval(wo, wi).x * std::abs(wi.z); });
                EXPECT_NEAR(directional_albedo(lobe, wo, 16384).x, brute, 0.004 * brute) << label(lobe, theta_deg);
            });
        }
}

TEST(Models, SamplesAreInProportionToTheLobeButForAFactorOrTwo) {
    constexpr uint32_t kDraws = 4096;
    for (const LobeParameters& lobe : lobe_grid({Side::reflection})) {
        if (std::max(lobe.mx, lobe.my) > 0.4f) continue;
        for (const double theta_deg : {0.0, 40.0, 60.0}) {
            const Vec3f wo = direction_deg(theta_deg, kAzimuth_deg);
            double sum = 0, squares = 0;
            visit_lobe(lobe, [&](const auto& f) {
                for (uint32_t i = 0; i < kDraws; ++i) {
                    const Vec3f wi = f.sample(wo, hammersley(i, kDraws));
                    const float pdf = f.pdf(wo, wi), weight = pdf > 0 ? f.eval(wo, wi).x * wi.z / pdf : 0;
                    sum += weight, squares += weight * weight;
                }
            });
            EXPECT_LT(squares * kDraws / (sum * sum) - 1, 1) << label(lobe, theta_deg);  // relative variance of a sample
        }
    }
}

TEST(Models, MicrofacetAreaProjectsToOne) {
    for (const LobeParameters& lobe : lobe_grid({Side::reflection}))
        visit_lobe(lobe, [&](const auto& f) {
            const double mx = slope_scale(lobe) * lobe.mx, my = slope_scale(lobe) * lobe.my;
            double sum = 0;
            const int steps = 1024;
            for (int i = 0; i < steps; ++i)
                for (int j = 0; j < steps; ++j) {
                    const double ta = std::tan(M_PI * ((i + 0.5) / steps - 0.5)),
                                 tb = std::tan(M_PI * ((j + 0.5) / steps - 0.5));
                    const Imath::V3d slope(mx * ta, my * tb, 1), wm = slope / slope.length();
                    sum += f.model.D(Vec3f(wm)) * std::pow(wm.z, 4) * (1 + ta * ta) * (1 + tb * tb);
                }
            EXPECT_NEAR(sum * mx * my * M_PI * M_PI / steps / steps, 1, 1e-4) << label(lobe, 0);
        });
}

TEST(Models, EvalIsReciprocalWhereClaimed) {
    for (const LobeParameters& lobe : lobe_grid({Side::reflection})) {
        if (!model_info(lobe.model).reciprocal) continue;
        visit_lobe(lobe, [&](const auto& f) {
            for (const double theta_deg : {3.0, 40.0, 70.0, 88.0}) {
                const Vec3f wo = direction_deg(theta_deg, 10), wi = direction_deg(0.9 * theta_deg, 185);
                const float forth = f.eval(wo, wi).x, back = f.eval(wi, wo).x;
                EXPECT_NEAR(forth, back, 1e-5f * forth) << label(lobe, theta_deg);
            }
        });
    }
}

TEST(Models, BorderLeavesItsShareOfTheSlopesOutside) {
    for (size_t model = 0; model < models().size(); ++model)
        for (const float m : {0.01f, 0.3f, 1.0f})
            for (const float xi : {0.5f, 0.1f, 0.01f}) {
                const LobeParameters lobe = make_lobe(static_cast<ModelId>(model), m, m);
                visit_lobe(lobe, [&](const auto& f) {
                    const int steps = 20000;  // the share of the slopes within r: integral of D cos^4 2 pi tan dtan
                    const double step = f.model.border(xi) / steps;
                    double inside = 0;
                    for (int i = 0; i < steps; ++i) {
                        const double tan_theta = m * (i + 0.5) * step, cos_theta = 1 / std::sqrt(1 + tan_theta * tan_theta);
                        const Vec3f wm(static_cast<float>(tan_theta * cos_theta), 0, static_cast<float>(cos_theta));
                        inside += f.model.D(wm) * std::pow(cos_theta, 4) * 2 * M_PI * tan_theta * m * step;
                    }
                    EXPECT_NEAR(1 - inside, xi, 1e-4) << label(lobe, 0);
                });
            }
}

TEST(Models, WithWidthsIsTheLobeOfThoseWidths) {
    for (size_t model = 0; model < models().size(); ++model) {
        const LobeParameters wide = make_lobe(static_cast<ModelId>(model), 0.4f, 0.2f);
        LobeParameters narrow = wide;
        narrow.mx = 0.05f, narrow.my = 0.1f;
        const Vec3f wo = direction_deg(50, 20), wi = direction_deg(45, 210);
        const float changed = visit_lobe(wide, [&](const auto& f) { return f.with_widths(0.05f, 0.1f).eval(wo, wi).x; });
        EXPECT_EQ(changed, visit_lobe(narrow, [&](const auto& f) { return f.eval(wo, wi).x; })) << models()[model].name;
    }
}

TEST(Models, NothingIsReflectedFromOrToBelowTheSurface) {
    for (const LobeParameters& lobe : lobe_grid({Side::reflection}))
        visit_lobe(lobe, [&](const auto& f) {
            const Vec3f above = direction_deg(30, 0), below = direction_deg(120, 0), edge(1, 0, 0);
            for (const auto& [wo, wi] :
                 {std::pair(above, below), {below, above}, {below, below}, {edge, above}, {above, edge}}) {
                EXPECT_EQ(f.eval(wo, wi), Color3f(0)) << label(lobe, 30);
                EXPECT_EQ(f.pdf(wo, wi), 0) << label(lobe, 30);
            }
        });
}

TEST(Models, TransmissionMirrorsReflection) {
    for (size_t model = 0; model < models().size(); ++model) {
        const LobeParameters reflect = make_lobe(static_cast<ModelId>(model), 0.1f, 0.2f);
        LobeParameters transmit = reflect;
        transmit.side = Side::transmission;
        const Vec3f wo = direction_deg(40, 0), wi = direction_deg(35, 180), through(wi.x, wi.y, -wi.z);
        const auto reflected = visit_lobe(reflect, [&](const auto& f) { return f.eval(wo, wi); });
        EXPECT_GT(reflected.x, 0);
        EXPECT_EQ(reflected, visit_lobe(transmit, [&](const auto& f) { return f.eval(wo, through); }));
        EXPECT_EQ(Color3f(0), visit_lobe(transmit, [&](const auto& f) { return f.eval(wo, wi); }));
    }
}

TEST(Models, StayFiniteAtTheExtremes) {
    const float edges[] = {0.0f, 0.25f, 0.5f, 0.75f, 0.99999994f};
    for (size_t model = 0; model < models().size(); ++model)
        for (const float m : {0.0f, 1e-4f, 1e-3f, 1.0f})
            for (const float z : {1.0f, 0.5f, 1e-3f, 2e-6f, 1e-7f, 1e-30f, 0.0f, -0.5f}) {
                const LobeParameters lobe = make_lobe(static_cast<ModelId>(model), m, std::max(m, 1e-3f));
                const Vec3f wo(std::sqrt(1 - z * z), 0, z);
                visit_lobe(lobe, [&](const auto& f) {
                    for (const float u : edges)
                        for (const float v : edges) {
                            const Vec3f wi = f.sample(wo, {u, v});
                            EXPECT_TRUE(z <= 0 || is_finite(wi)) << label(lobe, z) << " u " << u << " " << v;
                            const float value = f.eval(wo, wi).x, pdf = f.pdf(wo, wi);
                            EXPECT_TRUE(std::isfinite(value) && value >= 0) << label(lobe, z) << " eval " << value;
                            EXPECT_TRUE(std::isfinite(pdf) && pdf >= 0) << label(lobe, z) << " pdf " << pdf;
                        }
                    EXPECT_TRUE(std::isfinite(f.eval(wo, Vec3f(-wo.x, 0, wo.z)).x));
                });
            }
}

TEST(Models, UnknownNamesGetTheNearestOne) {
    EXPECT_EQ(model_by_name("ggx"), ModelId::ggx);
    try {
        model_by_name("beckman");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_argument);
        EXPECT_NE(std::string(error.what()).find("did you mean \"beckmann\"?"), std::string::npos) << error.what();
    }
}

}  // namespace burnish
