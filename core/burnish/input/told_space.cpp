#include <burnish/input/told_space.h>

#include <burnish/base/error.h>
#include <burnish/input/exr_file.h>
#include <burnish/input/metadata_spec.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace burnish {
namespace {

/// x, y of red, green, blue and white.
struct Primaries {
    const char* space;
    std::array<float, 8> xy;
};
constexpr Primaries kPrimaries[] = {{"lin_rec709", {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f}},
                                    {"ACEScg", {0.713f, 0.293f, 0.165f, 0.830f, 0.128f, 0.044f, 0.32168f, 0.33767f}},
                                    {"ACES2065-1", {0.7347f, 0.2653f, 0.0f, 1.0f, 0.0001f, -0.0770f, 0.32168f, 0.33767f}}};

constexpr const char* kNames[] = {"arnold/color_space", "colorInteropID"};

ToldSpace space_of_primaries(const Metadata& metadata) {
    const OIIO::ParamValue* attribute = metadata.spec.find_attribute("chromaticities");
    if (!attribute || attribute->type() != OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8)) return {};
    const auto* xy = static_cast<const float*>(attribute->data());
    for (const Primaries& primaries : kPrimaries) {
        constexpr float kRounding = 2e-3f;
        const auto agrees = [](float a, float b) { return std::fabs(a - b) < kRounding; };
        if (std::equal(primaries.xy.begin(), primaries.xy.end(), xy, agrees)) return {primaries.space, "its chromaticities"};
    }
    return {"", "chromaticities of no space that burnish knows"};
}

}  // namespace

std::string common_space(const std::string& name) {
    std::string form;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c))) form += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const auto has = [&](const char* part) { return form.find(part) != std::string::npos; };
    if (has("acescg") || has("ap1")) return "ACEScg";
    if (has("aces20651") || has("ap0")) return "ACES2065-1";
    const bool is_linear = has("lin"), is_rec709 = has("709") || has("srgb");
    return is_linear && (is_rec709 || form == "linear") ? "lin_rec709" : "";
}

ToldSpace told_space(const Metadata& metadata) {
    for (const char* name : kNames)
        if (const auto text = string_attribute(metadata, name); text && !text->empty())
            return {common_space(*text), std::string(name) + " = " + *text};
    return space_of_primaries(metadata);
}

ToldSpace told_space(const std::string& file) {
    if (std::filesystem::path(file).extension() != ".exr") return {};
    try {
        return told_space(*ExrFile(file, "").metadata(0));
    } catch (const Error&) {
        return {};  // who reads its pixels tells
    }
}

}  // namespace burnish
