#include "core/scratch.h"

#include <burnish/base/error.h>
#include <burnish/input/color.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace burnish;

namespace {

/// Sets $OCIO for one test and puts back what was there.
class OcioVariable {
public:
    explicit OcioVariable(const char* value) {
        if (const char* old = std::getenv("OCIO")) m_old = old;
        if (value)
            setenv("OCIO", value, 1);
        else
            unsetenv("OCIO");
    }
    ~OcioVariable() {
        if (m_old.empty())
            unsetenv("OCIO");
        else
            setenv("OCIO", m_old.c_str(), 1);
    }

private:
    std::string m_old;
};

Image pixel(float r, float g, float b) {
    Image image(1, 1, 3);
    image.data = {r, g, b};
    return image;
}

Image converted(Image image, const std::string& from, const std::string& to) {
    const OcioVariable none(nullptr);
    convert(image, from, to, ColorConfig::load());
    return image;
}

void expect_near(const Image& image, const std::vector<float>& expected, float tolerance) {
    ASSERT_EQ(image.data.size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(image.data[i], expected[i], tolerance) << i;
}

template <typename Action>
std::string complaint(Action action) {
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::color_space);
        return error.what();
    }
    return {};
}

std::string write_config(const Scratch& scratch) {
    std::ofstream(scratch.file("config.ocio")) << R"(ocio_profile_version: 2
roles: {default: half, scene_linear: base}
file_rules: [!<Rule> {name: Default, colorspace: default}]
displays: {Monitor: [!<View> {name: Film, colorspace: half}], Other: [!<View> {name: Flat, colorspace: base}]}
colorspaces:
  - !<ColorSpace> {name: base}
  - !<ColorSpace> {name: half, aliases: [my half], to_scene_reference: !<MatrixTransform> {matrix: [2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,0,1]}}
)";
    return scratch.file("config.ocio");
}

}  // namespace

TEST(Color, EncodesSrgbByItsPiecewiseCurve) {
    const auto curve = [](float x) { return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f; };
    expect_near(converted(pixel(0.001f, 0.18f, 1), "lin_rec709", "sRGB"), {curve(0.001f), curve(0.18f), 1}, 1e-5f);
    expect_near(converted(pixel(0.5f, 0.02f, 2), "sRGB", "linear"), {0.2140411f, 0.0015480f, 4.9538f}, 1e-4f);
}

TEST(Color, TurnsAcescgIntoRec709) {
    // The columns of the published Bradford matrix AP1 -> Rec.709.
    expect_near(converted(pixel(1, 0, 0), "ACEScg", "lin_rec709"), {1.70505f, -0.13026f, -0.02400f}, 1e-4f);
    expect_near(converted(pixel(0, 1, 0), "ACEScg", "lin_rec709"), {-0.62179f, 1.14080f, -0.12897f}, 1e-4f);
    expect_near(converted(pixel(1, 1, 1), "lin_ap0", "lin_rec709"), {1, 1, 1}, 1e-4f);
    expect_near(converted(pixel(1, 0, 0), "ACEScg", "ACES2065-1"), {0.69545f, 0.04479f, -0.00553f}, 1e-4f);
    expect_near(converted(converted(pixel(5, 0.1f, 2), "lin_rec709", "ACEScg"), "ACEScg", "lin_rec709"), {5, 0.1f, 2}, 1e-5f);
}

TEST(Color, KnowsTheNamesRenderersUse) {
    for (const char* name :
         {"Linear", "linear", "scene_linear", "lin_srgb", "Linear Rec.709", "Utility - Linear - sRGB", "rendering"})
        expect_near(converted(pixel(0.2f, 0.3f, 0.4f), name, "lin_rec709"), {0.2f, 0.3f, 0.4f}, 0);
    for (const char* name : {"acescg", "lin_ap1", "ACES - ACEScg"})
        expect_near(converted(pixel(0.2f, 0.3f, 0.4f), name, "ACEScg"), {0.2f, 0.3f, 0.4f}, 0);
    expect_near(converted(pixel(0.2f, 0.3f, 0.4f), "raw", "lin_rec709"), {0.2f, 0.3f, 0.4f}, 0);
}

TEST(Color, LeavesAlphaAlone) {
    Image image(2, 1, 4, 0.5f);
    image = converted(image, "lin_rec709", "sRGB");
    EXPECT_EQ(image.data[3], 0.5f);
    EXPECT_EQ(image.data[7], 0.5f);
    EXPECT_NEAR(image.data[4], 0.73536f, 1e-4f);
    EXPECT_THROW(converted(Image(1, 1, 1), "lin_rec709", "sRGB"), Error);
}

TEST(Color, NamesTheSpaceThatMayHaveBeenMeant) {
    const std::string message = complaint([] { converted(pixel(0, 0, 0), "AcesCC", "sRGB"); });
    EXPECT_EQ(message,
              "colour space \"AcesCC\" is not in the config plain (did you mean \"ACEScg\"?); "
              "it has lin_rec709, ACEScg, ACES2065-1, sRGB, raw");
    EXPECT_NE(complaint([] { converted(pixel(0, 0, 0), "sRGB", "lin_ap11"); }).find("\"lin_ap1\""), std::string::npos);
}

TEST(Color, UsesTheConfigOfTheEnvironmentAndThatOfTheSettingFirst) {
    const Scratch scratch;
    const std::string file = write_config(scratch);
    const OcioVariable variable(file.c_str());
    const ColorConfig config = ColorConfig::load();
    EXPECT_EQ(config.name(), file);
    EXPECT_EQ(config.spaces(), (std::vector<std::string>{"base", "half"}));
    Image image = pixel(1, 2, 3);
    convert(image, "My Half", "scene_linear", config);
    expect_near(image, {2, 4, 6}, 0);
    const std::string absent = complaint([&] { ColorConfig::load(scratch.file("absent.ocio")); });
    EXPECT_NE(absent.find("absent.ocio"), std::string::npos) << absent;
}

TEST(Color, ShowsTheDefaultViewOrTheOneAskedFor) {
    const Scratch scratch;
    const ColorConfig config = ColorConfig::load(write_config(scratch));
    Image image = pixel(1, 2, 3);
    apply_view(image, "base", "", "", config);
    expect_near(image, {0.5f, 1, 1.5f}, 0);
    apply_view(image, "base", "Other", "Flat", config);
    expect_near(image, {0.5f, 1, 1.5f}, 0);
    EXPECT_NE(complaint([&] { apply_view(image, "base", "Montor", "", config); }).find("\"Monitor\""), std::string::npos);
    EXPECT_NE(complaint([&] { apply_view(image, "base", "Monitor", "Flat", config); }).find("it has Film"), std::string::npos);
}

TEST(Color, ShowsSrgbWithoutAConfig) {
    const OcioVariable none(nullptr);
    Image image = pixel(0.18f, 1, 0);
    apply_view(image, "lin_rec709", "", "", ColorConfig::load());
    expect_near(image, {0.46136f, 1, 0}, 1e-4f);
}

TEST(Color, SaysWhatToDoAboutBrokenAndUnsupportedConfigs) {
    const Scratch scratch;
    std::ofstream(scratch.file("bad.ocio")) << "{ this: [is not";
    EXPECT_NE(complaint([&] { ColorConfig::load(scratch.file("bad.ocio")); }).find("not a usable"), std::string::npos);
    const OcioVariable variable("/absent/config.ocio");
    EXPECT_NE(complaint([] { ColorConfig::load(); }).find("$OCIO = /absent/config.ocio"), std::string::npos);
    // OpenColorIO 2.2 and newer has built-in configs; what it lacks then is only this file.
    const std::string archive = complaint([&] { ColorConfig::load(scratch.file("absent.ocioz")); });
    EXPECT_NE(archive.find("set --colorconfig or $OCIO"), std::string::npos) << archive;
    const std::string builtin = complaint([&] { ColorConfig::load("ocio://default"); });
    EXPECT_TRUE(builtin.empty() || builtin.find("has no built-in configs") != std::string::npos) << builtin;
}
