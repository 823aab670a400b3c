// Which material each pixel wears: rules over object index, material index and cryptomatte names; later rules win.
#pragma once

#include <burnish/input/frame.h>

#include <optional>
#include <string>
#include <vector>

namespace burnish {

/// One line of the shot file's "assign"; a rule with no selector takes the whole frame.
struct AssignRule {
    std::string material;                          // name in the job's materials, a preset or a file
    std::optional<int> object_index, material_index;
    std::string cryptomatte;                       // wildcard pattern over object names, "" = none
};

/// Per pixel: index into the list of rules (-1 = none) and the share of the pixel it covers, in [0, 1].
struct Assignment {
    int width = 0, height = 0;
    std::vector<int16_t> rule;
    std::vector<float> coverage;
    std::vector<size_t> counts;                    // pixels per rule
};

/// Throws Error(missing_channel) when a rule needs ids the frame does not have.
Assignment assign_rules(const AovFrame& frame, const std::vector<AssignRule>& rules);

}  // namespace burnish
