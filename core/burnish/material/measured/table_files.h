// Materials that show measurements: from a file alone, and from JSON whose lobes name one.
//
//     {"model": "table", "table": "brass.binary"}                     kd: what the table has everywhere, and m its own
//     {"kd": 0.1, "lobes": [{"model": "table", "table": "brass.binary", "m": 0.2}]}
//
// The diffuse part of the material is what its lobes leave out: "kd" is "auto" where it is not given.
#pragma once

#include <burnish/base/json_fields.h>
#include <burnish/material/measured/measured_brdf.h>
#include <burnish/material/parameters.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace burnish {

/// The tables of one material, each read once.
class TableFiles {
public:
    /// Throws Error(read_failed).
    std::shared_ptr<const MeasuredBrdf> read(const std::string& file);

private:
    std::map<std::string, std::shared_ptr<const MeasuredBrdf>> m_read;
};

/// The material that a measurement is: its diffuse part and a lobe on each side where it was measured.
Material table_material(std::shared_ptr<const MeasuredBrdf> measured, const std::string& name);

/// "kd" of a material's JSON: a colour, or the base of the first table of its lobes for "auto" and where there is no kd, which
/// without a table is 0. Throws Error(bad_argument).
Color3f kd_from_json(const nlohmann::json& material, const JsonFields& fields, NumberRange range, TableFiles& files);
/// Gives a lobe of model `table` what its "table" names; `kd`: of its material.
void table_from_json(const JsonFields& fields, LobeParameters& lobe, const Color3f& kd, TableFiles& files);
/// The table's own widths for a lobe that shows one, which differ where it is anisotropic.
void take_table_widths(LobeParameters& lobe);
/// What "table" was, "" for lobes of other models.
std::string table_of(const LobeParameters& lobe);

/// A material's JSON with the tables it names as from `folder`, as files that hold materials mean them.
nlohmann::json with_tables_in(nlohmann::json material, const std::filesystem::path& folder);

}  // namespace burnish
