// One frame shaded sparsely and densely with the same estimator: what it costs, what it loses, what an oracle would do.
#pragma once

#include <burnish/input/assign.h>
#include <burnish/input/frame.h>
#include <burnish/light/environment.h>
#include <burnish/material/parameters.h>
#include <burnish/sampling/density.h>
#include <burnish/sampling/estimator.h>
#include <burnish/surface/surfaces.h>

#include <string>
#include <vector>

namespace burnish {

/// What is shaded: pixels of rule i wear materials[i].
struct SparseCase {
    std::string name;
    AovFrame frame;
    Assignment assignment;
    std::vector<Material> materials;
    SurfaceSettings surface = {};
};

struct SparseSettings {
    EstimatorSettings estimator;
    DensitySettings density{.safety = 1};
    int repeats = 5;
    bool with_regular = false;  // also times dense `regular`, n = 16
};

/// Times are of the processor, the least of the repeats, milliseconds; shares are of the valid pixels.
struct SparseFigures {
    double dense_ms = 0, sparse_ms = 0, turning_ms = 0, plan_ms = 0;
    double regular_ms = 0;  // 0 unless asked for
    double psnr_db = 0, largest_error = 0;
    double shaded = 0, oracle = 0;
    int worst_x = 0, worst_y = 0;
};

/// With `pictures`, also writes PREFIX_{dense,sparse,error,shaded}.png; error is 8 times the difference of display values.
SparseFigures measure_sparse(const SparseCase& what, const Environment& light, const SparseSettings& settings,
                             const std::string& pictures = "");

}  // namespace burnish
