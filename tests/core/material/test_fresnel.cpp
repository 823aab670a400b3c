#include <burnish/material/fresnel.h>
#include <burnish/material/metals.h>
#include <core/data.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <fstream>
#include <map>
#include <sstream>

namespace burnish {

namespace {

/// Fresnel's amplitudes for a complex index, straight from the definition.
double fresnel_by_amplitudes(std::complex<double> index, double cos_i) {
    const std::complex<double> root = std::sqrt(index * index - (1 - cos_i * cos_i));
    const auto s = (cos_i - root) / (cos_i + root), p = (index * index * cos_i - root) / (index * index * cos_i + root);
    return 0.5 * (std::norm(s) + std::norm(p));
}

constexpr float kCosines[] = {1, 0.9f, 0.7f, 0.5f, 0.2f, 0.05f, 0.01f};

/// Value of a two-column table at x, linear in between.
double table_value(const std::filesystem::path& file, double x) {
    std::ifstream stream(file);
    std::map<double, double> table;
    for (std::string line; std::getline(stream, line);) {
        double wavelength = 0, value = 0;
        if (std::istringstream(line) >> wavelength >> value) table[wavelength] = value;  // lines of # are comments
    }
    const auto high = table.lower_bound(x), low = std::prev(high);
    return low->second + (high->second - low->second) * (x - low->first) / (high->first - low->first);
}

}  // namespace

TEST(Fresnel, NoneIsOneOnBothSides) {
    Fresnel F;
    EXPECT_EQ(F(0.3f), Color3f(1));
    F.complement = true;
    EXPECT_EQ(F(0.3f), Color3f(1));
}

TEST(Fresnel, SchlickRunsFromR0ToOne) {
    const Fresnel F{FresnelKind::schlick, {0.04f, 0.5f, 1}};
    EXPECT_EQ(F(1), Color3f(0.04f, 0.5f, 1));
    EXPECT_EQ(F(0), Color3f(1));
    EXPECT_NEAR(F(0.5f).x, 0.04f + 0.96f / 32, 1e-6f);
}

TEST(Fresnel, DielectricMatchesTheAmplitudes) {
    for (const float eta : {0.7f, 1.0f, 1.33f, 1.5f, 2.4f})
        for (const float c : kCosines)
            EXPECT_NEAR(dielectric_fresnel(eta, c), fresnel_by_amplitudes(eta, c), 1e-5) << eta << " " << c;
    EXPECT_NEAR(dielectric_fresnel(1.5f, 1), 0.04f, 1e-6f);
    EXPECT_EQ(dielectric_fresnel(1.5f, 0), 1);
    EXPECT_EQ(dielectric_fresnel(0.7f, 0.1f), 1);
}

TEST(Fresnel, ConductorMatchesTheAmplitudes) {
    for (const float eta : {0.12f, 1.0f, 3.5f})
        for (const float k : {0.0f, 1.5f, 10.0f})
            for (const float c : kCosines) {
                if (eta < 1 && k == 0) continue;  // total reflection of a dielectric
                EXPECT_NEAR(conductor_fresnel(eta, k, c), fresnel_by_amplitudes({eta, k}, c), 2e-5)
                    << eta << " " << k << " " << c;
            }
}

TEST(Fresnel, ComplementIsWhatIsLetThrough) {
    Fresnel F{FresnelKind::dielectric, Color3f(1.5f)};
    const Color3f reflected = F(0.4f);
    F.complement = true;
    EXPECT_EQ(F(0.4f), Color3f(1) - reflected);
}

TEST(Fresnel, StaysBetweenZeroAndOneForCosinesSlightlyOutOfRange) {
    for (const FresnelKind kind : {FresnelKind::schlick, FresnelKind::dielectric, FresnelKind::conductor})
        for (const float c : {-1e-3f, 0.0f, 1.0f, 1.0001f}) {
            const Color3f F = Fresnel{kind, Color3f(0.5f), Color3f(2)}(c);
            EXPECT_TRUE(F.x >= 0 && F.x <= 1) << static_cast<int>(kind) << " " << c;
        }
}

TEST(Fresnel, GeneralisedSchlickBendsTheCurveByItsSlope) {
    const Fresnel F{FresnelKind::generalised_schlick, {0.5f, 0.05f, 1.5f}, {0.2f, 0.3f, 0.7f}};
    EXPECT_NEAR(F(1).x, 0.3f, 1e-6f);
    EXPECT_EQ(F(1).y, 0) << "not below black";
    EXPECT_NEAR(F(1).z, 0.8f, 1e-6f);
    EXPECT_EQ(F(0), Color3f(1));
    EXPECT_NEAR(F(0.5f).x, 0.5f + 0.5f / 32 - 0.1f, 1e-6f);
    const Fresnel straight{FresnelKind::generalised_schlick, Color3f(0.3f)}, plain{FresnelKind::schlick, Color3f(0.3f)};
    for (const float c : kCosines) EXPECT_EQ(straight(c), plain(c));
}

TEST(Fresnel, LazanyisDipHalvesSchlicksErrorOnMetals) {
    for (const std::string_view name : {"aluminium", "copper", "chromium"}) {
        const auto metal = std::ranges::find(metals(), name, &Metal::name);
        const auto exact = [&](double c) { return fresnel_by_amplitudes({metal->eta.y, metal->k.y}, c); };
        const float r0 = static_cast<float>(exact(1));
        const Fresnel schlick{FresnelKind::schlick, Color3f(r0)};
        Fresnel lazanyi{FresnelKind::lazanyi, Color3f(r0)};
        double overlap = 0, norm = 0;  // the dip of least squares: what Schlick has too much, along c (1 - c)^power
        for (int i = 0; i <= 100; ++i) {
            const double c = i / 100.0, shape = c * std::pow(1 - c, double(lazanyi.power));
            overlap += shape * (schlick(static_cast<float>(c)).y - exact(c)), norm += shape * shape;
        }
        lazanyi.k = Color3f(static_cast<float>(overlap / norm));
        double plain = 0, dipped = 0;
        for (int i = 0; i <= 100; ++i) {
            const float c = static_cast<float>(i) / 100;
            plain += std::pow(schlick(c).y - exact(c), 2), dipped += std::pow(lazanyi(c).y - exact(c), 2);
        }
        EXPECT_LT(std::sqrt(dipped), 0.5 * std::sqrt(plain)) << name;
    }
}

TEST(Metals, ReflectWhatTheMeasuredSpectraReflect) {
    if (!data_path("public/optics")) GTEST_SKIP() << "set BURNISH_DATA to the data folder for public/optics";
    const std::map<std::string_view, std::string> symbols{{"silver", "Ag"}, {"aluminium", "Al"}, {"gold", "Au"},
                                                          {"copper", "Cu"}, {"chromium", "Cr"},  {"tungsten", "W"}};
    constexpr double kWavelengths_nm[] = {610, 550, 465};  // where Rec.709's primaries weigh most
    for (const Metal& metal : metals()) {
        const std::string base = "public/optics/" + symbols.at(metal.name);
        for (int channel = 0; channel < 3; ++channel) {
            const double nm = kWavelengths_nm[channel];
            const std::complex<double> index(table_value(*data_path(base + ".eta.spd"), nm),
                                             table_value(*data_path(base + ".k.spd"), nm));
            const double F0 = conductor_fresnel(metal.eta[channel], metal.k[channel], 1);
            EXPECT_NEAR(F0, fresnel_by_amplitudes(index, 1), 0.08) << metal.name << " channel " << channel;
        }
    }
}

}  // namespace burnish
