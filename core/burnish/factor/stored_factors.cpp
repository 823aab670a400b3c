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
constexpr NumberRange kGain{0, 1e12}, kCurve{-4, 4};
constexpr std::array<std::string_view, 12> kFields = {"format", "of",     "parametrization", "formula",          "factors",
                                                      "maps",   "terms",  "dominant",        "reflection_curve", "world_to_map",
                                                      "gain",   "made_of"};

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

json curve_to_json(const FactorGuide& guide) {
    json curve = json::array();
    for (int i = 0; i < FactorGuide::kKnots; ++i)
        curve.push_back({to_json_number(guide.towards_n[i]), to_json_number(guide.towards_r[i])});
    return curve;
}

void curve_from_json(const JsonFields& fields, FactorGuide& guide) {
    const json& curve = fields.at("reflection_curve");
    const auto usable = [](const json& x) { return x.is_number() && x >= kCurve.min && x <= kCurve.max; };
    const auto is_knot = [&](const json& knot) {
        return knot.is_array() && knot.size() == 2 && usable(knot[0]) && usable(knot[1]);
    };
    if (!curve.is_array() || curve.size() != FactorGuide::kKnots || !std::ranges::all_of(curve, is_knot))
        fail_expected(fields.path("reflection_curve"), std::to_string(FactorGuide::kKnots) + " pairs of numbers from -4 to 4",
                      curve);
    for (int i = 0; i < FactorGuide::kKnots; ++i)
        guide.towards_n[i] = curve[i][0].get<float>(), guide.towards_r[i] = curve[i][1].get<float>();
}

/// Whether lookups by such directions find their places.
bool serves(const DirectionMap& layout, DirectionDomain domain) {
    return domain == DirectionDomain::elevation ||
           (domain == DirectionDomain::hemisphere && layout.mapping() != Mapping::elevation) || layout.is_whole_sphere();
}

FactorMap map_from_json(const JsonFields& fields, const Parametrization& parametrization, int map) {
    fields.expect_only(std::array<std::string_view, 3>{"name", "mapping", "size"});
    const std::string name = map_name(parametrization, map);
    if (fields.text("name") != name) fail_expected(fields.path("name"), name, fields.at("name"));
    std::vector<std::string_view> mappings;
    for (const Mapping mapping :
         {Mapping::hemispherical, Mapping::parabolic, Mapping::double_parabolic, Mapping::cube, Mapping::elevation})
        mappings.push_back(mapping_name(mapping));
    const int size = fields.whole_number("size", {DirectionMap::kLeastSize, DirectionMap::kMostSize}, 0);
    const DirectionMap layout(mapping_by_name(fields.name("mapping", mappings)), size);
    if (!serves(layout, parametrization.domain(map)))
        fail_expected(fields.path("mapping"), "one that holds all directions the map is looked up by", fields.at("mapping"));
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
                  {"dominant", to_json_vector(factors.guide.dominant)},
                  {"reflection_curve", curve_to_json(factors.guide)},
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
    stored.factors.guide.dominant = unit_from_json(fields, "dominant");
    curve_from_json(fields, stored.factors.guide);
    stored.world_to_map = axes_from_json(fields);
    stored.gain = fields.color("gain", kGain);
    if (fields.has("made_of")) stored.made_of = fields.at("made_of").dump(-1, ' ', true, json::error_handler_t::replace);
    return stored;
}

}  // namespace burnish
