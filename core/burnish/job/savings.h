// What a job left unmade, for the report: channels that nobody reads, lights that no pixel sees, levels that no lobe reads.
#pragma once

#include <burnish/input/frame.h>
#include <burnish/job/rig.h>

#include <string>
#include <vector>

namespace burnish {

/// One line each, empty where all was needed.
std::vector<std::string> saved_reading(const AovFrame& frame);
std::vector<std::string> saved_light(const Rig& rig);

}  // namespace burnish
