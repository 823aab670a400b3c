// What a configuration costs: a few constants of a machine and the arithmetic that makes seconds of them.
//
// The constants come from `burnish calibrate`, which writes them to the user's folder, or else from a typical two-core machine. Costs are
// seconds by the clock with all cores of the machine that was calibrated, whatever the job's own number of threads: the same job has the
// same plan everywhere the same calibration is used.
//
//     a frame = (filtered light, unless it is there + tables of each lobe) / frames + shading
//
//     table of `regular`, `filtered_importance`   evaluations of the model, for its albedo; then nodes * lookups
//     table of `fitted`                           fits * (evaluations of the model + lookups^1.4)
//     maps of `factored`, unless they are there   samples of all lobes by `fitted` + solving, once a material
//     dense shading                               lobes * pixels * (pixel + lookups * lookup + suns * sun)
//     sparse shading                              a share of that, a fixed cost per pixel, and probes as dear as four fitted lookups
#pragma once

#include <burnish/material/parameters.h>
#include <burnish/plan/configuration.h>
#include <burnish/plan/machine_costs.h>

#include <cstddef>

namespace burnish {

/// What the costs of a material depend on.
struct CostCase {
    size_t pixels = 0;         // of the material in a frame
    size_t frame_pixels = 0;   // of the whole frame
    size_t face_texels = 0;    // of the light, six faces
    bool is_near = false;      // any light but the environment alone
    bool has_pyramid = false;  // the light is filtered already: of no further cost
    bool has_stack = false;
    bool has_maps = false;    // `factored`: they were given
    int frames = 1;           // that share light and tables
    int suns = 0;             // discs of the environment, shaded apart
    double sparse_share = 0;  // of the pixels, what sparse shading at safety 1 shades; 0: not known, a typical one
};

/// Parts of a frame's cost, seconds by the clock.
struct PredictedCost {
    double light = 0, tables = 0, shading = 0;

    double total() const { return light + tables + shading; }
};

/// Light and tables as the frame's share of them. `safety` <= 0: dense.
PredictedCost predicted_cost(const MachineCosts& machine, const Material& material, const Configuration& configuration,
                             float safety, const CostCase& of);

/// Its total.
double predicted_seconds(const MachineCosts& machine, const Material& material, const Configuration& configuration,
                         float safety, const CostCase& of);

/// Of a material's pixels, those that sparse shading shades: a typical share at safety 1 if `at_one` is 0.
double sparse_share(float safety, double at_one = 0);

/// Seconds that `reference` takes for so many lookups.
double reference_seconds(const MachineCosts& machine, double lookups);

}  // namespace burnish
