#include <burnish/material/measured/describe_measured.h>

#include <burnish/base/json_fields.h>
#include <burnish/material/albedo.h>
#include <burnish/material/measured/merl_names.h>
#include <burnish/material/measured/merl_table.h>
#include <burnish/material/measured/table_files.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace burnish {
namespace {

using nlohmann::json;

double theta_deg(const Vec3f& w) { return std::acos(std::clamp(std::abs(double(w.z)), 0.0, 1.0)) * 180 / std::numbers::pi; }

/// A number for people, three digits of it.
json rounded(double value) {
    std::ostringstream text;
    text.precision(3);
    text << value;
    return json::parse(text.str());
}

json rounded(const Color3f& color) { return {rounded(color.x), rounded(color.y), rounded(color.z)}; }

}  // namespace

json describe_measured_json(const MeasuredBrdf& measured) {
    const auto* merl = dynamic_cast<const MerlTable*>(&measured);
    const std::vector<BrdfSample> samples = measured.samples();
    double least = 90, most = 0;
    for (const BrdfSample& s : samples) {
        const double theta_i = theta_deg(s.wi.z < 0 ? s.wo : s.wi);
        least = std::min(least, theta_i), most = std::max(most, theta_i);
    }
    const std::shared_ptr<const MeasuredBrdf> borrowed(&measured, [](const MeasuredBrdf*) {});
    const Material material = table_material(borrowed, "");
    const Vec3f wo(std::sqrt(0.5f), 0, std::sqrt(0.5f));
    Color3f albedo = material.kd;
    for (const LobeParameters& lobe : material.lobes) albedo += directional_albedo(lobe, wo, 1024);
    return {{"file", measured.file()},
            {"kind", merl ? "MERL table, 90 x 90 x 180 cells" : "measured pairs"},
            {"merl_name", merl ? std::string(merl_name(measured.file())) : ""},
            {"isotropic", measured.is_isotropic()},
            {"transmits", measured.transmits()},
            {"samples", merl ? merl->measured_cells() : static_cast<int>(samples.size())},
            {"theta_i_deg", {rounded(least), rounded(most)}},
            {"kd", rounded(material.kd)},
            {"width", rounded(std::sqrt(material.lobes[0].mx * material.lobes[0].my))},
            {"albedo", rounded(albedo)}};
}

std::string describe_measured(const MeasuredBrdf& measured) {
    const json about = describe_measured_json(measured);
    const std::string name = about["merl_name"];
    std::ostringstream text;
    text << about["file"].get<std::string>() << "\n  " << about["kind"].get<std::string>() << ", "
         << (measured.is_isotropic() ? "isotropic" : "anisotropic") << (measured.transmits() ? ", reflects and transmits" : "")
         << "\n  " << about["samples"] << " valid, incident angles from " << about["theta_i_deg"][0] << " to "
         << about["theta_i_deg"][1] << " degrees\n  diffuse part kd " << about["kd"].dump() << ", lobe of width m "
         << about["width"] << ", albedo from 45 degrees " << about["albedo"].dump() << "\n";
    if (!name.empty()) text << "  this is MERL's " << name << ", untouched\n";
    if (name.empty() && about["kind"].get<std::string>().starts_with("MERL")) text << "  none of MERL's 100 published files\n";
    return text.str();
}

}  // namespace burnish
