// What sparse shading keeps of dense shading, over spheres of two sizes.
#pragma once

#include "error_cases.h"

#include <map>
#include <vector>

namespace burnish {

/// Display PSNR to dense shading in dB by safety: of some lobes, sizes and the lights.
std::map<float, std::vector<double>> measure_sparse_errors(const std::vector<NamedLight>& lights, const Progress& progress);

}  // namespace burnish
