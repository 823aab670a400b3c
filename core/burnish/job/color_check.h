// Frame and environment in different colours: what their headers say against each other, and against what the job says.
#pragma once

#include <burnish/input/frame.h>
#include <burnish/job/job.h>

#include <string>
#include <vector>

namespace burnish {

/// One line each, with its remedy; none where all agrees, or nobody says anything.
std::vector<std::string> color_warnings(const Job& job, const AovFrame& frame);

}  // namespace burnish
