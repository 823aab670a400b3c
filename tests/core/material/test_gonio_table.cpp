// Goniometer tables against closed forms and the real files, and what their readers refuse.
#include <burnish/base/error.h>
#include <burnish/material/measured/gonio_file.h>
#include <burnish/material/measured/read_measured.h>
#include <burnish/material/measured/spectrum_color.h>
#include <core/data.h>
#include <core/material/lobe_cases.h>
#include <core/scratch.h>

#include <gtest/gtest.h>

#include <fstream>
#include <random>

namespace burnish {
namespace {

float relative_error(const Color3f& found, const Color3f& expected) { return (found - expected).length() / expected.length(); }

/// Pairs at measured incident angles, outgoing ones every few degrees, of any function.
template <class F>
std::vector<BrdfSample> sweep(F f, double step_i_deg, double step_o_deg, bool all_azimuths, bool through = false) {
    std::vector<BrdfSample> samples;
    for (double theta_i = 5; theta_i < 85; theta_i += step_i_deg)
        for (double phi_i = 0; phi_i < (all_azimuths ? 360 : 1); phi_i += 15)
            for (double theta_o = 0; theta_o < 85; theta_o += step_o_deg)
                for (double phi_o = 0; phi_o < 360; phi_o += std::max(step_o_deg / std::sin((theta_o + 2) / 57.3), 2.0)) {
                    const Vec3f incident = direction_deg(theta_i, phi_i);
                    const Vec3f outgoing = direction_deg(through ? 180 - theta_o : theta_o, phi_o);
                    const Vec3f wo = through ? incident : outgoing, wi = through ? outgoing : incident;
                    samples.push_back({wo, wi, f(wo, wi)});
                }
    return samples;
}

std::string complaint(const std::string& name, const std::string& text) {
    const Scratch folder;
    std::ofstream(folder.file(name), std::ios::binary) << text;
    try {
        read_measured(folder.file(name));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::read_failed);
        EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
        return error.what();
    }
    return "no complaint";
}

constexpr const char* kHeader =
    "# burnish gonio 1\n# surface isotropic\n# values brdf\n# columns theta_i phi_i theta_o phi_o value\n";

}  // namespace

TEST(GonioTable, GivesBackWhatWasMeasured) {
    const LobeParameters lobe = make_lobe(ModelId::ggx, 0.2f, 0.2f);
    const auto samples = sweep([&](const Vec3f& wo, const Vec3f& wi) { return Ggx(lobe).eval(wo, wi); }, 10, 7, false);
    const GonioTable table(samples, true);
    for (const BrdfSample& s : samples) EXPECT_LT(relative_error(table.eval(s.wo, s.wi), s.f), 1e-4f) << s.wo << " " << s.wi;
}

TEST(GonioTable, FollowsTheHighlightBetweenIncidentDirections) {
    const LobeParameters lobe = make_lobe(ModelId::beckmann, 0.2f, 0.2f);
    const auto f = [&](const Vec3f& wo, const Vec3f& wi) { return Beckmann(lobe).eval(wo, wi); };
    const GonioTable table(sweep(f, 10, 3, false), true);
    for (const double theta_deg : {20.0, 30.0, 40.0, 50.0})  // half way between the measured ones
        for (const double off_deg : {0.0, 5.0, -8.0}) {
            const Vec3f wi = direction_deg(theta_deg, 77), wo = direction_deg(theta_deg + off_deg, 257);
            EXPECT_LT(relative_error(table.eval(wo, wi), f(wo, wi)), 0.06f) << theta_deg << " " << off_deg;
        }
}

TEST(GonioTable, AnisotropicTablesKnowTheAzimuth) {
    const LobeParameters lobe = make_lobe(ModelId::beckmann, 0.15f, 0.4f);
    const auto f = [&](const Vec3f& wo, const Vec3f& wi) { return Beckmann(lobe).eval(wo, wi); };
    const GonioTable table(sweep(f, 10, 4, true), false);
    EXPECT_FALSE(table.is_isotropic());
    for (const double phi_deg : {0.0, 40.0, 97.0, 230.0}) {
        const Vec3f wi = direction_deg(33, phi_deg), wo = direction_deg(38, phi_deg + 180);
        EXPECT_LT(relative_error(table.eval(wo, wi), f(wo, wi)), 0.08f) << phi_deg;
    }
}

TEST(GonioTable, TransmitsWhatWasMeasuredBelow) {
    LobeParameters lobe = make_lobe(ModelId::beckmann, 0.2f, 0.2f, Side::transmission);
    const auto f = [&](const Vec3f& wo, const Vec3f& wi) {
        return visit_lobe(lobe, [&](const auto& through) { return through.eval(wo, wi); });
    };
    const GonioTable table(sweep(f, 10, 3, false, true), true);
    EXPECT_TRUE(table.transmits());
    const Vec3f wo = direction_deg(40, 10), wi = direction_deg(135, 190);
    EXPECT_LT(relative_error(table.eval(wo, wi), f(wo, wi)), 0.06f);
    EXPECT_EQ(table.eval(wo, Vec3f(wi.x, wi.y, -wi.z)), Color3f(0));
}

TEST(GonioTable, WritesWhatItReads) {
    const Scratch folder;
    const LobeParameters lobe = make_lobe(ModelId::kurt, 0.3f, 0.2f);
    auto samples = sweep([&](const Vec3f& wo, const Vec3f& wi) { return Kurt(lobe).eval(wo, wi); }, 20, 20, true);
    samples.push_back({direction_deg(20, 0), direction_deg(150, 30), Color3f(1, 2, 3)});
    write_gonio(samples, false, folder.file("a.gonio"));
    const auto table = read_measured(folder.file("a.gonio"));
    EXPECT_EQ(table->file(), folder.file("a.gonio"));
    EXPECT_FALSE(table->is_isotropic());
    EXPECT_TRUE(table->transmits());
    ASSERT_EQ(table->samples().size(), samples.size());
    for (size_t i = 0; i < samples.size(); ++i) {
        const BrdfSample s = table->samples()[i];
        EXPECT_LT((s.wo - samples[i].wo).length() + (s.wi - samples[i].wi).length(), 1e-6f);
        EXPECT_EQ(s.f, samples[i].f);
    }
}

TEST(GonioTable, TransferProbabilitiesAreDividedByTheOutgoingCosine) {
    const Scratch folder;
    std::ofstream(folder.file("t.txt"))
        << "# burnish gonio 1\n# surface isotropic\n# values transfer\n"
           "# columns theta_i phi_i theta_o phi_o R G B\n# a comment\n10 0 60 180 1 2 3\n30 0 120 0 1 1 1\n";
    const auto samples = read_measured(folder.file("t.txt"))->samples();
    ASSERT_EQ(samples.size(), 2u);
    EXPECT_LT((samples[0].f - Color3f(2, 4, 6)).length(), 1e-5f);
    EXPECT_LT((samples[0].wi - direction_deg(10, 0)).length(), 1e-6f);
    EXPECT_LT((samples[1].f - Color3f(2)).length(), 1e-5f);
    EXPECT_LT((samples[1].wo - direction_deg(30, 0)).length(), 1e-6f);
    EXPECT_LT((samples[1].wi - direction_deg(120, 0)).length(), 1e-6f);
}

TEST(GonioTable, SpectraGetTheirColours) {
    std::vector<double> wavelengths, flat, long_pass, band;
    for (int nm = 400; nm <= 700; nm += 10) {
        wavelengths.push_back(nm), flat.push_back(0.5), long_pass.push_back(nm >= 600), band.push_back(nm > 500 && nm < 570);
    }
    const SpectrumColor color(wavelengths);
    EXPECT_LT((color(flat.data()) - Color3f(0.5f)).length(), 1e-6f);
    const Color3f red = color(long_pass.data()), green = color(band.data());
    EXPECT_GT(red.x, 5 * std::abs(red.y));
    EXPECT_GT(red.x, 5 * std::abs(red.z));
    EXPECT_GT(green.y, 0.5f);
    EXPECT_GT(green.y, 3 * green.x);
    EXPECT_GT(green.y, 3 * green.z);
    const Color3f coarse = SpectrumColor({300, 900})(std::vector<double>{0.2, 0.2}.data());
    EXPECT_LT((coarse - Color3f(0.2f)).length(), 1e-6f);
}

TEST(GonioTable, ReadsCornellsPaints) {
    for (const char* name : {"cayman", "garnet_red", "mystique"}) {
        const auto file = data_path("public/brdf_measured/" + std::string(name) + ".brdf");
        if (!file) GTEST_SKIP() << "no measured data";
        const auto table = read_measured(file->string());
        EXPECT_EQ(table->samples().size(), 1439u);
        EXPECT_TRUE(table->is_isotropic());
        const Color3f mirrored = table->eval(direction_deg(50, 0), direction_deg(50, 180));
        const Color3f aside = table->eval(direction_deg(50, 0), direction_deg(20, 0));
        EXPECT_GT(luminance(mirrored), 5 * luminance(aside)) << name;
        if (name == std::string("garnet_red")) {
            EXPECT_GT(aside.x, 4 * aside.y);
        }
    }
}

TEST(GonioTable, ReadsAltasFiles) {
    const auto tape = data_path("public/brdf_measured/retro-3M-jaune.dat"),
               felt = data_path("public/brdf_measured/pink-felt-1d.alta");
    if (!tape || !felt) GTEST_SKIP() << "no measured data";
    const Vec3f light = direction_deg(30, 0);
    const auto retro = read_measured(tape->string());
    EXPECT_GT(retro->samples().size(), 7000u);
    EXPECT_NEAR(retro->eval(light, light).x, 11.46f / std::cos(0.5236f), 0.2f);
    EXPECT_LT(retro->eval(direction_deg(60, 90), light).x, 1.0f);
    const auto curve = read_measured(felt->string());
    EXPECT_EQ(curve->samples().size(), 90u);
    EXPECT_NEAR(curve->eval(direction_deg(0, 0), direction_deg(0, 0)).x, 0.1097f, 1e-3f);
}

TEST(GonioTable, RefusesWithFileLineAndRemedy) {
    const std::string header = kHeader;
    const auto expect = [](const std::string& message, const char* part) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };
    expect(complaint("a.gonio", ""), "\"# burnish gonio 1\"");
    expect(complaint("a.gonio", "# burnish gonio 1\n1 2 3 4 5\n"), "\"# surface isotropic\"");
    expect(complaint("a.gonio", header), "no row");
    expect(complaint("a.gonio", header + "10 0 20 0\n"), "line 5: expected 5 numbers, found 4");
    expect(complaint("a.gonio", header + "10 0 20 x 1\n"), "line 5: expected a number, found \"x\"");
    expect(complaint("a.gonio", header + "10 0 20 0 nan\n"), "expected a finite number");
    expect(complaint("a.gonio", header + "10 0 20 0 1e999\n"), "expected a number");
    expect(complaint("a.gonio", header + "95 0 20 0 1\n"), "theta_i in [0, 90)");
    expect(complaint("a.brdf", "31\n400 410\n"), "number of wavelengths");
    expect(complaint("a.brdf", "1e300\n400 410\n"), "number of wavelengths");
    expect(complaint("a.brdf", "2\n410 400\n1 0 1 0 1 1\n"), "rising wavelengths");
    expect(complaint("a.brdf", "2\n400 700\n1 0 1 0 1\n"), "copied whole");
    expect(complaint("a.brdf", "# nothing\n"), "holds no numbers");
    expect(complaint("a.dat", "#DIM 3 1\n#PARAM_IN X\n#PARAM_OUT INV_STERADIAN\n"), "#PARAM_IN");
    expect(complaint("a.dat", "#DIM 9 1\n#PARAM_IN COS_TH\n#PARAM_OUT INV_STERADIAN\n"), "#DIM");
    expect(complaint("a.alta", "#DIM 1 3\n#PARAM_IN COS_TH\n#PARAM_OUT RGB_COLOR\n0.5 1 1\n"), "line 4: expected 4 numbers");
    expect(complaint("a.xompt", "{}"), "not a measurement that burnish reads");
}

TEST(GonioTable, StaysFiniteForHostileSamples) {
    std::vector<BrdfSample> samples(500, {direction_deg(0, 0), direction_deg(0, 0), Color3f(1e9f)});  // all in one place
    for (int i = 0; i < 500; ++i) samples.push_back({direction_deg(89.4, i), direction_deg(89.4, i + 180), Color3f(0)});
    for (const bool isotropic : {true, false}) {
        const GonioTable table(samples, isotropic);
        for (double theta_deg = 0; theta_deg < 90; theta_deg += 7.3) {
            const Color3f f = table.eval(direction_deg(theta_deg, 3), direction_deg(90 - theta_deg, 170));
            for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(f[c]) && f[c] >= 0) << theta_deg;
        }
    }
}

}  // namespace burnish
