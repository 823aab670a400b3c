// The constants that costs are predicted from: measured on a machine, kept in a file, shipped for a typical one.
#pragma once

#include <burnish/base/progress.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace burnish {

/// Seconds each by the clock, all cores at work unless it says one core.
struct MachineCosts {
    std::string machine;  // what was calibrated, for people
    int cores = 2;
    double pyramid_texel = 0, stack_texel = 0;       // to filter light: per texel of the six faces
    double table_lookup = 0;                         // to make a table: per node and lookup
    double fit_lookup = 0, turned_fit_lookup = 0;    // one core: a fit of one lookup to one view of a round lobe; of a long one
    double pixel = 0, lookup = 0, stack_lookup = 0;  // dense shading: per lobe and pixel, and per lookup there
    double sun = 0;                                  // per lobe, pixel and sun
    double sparse_pixel = 0;                         // sparse shading: per pixel of the frame, whatever is shaded
    double reference_lookup = 0;                     // of `reference`, per lookup and pixel
    double near_ray = 0;                             // a lookup under lights that are near, in place of `lookup`
    double maps = 0;                                 // `factored`: to solve for the maps of a material
    double map_pixel = 0;                            // the same: per pixel, whatever the lobes
    std::map<std::string, double, std::less<>> evaluation;  // one core: to draw and evaluate one sample of each model
};

/// Those of this user's calibration file, or the shipped ones. Read once a process. Throws Error(read_failed | bad_argument) for a
/// broken file.
const MachineCosts& machine_costs();
/// Those that burnish comes with.
const MachineCosts& shipped_costs();
/// $BURNISH_COSTS, or burnish/costs.json in the user's cache folder.
std::filesystem::path costs_file();

/// `where` names the document in messages. Throws Error(bad_argument) that names the field and the remedy.
MachineCosts costs_from_json(const nlohmann::json& document, const std::string& where);
nlohmann::json costs_to_json(const MachineCosts& costs);

/// One of the constants: what files call it, and what it is, for people.
struct CostField {
    std::string_view name, meaning;
    double MachineCosts::*value;
};
std::span<const CostField> cost_fields();

/// Measures the constants on this machine; some seconds.
MachineCosts measure_costs(const Progress& progress = {});

}  // namespace burnish
