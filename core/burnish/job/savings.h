// What a job left unmade, for the report: channels that nobody reads, lights that no pixel sees, levels that no lobe reads.
#pragma once

#include <burnish/input/frame.h>
#include <burnish/job/look.h>
#include <burnish/output/report.h>

#include <string>
#include <vector>

namespace burnish {

/// One line each, empty where all was needed.
std::vector<std::string> saved_reading(const AovFrame& frame);
std::vector<std::string> saved_light(const Rig& rig);

/// Sets what lights and materials have to tell, and what was saved of light: as lights are loaded when a pixel needs them, this changes
/// until the last frame.
void tell_of_lights(const Look& look, Report& report);

}  // namespace burnish
