// From a material and its light, or its BRDF alone, to maps that shade like it, with their errors known.
//
//     sample -> factor -> measure -> write      the same bits for any number of threads
#pragma once

#include <burnish/factor/factor_error.h>
#include <burnish/factor/stored_factors.h>
#include <burnish/job/factor_job.h>
#include <burnish/output/report.h>

#include <memory>
#include <optional>

namespace burnish {

struct FactorReport {
    StoredFactors stored;
    size_t samples = 0;
    FactorError error;                         // of the maps as they are, at the samples; relative to them and maps.bias
    std::optional<QuantisedFactors> pictures;  // where PNGs were written
    std::optional<FactorError> picture_error;
    std::optional<double> display_psnr_db;  // lighting: against the estimator `reference`, where it is seen
    NamedValues<double> seconds;            // by stage
    std::vector<std::string> files;         // written
};

/// `light`: instead of the job's environment; null: that one, or none, which factors the BRDF. Throws Error(bad_argument) for materials
/// that cannot be factored, see require_factorable, Error(read_failed | write_failed | color_space | cancelled).
FactorReport make_factors(const FactorJob& job, std::shared_ptr<const Environment> light, const Progress& progress);

/// Everything but the maps.
nlohmann::json factor_report_to_json(const FactorReport& report);

}  // namespace burnish
