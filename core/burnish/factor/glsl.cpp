#include <burnish/factor/glsl.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

namespace burnish {
namespace {

/// How a mapping is looked up: see DirectionMap::place.
struct GlslMapping {
    Mapping mapping;
    std::string_view sampler, code;
};

constexpr std::string_view kDiscPlace = R"(
/* Where p, within a circle of radius 1, lies on a disc whose rim is a texel inside its square; texels. */
vec2 burnish_disc_place(vec2 p, float size) {
    return clamp(0.5 * size + (0.5 * size - 1.0) * p, 0.5, size - 0.5);
}
)";

constexpr GlslMapping kMappings[] = {
    {Mapping::hemispherical, "sampler2D", R"(
vec4 burnish_on_hemispherical(sampler2D map, vec3 d, float size) {
    vec2 p = d.z < 0.0 ? d.xy / max(length(d.xy), 1e-6) : d.xy;
    return texture(map, burnish_disc_place(p, size) / size);
}
)"},
    {Mapping::parabolic, "sampler2D", R"(
vec4 burnish_on_parabolic(sampler2D map, vec3 d, float size) {
    return texture(map, burnish_disc_place(d.xy / max(1.0 + d.z, 1e-6), size) / size);
}
)"},
    {Mapping::double_parabolic, "sampler2D", R"(
vec4 burnish_on_double_parabolic(sampler2D map, vec3 d, float size) {
    vec2 place = burnish_disc_place(d.xy / (1.0 + abs(d.z)), size);
    return texture(map, vec2(place.x + (d.z < 0.0 ? size : 0.0), place.y) / vec2(2.0 * size, size));
}
)"},
    {Mapping::cube, "samplerCube", R"(
vec4 burnish_on_cube(samplerCube map, vec3 d, float size) {
    return texture(map, vec3(d.xy, -d.z));
}
)"},
    {Mapping::elevation, "sampler2D", R"(
vec4 burnish_on_elevation(sampler2D map, vec3 d, float size) {
    return texture(map, vec2((0.5 + clamp(d.z, 0.0, 1.0) * (size - 1.0)) / size, 0.5));
}
)"},
};

const GlslMapping& mapping_of(const DirectionMap& layout) { return kMappings[static_cast<size_t>(layout.mapping())]; }

/// With a point or exponent, by which GLSL tells floats.
std::string number(float value) {
    char text[32];
    std::string shortest(text, std::to_chars(text, text + sizeof text, value).ptr);
    return shortest.find_first_of(".e") == std::string::npos ? shortest + ".0" : shortest;
}

std::string vec3(const float* v) { return "vec3(" + number(v[0]) + ", " + number(v[1]) + ", " + number(v[2]) + ")"; }

/// Imath multiplies rows by matrices, GLSL matrices by columns: the rows of one are the columns of the other.
std::string mat3(const Matrix33f& m) {
    std::string text;
    for (const auto& row : m.x)
        for (const float value : row) text += (text.empty() ? "" : ", ") + number(value);
    return "mat3(" + text + ")";
}

class Snippet {
public:
    explicit Snippet(const StoredFactors& stored)
        : m_stored(stored),
          m_parametrization(*stored.factors.parametrization),
          m_is_lighting(m_parametrization.of == FactoredFunction::lighting) {}

    std::string whole(const std::string& sum) const {
        std::string text = remarks() + samplers();
        text += "uniform vec3 burnish_gain = " + vec3(&m_stored.gain.x) + ";\n";
        if (m_is_lighting)
            text += "uniform mat3 burnish_world_to_map = " + mat3(m_stored.world_to_map) + ";\n" + reflection_curve();
        return text + "\n" + glsl_projections(m_parametrization.of) + lookups() + "\n" + function(sum);
    }

    /// The product of all lookups of a term.
    std::string product(size_t term) const {
        std::string text;
        for (const Factor& factor : m_parametrization.factors) {
            const DirectionMap& layout = layout_of(factor.map);
            text += (text.empty() ? "" : "\n        * ") + std::string("burnish_on_") +
                    std::string(mapping_name(layout.mapping())) + "(" + sampler(factor.map, term) + ", " +
                    std::string(factor.direction->glsl) + ", " + number(static_cast<float>(layout.size())) + ")";
        }
        return text;
    }

private:
    const DirectionMap& layout_of(int map) const { return m_stored.factors.terms[0][map].layout; }
    std::string sampler(int map, size_t term) const { return "burnish_" + map_name(m_parametrization, map, term); }

    std::string remarks() const {
        return "// Made by burnish: " + m_parametrization.summary +
               ".\n"
               "// Textures: linear filter, clamped to their edges, no smaller levels, values as they are (no sRGB), the first "
               "row of\n"
               "// the picture at v = 0. A cube's faces, from the top, are a cube map's +X, -X, +Y, -Y, -Z and +Z.\n";
    }

    std::string samplers() const {
        std::string text;
        for (size_t term = 0; term < m_stored.factors.terms.size(); ++term)
            for (int map = 0; map < m_parametrization.map_count(); ++map) {
                const DirectionMap& layout = layout_of(map);
                text += "uniform " + std::string(mapping_of(layout).sampler) + " " + sampler(map, term) + ";  // " +
                        std::to_string(layout.width()) + "x" + std::to_string(layout.height()) + "\n";
            }
        return text;
    }

    /// See FactorGuide.
    std::string reflection_curve() const {
        const FactorGuide& guide = m_stored.factors.guide;
        const std::string type = "vec2[" + std::to_string(FactorGuide::kKnots) + "]";
        std::string knots;
        for (int i = 0; i < FactorGuide::kKnots; ++i)
            knots += std::string(i == 0 ? "" : ",") + (i % 4 == 0 ? "\n    " : " ") + "vec2(" + number(guide.towards_n[i]) +
                     ", " + number(guide.towards_r[i]) + ")";
        return "const " + type + " reflection_curve = " + type + "(" + knots + ");\n";
    }

    /// Of the mappings that there are.
    std::string lookups() const {
        std::set<Mapping> needed;
        for (int map = 0; map < m_parametrization.map_count(); ++map) needed.insert(layout_of(map).mapping());
        const auto lies_on_discs = [](Mapping mapping) { return mapping != Mapping::cube && mapping != Mapping::elevation; };
        std::string text = std::ranges::any_of(needed, lies_on_discs) ? std::string(kDiscPlace) : "";
        for (const GlslMapping& mapping : kMappings)
            if (needed.contains(mapping.mapping)) text += mapping.code;
        return text;
    }

    std::string function(const std::string& sum) const {
        std::string text = std::string("vec3 burnish_factored(vec3 ") + (m_is_lighting ? "n" : "wi") + ", vec3 wo) {\n";
        if (m_is_lighting) text += "    n = burnish_world_to_map * n;\n    wo = burnish_world_to_map * wo;\n";
        if (m_parametrization.needs_dominant())
            text += "    const vec3 dominant = " + vec3(&m_stored.factors.guide.dominant.x) + ";\n";
        return text + sum + "}\n";
    }

    const StoredFactors& m_stored;
    const Parametrization& m_parametrization;
    bool m_is_lighting;
};

}  // namespace

std::string glsl_of(const StoredFactors& stored) {
    const Snippet snippet(stored);
    std::string sum;
    for (size_t term = 0; term < stored.factors.terms.size(); ++term)
        sum += std::string(term == 0 ? "    vec4 sum = " : "    sum += ") + snippet.product(term) + ";\n";
    return snippet.whole(sum + "    return max(sum.rgb, 0.0) * burnish_gain;\n");
}

std::string glsl_of(const StoredFactors& stored, const QuantisedFactors& eight_bit) {
    const Snippet snippet(stored);
    std::string sum = "    vec3 sum = vec3(0.0);\n    vec4 product;\n";
    for (size_t term = 0; term < eight_bit.terms.size(); ++term) {
        const QuantisedTerm& own = eight_bit.terms[term];
        const Color3f color = own.color * own.scale;
        sum += "    product = " + snippet.product(term) + ";\n    sum += min(" + vec3(&color.x) +
               " * product.rgb, 1.0) * product.a * " + number(own.white) + ";\n";
    }
    return snippet.whole(sum + "    return sum * burnish_gain;\n");
}

}  // namespace burnish
