// What a fit may do: which model, how many lobes, and the bounds that the user sets.
#pragma once

#include <burnish/base/json_fields.h>
#include <burnish/material/parameters.h>

#include <map>
#include <optional>
#include <string>

namespace burnish {

/// Bounds of parameters by their names in a material's JSON ("ks", "m", "mx", "my", "r0", "alpha", "kd", ...), for all lobes;
/// "2.m" speaks of the second lobe alone. One whose ends are equal is fixed.
using ParameterBounds = std::map<std::string, NumberRange>;

struct FitSettings {
    std::optional<ModelId> model;  // none: what describes the data best with the fewest numbers
    int max_lobes = 3;             // on each side of the surface; fewer where more do not pay
    bool fixed_lobes = false;      // exactly max_lobes
    ParameterBounds bounds;
};

/// A material fitted to a measurement, and how well it does.
struct FitResult {
    Material material;
    int parameters = 0;                   // free numbers, kd included
    std::optional<double> normalised_l2;  // brdf_error.h, worst channel; of dense tables
    double l1 = 0;                        // Walkthrough 3.7, mean of the channels
    double seconds = 0;
    std::vector<std::string> notes;  // what a user should know: lobes that did not pay, data outside the model
};

}  // namespace burnish
