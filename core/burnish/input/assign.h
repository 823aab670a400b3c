// Which material each pixel wears, and by which lights it is lit: rules over object index, material index and cryptomatte names;
// later rules win.
#pragma once

#include <burnish/input/frame.h>

#include <optional>
#include <string>
#include <vector>

namespace burnish {

/// One line of the shot file's "assign"; a rule with no selector takes the whole frame, one with several takes what all of
/// them select.
struct AssignRule {
    std::string material;  // name in the job's materials, a preset or a file
    std::optional<int> object_index, material_index;
    std::string cryptomatte;              // object names as in matching_ids(), "" = none; "CryptoMaterial:brass*"
                                          // looks in that cryptomatte instead of the first that lists a match
    std::vector<std::string> chain = {};  // names of its lights, the first in front; empty: the job's
};

/// Per pixel: index into the list of rules (-1 = none) and the share of the pixel it covers, in [0, 1].
struct Assignment {
    int width = 0, height = 0;
    PixelVector<int16_t> rule;
    PixelVector<float> coverage;
    std::vector<size_t> counts;  // pixels per rule, an entry for each
};

/// Gives each pixel the rule that covers most of it. Where rules select the same object the last one takes it, and what
/// earlier rules cover is at most what later ones leave. Index layers have no coverage: what they select is covered wholly.
/// Throws Error(missing_channel) when a rule needs ids the frame does not have.
Assignment assign_rules(const AovFrame& frame, const std::vector<AssignRule>& rules);

}  // namespace burnish
