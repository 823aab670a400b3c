#include <burnish/frequency/lobe_bandwidth.h>
#include <burnish/material/lobe.h>

#include <gtest/gtest.h>

namespace {

using namespace burnish;

LobeParameters lobe(ModelId model, float mx, float my) {
    LobeParameters p;
    p.model = model, p.mx = mx, p.my = my;
    return p;
}

/// 95 % of a round Gaussian's spectral energy: the light it sees is blurred by exp(-angle^2 / (2 sigma^2)).
float gaussian_limit(float sigma) { return std::sqrt(-std::log(0.05f)) / (2 * kPi * sigma); }

Vec3f at_angle(float theta) { return {std::sin(theta), 0, std::cos(theta)}; }

float octaves(float a, float b) { return std::log2(a / b); }

}  // namespace

TEST(LobeBandwidth, OfAGaussianIsWhatItsSpectrumSays) {
    for (const float sigma : {0.002f, 0.02f, 0.1f}) {
        const LobeBandwidth found(
            [&](const Vec3f& wo, const Vec3f& wi) {
                const Vec3f mirror(-wo.x, -wo.y, wo.z);
                return wi.z > 0 ? std::exp(-(wi - mirror).length2() / (2 * sigma * sigma)) / wi.z : 0.0f;
            },
            LobeSymmetry::isotropic);
        for (const float cos_o : {1.0f, 0.8f, 0.5f})
            EXPECT_NEAR(octaves(found.nu_rho(cos_o), gaussian_limit(sigma)), 0.0f, 0.3f);
    }
}

TEST(LobeBandwidth, GoesLikeOneOverTheWidth) {
    for (const ModelId model : {ModelId::beckmann, ModelId::ggx, ModelId::kurt}) {
        const LobeBandwidth sharp(lobe(model, 0.01f, 0.01f)), wide(lobe(model, 0.1f, 0.1f)),
            mirror(lobe(model, 0.001f, 0.001f));
        for (const float theta : {0.0f, 0.5f, 1.0f}) {
            EXPECT_NEAR(sharp.nu_rho(std::cos(theta)) / wide.nu_rho(std::cos(theta)), 10.0f, 1.0f);
            EXPECT_NEAR(mirror.nu_rho(std::cos(theta)) / sharp.nu_rho(std::cos(theta)), 10.0f, 1.0f);
        }
    }
}

TEST(LobeBandwidth, OfBeckmannIsThatOfItsImage) {
    constexpr float m = 0.03f;
    const LobeBandwidth found(lobe(ModelId::beckmann, m, m));
    // Slopes deviate by m / sqrt 2; a half vector turns the reflection by twice that, 2 cos theta_o across the plane of incidence.
    for (const float theta : {0.0f, 0.5f, 1.0f}) {
        const float across = std::numbers::sqrt2_v<float> * m * std::cos(theta);
        EXPECT_NEAR(octaves(found.nu_rho(std::cos(theta)), gaussian_limit(across)), 0.0f, 0.5f) << theta;
    }
}

TEST(LobeBandwidth, WindowsLieAroundTheLobe) {
    const LobeBandwidth found(lobe(ModelId::beckmann, 0.02f, 0.02f));
    ASSERT_EQ(found.views().size(), 16u);
    for (int view = 0; view < 13; ++view) {
        const Vec3f wo = found.view_direction(view), mirror(-wo.x, -wo.y, wo.z);
        const LobeWindow& window = found.views()[view].window;
        EXPECT_LT((window.centre - mirror).length(), 0.02f) << view;
        // Two and a half deviations of the square of a Gaussian that deviates by sqrt 2 m.
        EXPECT_NEAR(window.along.length() / (2.5f * 0.02f), 1.0f, 0.12f) << view;
        EXPECT_NEAR(window.across.length() / (2.5f * 0.02f * wo.z), 1.0f, 0.12f) << view;
    }
}

TEST(LobeBandwidth, FollowsTheNarrowerWidth) {
    const LobeBandwidth crossed(lobe(ModelId::ggx, 0.3f, 0.03f)), thin(lobe(ModelId::ggx, 0.03f, 0.03f)),
        wide(lobe(ModelId::ggx, 0.3f, 0.3f));
    EXPECT_EQ(crossed.views().size(), 16u * 5u);
    EXPECT_NEAR(octaves(crossed.nu_rho(1.0f), thin.nu_rho(1.0f)), 0.0f, 0.5f);
    EXPECT_GT(octaves(crossed.nu_rho(1.0f), wide.nu_rho(1.0f)), 2.5f);
}

TEST(LobeBandwidth, SymmetriesSpareViews) {
    const LobeParameters p = lobe(ModelId::ggx, 0.2f, 0.04f);
    const LobeFunction f = [&](const Vec3f& wo, const Vec3f& wi) {
        return visit_lobe(p, [&](const auto& own) { return luminance(own.eval(wo, wi)); });
    };
    const LobeBandwidth quarter(f, LobeSymmetry::orthotropic), whole(f, LobeSymmetry::none);
    EXPECT_EQ(whole.views().size(), 256u);
    for (float phi = -3.1f; phi < 3.1f; phi += 0.37f) {
        const Vec3f wo(0.6f * std::cos(phi), 0.6f * std::sin(phi), 0.8f);
        float quarter_sum = 0, whole_sum = 0;
        for (int i = 0; i < 49; ++i) {
            const float dx = 0.03f * static_cast<float>(i % 7 - 3), dy = 0.03f * static_cast<float>(i / 7 - 3);
            const Vec3f wi = Vec3f(-wo.x + dx, -wo.y + dy, wo.z).normalized();
            quarter_sum += quarter.at(wo, wi), whole_sum += whole.at(wo, wi);
        }
        EXPECT_NEAR(octaves(quarter_sum, whole_sum), 0.0f, 0.25f) << wo;
    }
    EXPECT_NEAR(octaves(quarter.nu_rho(0.8f), whole.nu_rho(0.8f)), 0.0f, 0.05f);
}

TEST(LobeBandwidth, IsTheSameThroughAThinSheet) {
    LobeParameters reflection = lobe(ModelId::ggx, 0.05f, 0.05f), transmission = reflection;
    transmission.side = Side::transmission;
    transmission.fresnel = reflection.fresnel = Fresnel{};
    const LobeBandwidth above(reflection), below(transmission);
    const Vec3f wo = at_angle(0.6f), mirror(-wo.x, -wo.y, wo.z);
    EXPECT_NEAR(octaves(above.nu_rho(0.8f), below.nu_rho(0.8f)), 0.0f, 0.2f);
    EXPECT_NEAR(octaves(above.at(wo, mirror), below.at(wo, -wo)), 0.0f, 0.5f);
}

TEST(LobeBandwidth, LocallyItIsThatOfTheLobeAtAnyView) {
    const LobeBandwidth found(lobe(ModelId::beckmann, 0.01f, 0.01f));
    for (float theta = 0.0f; theta < 1.3f; theta += 0.013f) {
        const Vec3f wo = at_angle(theta), mirror(-wo.x, -wo.y, wo.z);
        EXPECT_NEAR(octaves(found.at(wo, mirror), found.nu_rho(wo.z)), 1.2f, 1.2f) << theta;
        EXPECT_GT(found.at(wo, {0, 0, -1}), 0.0f);
    }
}

TEST(LobeBandwidth, ADiffuseLobeLetsLittleThrough) {
    const LobeBandwidth found([](const Vec3f&, const Vec3f& wi) { return wi.z > 0 ? 1 / kPi : 0.0f; }, LobeSymmetry::isotropic);
    for (const float cos_o : {1.0f, 0.5f, 0.1f}) {
        EXPECT_GT(found.nu_rho(cos_o), 0.1f);
        EXPECT_LT(found.nu_rho(cos_o), 1.0f);
    }
}

TEST(LobeBandwidth, ATableIsFoundWhereItsPeakIs) {
    // Back towards the viewer, a tenth of a radian wide: nothing is where the mirror direction is.
    const LobeBandwidth found(
        [](const Vec3f& wo, const Vec3f& wi) { return wi.z > 0 ? std::exp(-(wi - wo).length2() / 0.02f) : 0.0f; },
        LobeSymmetry::isotropic);
    EXPECT_NEAR(octaves(found.nu_rho(0.7f), gaussian_limit(0.1f)), 0.0f, 0.5f);
    const LobeBandwidth black([](const Vec3f&, const Vec3f&) { return 0.0f; }, LobeSymmetry::isotropic);
    EXPECT_EQ(black.nu_rho(0.5f), 0.0f);
    EXPECT_EQ(black.at({0, 0, 1}, {0, 0, 1}), 0.0f);
}
