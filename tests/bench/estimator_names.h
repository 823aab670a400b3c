// The few-sample estimators by the names that benches take.
#pragma once

#include <burnish/sampling/estimator.h>

#include <map>
#include <string>

namespace burnish {

inline const std::map<std::string, EstimatorKind> kEstimators{{"fitted", EstimatorKind::fitted},
                                                              {"regular", EstimatorKind::regular},
                                                              {"filtered_importance", EstimatorKind::filtered_importance},
                                                              {"preconvolved", EstimatorKind::preconvolved},
                                                              {"split_sum", EstimatorKind::split_sum},
                                                              {"factored", EstimatorKind::factored}};

}  // namespace burnish
