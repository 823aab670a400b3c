#include <burnish/input/channel_names.h>
#include <burnish/input/fingerprint.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace burnish {
namespace {

struct Mark {
    Renderer renderer;
    std::string_view text;
};

constexpr std::array kAttributePrefixes = {
    Mark{Renderer::cycles, "cycles."},    Mark{Renderer::cycles, "BlenderMultiChannel"},
    Mark{Renderer::arnold, "arnold/"},    Mark{Renderer::vray, "vrayInfo/"},
    Mark{Renderer::vray, "vray/"},        Mark{Renderer::redshift, "rs/"},
    Mark{Renderer::redshift, "redshift"}, Mark{Renderer::octane, "octane"},
    Mark{Renderer::karma, "karma:"},      Mark{Renderer::karma, "husk:"},
    Mark{Renderer::renderman, "rman"},    Mark{Renderer::luxcore, "luxcore"},
};

constexpr std::array kProgramAttributes = {"Software", "software", "generatedBy", "Renderer", "renderer", "creator"};
constexpr std::array kProgramNames = {
    Mark{Renderer::arnold, "arnold"},       Mark{Renderer::vray, "v-ray"},      Mark{Renderer::vray, "vray"},
    Mark{Renderer::redshift, "redshift"},   Mark{Renderer::octane, "octane"},   Mark{Renderer::karma, "karma"},
    Mark{Renderer::karma, "husk"},          Mark{Renderer::karma, "houdini"},   Mark{Renderer::karma, "mantra"},
    Mark{Renderer::renderman, "renderman"}, Mark{Renderer::renderman, "prman"}, Mark{Renderer::mitsuba, "mitsuba"},
    Mark{Renderer::luxcore, "luxcore"},     Mark{Renderer::cycles, "cycles"},
};

// Layer names, in normal form, that no other renderer writes.
constexpr std::array kLayers = {
    Mark{Renderer::cycles, "glossdir"},
    Mark{Renderer::karma, "directglossyreflection"},
    Mark{Renderer::karma, "combinedglossyreflection"},
    Mark{Renderer::renderman, "directspecular"},
    Mark{Renderer::renderman, "pworld"},
    Mark{Renderer::luxcore, "indirectglossy"},
    Mark{Renderer::mitsuba, "shnormal"},
    Mark{Renderer::redshift, "specularlighting"},
    Mark{Renderer::vray, "rawreflection"},
    Mark{Renderer::arnold, "speculardirect"},
};

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

struct Special {
    Renderer renderer;
    Role role;
    std::string_view layer;
    Meaning meaning;
};

constexpr std::string_view kBoth = "direct and indirect light together";
constexpr std::string_view kCameraSpace = "camera space by this renderer's habit";

constexpr std::array kSpecials = {
    Special{Renderer::vray, Role::diffuse_direct, "lighting", {}},
    Special{Renderer::vray, Role::diffuse_indirect, "gi", {}},
    Special{Renderer::vray, Role::diffuse_albedo, "diffuse", {}},
    Special{Renderer::vray, Role::specular_direct, "specular", {}},
    Special{Renderer::vray, Role::specular_indirect, "reflect", {}},
    Special{Renderer::vray, Role::specular_indirect, "reflection", {}},
    Special{Renderer::vray, Role::normal, "normals", {false, true, kCameraSpace}},
    Special{Renderer::redshift, Role::specular_indirect, "reflections", {}},
    Special{Renderer::redshift, Role::diffuse_indirect, "gi", {}},
    Special{Renderer::octane, Role::specular_direct, "reflection", {true, false, kBoth}},
    Special{Renderer::arnold, Role::specular_direct, "specular", {true, false, kBoth}},
    Special{Renderer::arnold, Role::diffuse_direct, "diffuse", {true, false, kBoth}},
    Special{Renderer::karma, Role::specular_direct, "combinedglossyreflection", {true, false, kBoth}},
    Special{Renderer::karma, Role::diffuse_direct, "combineddiffuse", {true, false, kBoth}},
    Special{Renderer::renderman, Role::position, "p", {false, true, kCameraSpace}},
    Special{Renderer::renderman, Role::normal, "nn", {false, true, kCameraSpace}},
    Special{Renderer::renderman, Role::normal, "n", {false, true, kCameraSpace}},
    Special{Renderer::luxcore,
            Role::specular_direct,
            "directglossy",
            {false, false, "holds the diffuse light of principled materials too"}},
    Special{Renderer::luxcore,
            Role::specular_indirect,
            "indirectglossy",
            {false, false, "holds the diffuse light of principled materials too"}},
    Special{Renderer::unknown,
            Role::specular_direct,
            "specular",
            {true, false, "taken as direct and indirect light together; the renderer is unknown"}},
};

}  // namespace

std::string_view renderer_name(Renderer renderer) {
    switch (renderer) {
        case Renderer::unknown: return "an unknown renderer";
        case Renderer::cycles: return "Cycles";
        case Renderer::arnold: return "Arnold";
        case Renderer::renderman: return "RenderMan";
        case Renderer::vray: return "V-Ray";
        case Renderer::karma: return "Karma";
        case Renderer::mitsuba: return "Mitsuba";
        case Renderer::redshift: return "Redshift";
        case Renderer::octane: return "Octane";
        case Renderer::luxcore: return "LuxCore";
    }
    return "";
}

Fingerprint fingerprint(const Metadata& metadata, const std::vector<Layer>& layers) {
    for (const std::string& name : attribute_names(metadata))
        for (const Mark& mark : kAttributePrefixes)
            if (name.starts_with(mark.text)) return {mark.renderer, "attribute " + name};
    for (const char* attribute : kProgramAttributes) {
        const std::string program = lower(string_attribute(metadata, attribute).value_or(""));
        for (const Mark& mark : kProgramNames)
            if (program.find(mark.text) != std::string::npos) return {mark.renderer, "attribute " + std::string(attribute)};
    }
    for (const Mark& mark : kLayers)
        for (const Layer& layer : layers)
            if (normal_form(layer.name) == mark.text) return {mark.renderer, "layer " + layer.name};
    return {};
}

std::optional<Meaning> meaning_of(Renderer renderer, Role role, std::string_view layer) {
    for (const Special& special : kSpecials)
        if (special.renderer == renderer && special.role == role && special.layer == layer) return special.meaning;
    return std::nullopt;
}

bool depth_is_ray_length(Renderer renderer, std::string_view layer) {
    return layer == "vlen" || renderer == Renderer::mitsuba || renderer == Renderer::octane;
}

}  // namespace burnish
