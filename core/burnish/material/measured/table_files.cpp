#include <burnish/base/error.h>
#include <burnish/material/any_model.h>
#include <burnish/material/measured/measured_lobe.h>
#include <burnish/material/measured/read_measured.h>
#include <burnish/material/measured/table_files.h>

#include <nlohmann/json.hpp>

namespace burnish {
namespace {

using nlohmann::json;

/// Calls `visit(object, path)` for the material itself and for its lobes.
template <class Json, class Visit>
void for_each_lobe(Json& material, const Visit& visit) {
    if (!material.is_object()) return;
    visit(material);
    const auto lobes = material.find("lobes");
    if (lobes == material.end() || !lobes->is_array()) return;
    for (size_t i = 0; i < lobes->size(); ++i)
        if ((*lobes)[i].is_object()) visit((*lobes)[i]);
}

}  // namespace

std::shared_ptr<const MeasuredBrdf> TableFiles::read(const std::string& file) {
    auto& table = m_read[file];
    if (!table) table = read_measured(file);
    return table;
}

Material table_material(std::shared_ptr<const MeasuredBrdf> measured, const std::string& name) {
    Material material;
    material.name = name;
    material.kd = diffuse_base(*measured);
    for (const Side side : {Side::reflection, Side::transmission}) {
        if (side == Side::transmission && !measured->transmits()) break;
        LobeParameters lobe;
        lobe.model = ModelId::table, lobe.side = side;
        lobe.data = std::make_shared<MeasuredLobe>(measured, side, side == Side::reflection ? material.kd : Color3f(0));
        take_table_widths(lobe);
        material.lobes.push_back(lobe);
    }
    return material;
}

Color3f kd_from_json(const json& material, const JsonFields& fields, NumberRange range, TableFiles& files) {
    const bool given = fields.has("kd");
    if (given && fields.at("kd") != "auto") return fields.color("kd", range);
    std::string table;
    for_each_lobe(material, [&](const json& lobe) {
        const auto named = lobe.find("table"), model = lobe.contains("model") ? lobe.find("model") : material.find("model");
        const bool shows_one = named != lobe.end() && named->is_string() && model != lobe.end() && *model == "table";
        if (table.empty() && shows_one) table = *named;
    });
    if (!table.empty()) return diffuse_base(*files.read(table));
    if (given) fail_expected(fields.path("kd"), "a colour; \"auto\" is for materials with a table", fields.at("kd"));
    return Color3f(0);
}

void table_from_json(const JsonFields& fields, LobeParameters& lobe, const Color3f& kd, TableFiles& files) {
    if (lobe.model != ModelId::table) return;
    if (fields.text("table").empty())
        throw Error(ErrorCode::bad_argument, fields.path("table") +
                                                 ": expected the file of a measurement (.binary, .brdf, .alta, "
                                                 ".dat, .gonio)");
    const auto measured = files.read(fields.text("table"));
    if (lobe.side == Side::transmission && !measured->transmits())
        throw Error(ErrorCode::bad_argument,
                    fields.path("kt") + ": " + measured->file() + " has no transmitted light; give ks");
    lobe.data = std::make_shared<MeasuredLobe>(measured, lobe.side, lobe.side == Side::reflection ? kd : Color3f(0));
}

void take_table_widths(LobeParameters& lobe) {
    const auto* own = dynamic_cast<const MeasuredLobe*>(lobe.data.get());
    if (own) lobe.mx = own->own_widths().x, lobe.my = own->own_widths().y;
}

std::string table_of(const LobeParameters& lobe) {
    const auto* own = dynamic_cast<const MeasuredLobe*>(lobe.data.get());
    return own ? own->measured().file() : "";
}

json with_tables_in(json material, const std::filesystem::path& folder) {
    for_each_lobe(material, [&](json& lobe) {
        const auto named = lobe.find("table");
        if (named != lobe.end() && named->is_string()) *named = (folder / named->get<std::string>()).string();
    });
    return material;
}

}  // namespace burnish
