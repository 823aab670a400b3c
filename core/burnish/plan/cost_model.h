// What a configuration costs: a few constants of a machine and the arithmetic that makes seconds of them.
//
// The constants come from `burnish calibrate`, which writes them to the user's folder, or else from a typical two-core machine. Costs are
// seconds by the clock with all cores of the machine that was calibrated, whatever the job's own number of threads: the same job has the
// same plan everywhere the same calibration is used.
#pragma once

#include <burnish/material/parameters.h>
#include <burnish/plan/configuration.h>
#include <burnish/sampling/density.h>

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <filesystem>
#include <string>

namespace burnish {

/// Seconds each, all cores at work.
struct MachineCosts {
    std::string machine;  // what was calibrated, for people
    int cores = 2;
    double pyramid_texel = 0, stack_texel = 0;       // to filter light: per texel of the six faces
    double table_lookup = 0, fitted_lookup = 0;      // to make a table: per node and lookup, for a model as cheap as GGX
    double pixel = 0, lookup = 0, stack_lookup = 0;  // dense shading: per lobe and pixel, and per lookup there
    double sparse_pixel = 0;                         // sparse shading: per pixel of the frame, whatever is shaded
    double reference_lookup = 0;                     // of `reference`, per lookup and pixel
    double near_ray = 0;                             // a lookup under lights that are near, in place of `lookup`
};

/// Those of this user's calibration file, or the shipped ones. Read once a process. Throws Error(read_failed) for a broken file.
const MachineCosts& machine_costs();
/// $BURNISH_COSTS, or burnish/costs.json in the user's cache folder.
std::filesystem::path costs_file();
MachineCosts costs_from_json(const nlohmann::json& document, const std::string& where);
nlohmann::json costs_to_json(const MachineCosts& costs);

/// Measures the constants on this machine; some seconds.
MachineCosts measure_costs();

/// What the costs of a material depend on.
struct CostCase {
    size_t pixels = 0;         // of the material in a frame
    size_t frame_pixels = 0;   // of the whole frame
    size_t face_texels = 0;    // of the light, six faces
    bool is_near = false;      // any light but the environment alone
    bool has_pyramid = false;  // the light is filtered already: of no further cost
    bool has_stack = false;
    int frames = 1;  // that share light and tables
};

/// Seconds of the clock a frame: its share of light and tables, and its shading. `safety` <= 0: dense.
double predicted_seconds(const MachineCosts& machine, const Material& material, const Configuration& configuration,
                         float safety, const CostCase& of);

/// Seconds that `reference` takes for so many lookups.
double reference_seconds(const MachineCosts& machine, double lookups);

}  // namespace burnish
