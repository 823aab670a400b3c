#include <burnish/factor/stored_factors.h>

#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>
#include <burnish/base/json_text.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace burnish {
namespace {

using nlohmann::json;

constexpr int kFormat = 1, kMostTerms = 16;
constexpr NumberRange kGain{0, 1e12};
constexpr std::array<std::string_view, 11> kFields = {"format", "of",       "parametrization", "formula", "factors", "maps",
                                                      "terms",  "dominant", "world_to_map",    "gain",    "made_of"};

std::string_view function_name(FactoredFunction of) { return of == FactoredFunction::brdf ? "brdf" : "lighting"; }

std::string formula(const Parametrization& parametrization, size_t terms) {
    std::string text = parametrization.of == FactoredFunction::brdf ? "f(wi, wo) = gain" : "L(n, wo) = gain";
    if (terms > 1) text += " * max(0, sum over terms of";
    for (const Factor& factor : parametrization.factors)
        text += (text.ends_with("of") ? " " : " * ") + map_name(parametrization, factor.map) + "(" +
                std::string(factor.direction->glsl) + ")";
    return text + (terms > 1 ? ")" : "");
}

json factors_as_json(const Parametrization& parametrization) {
    json list = json::array();
    for (const Factor& factor : parametrization.factors)
        list.push_back({{"direction", factor.direction->name}, {"map", map_name(parametrization, factor.map)}});
    return list;
}

/// The axes of the maps as rows; throws unless they are unit and perpendicular, mirrored or not.
Matrix33f axes_from_json(const JsonFields& fields) {
    const json& rows = fields.at("world_to_map");
    const std::string where = fields.path("world_to_map");
    Matrix33f axes;
    if (!rows.is_array() || rows.size() != 3) fail_expected(where, "three rows [x, y, z]", rows);
    for (int i = 0; i < 3; ++i) {
        const Vec3f row = vector_from_json(rows[i], where + "[" + std::to_string(i) + "]");
        std::copy_n(&row.x, 3, axes[i]);
    }
    constexpr float kSlack = 1e-3f;
    if (!(axes * axes.transposed()).equalWithAbsError(Matrix33f(), kSlack))
        fail_expected(where, "unit rows perpendicular to each other", rows);
    return axes;
}

Vec3f unit_from_json(const JsonFields& fields, std::string_view key) {
    const Vec3f v = fields.vector(key);
    if (std::fabs(v.length() - 1) > 1e-3f) fail_expected(fields.path(key), "a unit vector", fields.at(key));
    return v.normalized();
}

FactorMap map_from_json(const JsonFields& fields, const Parametrization& parametrization, int map) {
    fields.expect_only(std::array<std::string_view, 3>{"name", "mapping", "size"});
    const std::string expected = map_name(parametrization, map), found = fields.text("name");
    if (found != expected) fail_expected(fields.path("name"), "\"" + expected + "\"", fields.at("name"));
    const std::array<std::string_view, 4> mappings = {mapping_name(Mapping::hemispherical), mapping_name(Mapping::parabolic),
                                                      mapping_name(Mapping::double_parabolic), mapping_name(Mapping::cube)};
    const int size = fields.whole_number("size", {DirectionMap::kLeastSize, DirectionMap::kMostSize}, 0);
    const DirectionMap layout(mapping_by_name(fields.name("mapping", mappings)), size);
    if (parametrization.is_whole_sphere(map) && !layout.is_whole_sphere())
        fail_expected(fields.path("mapping"), "double_parabolic or cube, as all directions are looked up",
                      fields.at("mapping"));
    return {layout, {}};
}

FactorTerm term_from_json(const JsonFields& fields, const Parametrization& parametrization) {
    const json& list = fields.at("maps");
    const std::string where = fields.path("maps"), count = std::to_string(parametrization.map_count());
    if (!list.is_array() || static_cast<int>(list.size()) != parametrization.map_count())
        fail_expected(where, "a list of " + count, list);
    FactorTerm term;
    for (int map = 0; map < parametrization.map_count(); ++map)
        term.push_back(map_from_json({list[map], where + "[" + std::to_string(map) + "]"}, parametrization, map));
    return term;
}

const Parametrization& parametrization_from_json(const JsonFields& fields) {
    const Parametrization& parametrization = parametrization_by_name(fields.text("parametrization"));
    if (fields.at("of") != function_name(parametrization.of))
        fail_expected(fields.path("of"), std::string(function_name(parametrization.of)), fields.at("of"));
    if (fields.at("factors") != factors_as_json(parametrization))
        fail_expected(fields.path("factors"), factors_as_json(parametrization).dump(), fields.at("factors"));
    return parametrization;
}

}  // namespace

Color3f StoredFactors::operator()(const DirectionPair& pair) const {
    const bool is_lighting = factors.parametrization->of == FactoredFunction::lighting;
    return factors(is_lighting ? DirectionPair{pair.a * world_to_map, pair.b * world_to_map} : pair) * gain;
}

std::string map_name(const Parametrization& parametrization, int map, size_t term) {
    const std::string name(std::ranges::find(parametrization.factors, map, &Factor::map)->direction->name);
    return term == 0 ? name : name + "_" + std::to_string(term + 1);
}

json factors_to_json(const StoredFactors& stored) {
    const Factors& factors = stored.factors;
    const Parametrization& parametrization = *factors.parametrization;
    json maps = json::array(), axes = json::array();
    for (int map = 0; map < parametrization.map_count(); ++map) {
        const DirectionMap& layout = factors.terms[0][map].layout;
        maps.push_back(
            {{"name", map_name(parametrization, map)}, {"mapping", mapping_name(layout.mapping())}, {"size", layout.size()}});
    }
    for (const auto& row : stored.world_to_map.x) axes.push_back(to_json_vector({row[0], row[1], row[2]}));
    json value = {{"format", kFormat},
                  {"of", function_name(parametrization.of)},
                  {"parametrization", parametrization.name},
                  {"formula", formula(parametrization, factors.terms.size())},
                  {"factors", factors_as_json(parametrization)},
                  {"maps", maps},
                  {"terms", factors.terms.size()},
                  {"dominant", to_json_vector(factors.dominant)},
                  {"world_to_map", axes},
                  {"gain", to_json_color(stored.gain)}};
    if (!stored.made_of.empty()) value["made_of"] = parse_json(stored.made_of, "made_of");
    return value;
}

StoredFactors factors_from_json(const json& value, const std::string& where) {
    const JsonFields fields(value, where);
    if (fields.whole_number("format", {1, 1e6}, 0) != kFormat)
        fail_expected(fields.path("format"), "1; newer files need a newer burnish", fields.at("format"));
    fields.expect_only(kFields);
    StoredFactors stored;
    stored.factors.parametrization = &parametrization_from_json(fields);
    const FactorTerm term = term_from_json(fields, *stored.factors.parametrization);
    stored.factors.terms.assign(fields.whole_number("terms", {1, kMostTerms}, 1), term);
    stored.factors.dominant = unit_from_json(fields, "dominant");
    stored.world_to_map = axes_from_json(fields);
    stored.gain = fields.color("gain", kGain);
    if (fields.has("made_of")) stored.made_of = fields.at("made_of").dump(-1, ' ', true, json::error_handler_t::replace);
    return stored;
}

}  // namespace burnish
