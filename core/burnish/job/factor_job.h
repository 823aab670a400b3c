// What `burnish factor` factors, and into what, as plain values, and their JSON form:
//
//     { "material": "gold", "env": "sky.hdr", "env_rotate": 90, "parametrization": "nr", "quality": "high", "output": "gold.exr" }
//
// Beside its own fields it takes the settings of the environment and its colour space, `estimator`, `samples` and `threads`
// (settings.h). Without an environment it is the BRDF that is factored.
#pragma once

#include <burnish/factor/factorise.h>
#include <burnish/factor/quantise.h>
#include <burnish/job/job.h>
#include <burnish/shading/lighting_samples.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace burnish {

/// `homomorphic`: factorise.h; `svd`, `normalised`: decompose.h, BRDFs over two maps only.
enum class FactorMethod { homomorphic, svd, normalised };

/// How many texels and samples there are where nothing else is said.
enum class FactorQuality { preview, normal, high };

struct FactorJob {
    std::string material;         // as find_material takes it, or JSON
    Job scene;                    // light, its colour space, estimator and threads
    std::string parametrization;  // "" = by what is factored
    FactorMethod method = FactorMethod::homomorphic;
    FactorQuality quality = FactorQuality::normal;
    FactoriseSettings maps;                // but for the measure
    std::optional<FactorMeasure> measure;  // left out: display under a light, relative of BRDFs
    int grid = 20;                         // texels a side of the discs that directions are taken from
    ViewWeight weight = ViewWeight::projected;
    QuantiseSettings eight_bit;     // what it leaves open is searched for
    std::string output, png, glsl;  // EXR, folder of 8-bit pictures, shader; "" = none
};

/// The values of "method", "quality", "measure" and "weight" in the order of their enumerators.
inline constexpr std::string_view kFactorMethods[] = {"homomorphic", "svd", "normalised"};
inline constexpr std::string_view kFactorQualities[] = {"preview", "normal", "high"};
inline constexpr std::string_view kFactorMeasures[] = {"relative", "display", "absolute"};
inline constexpr std::string_view kViewWeights[] = {"uniform", "projected"};

/// `where` names the values in messages. Throws Error(bad_argument).
FactorJob factor_job_from_json(const nlohmann::json& values, const std::string& where);

}  // namespace burnish
