// Which lights each pixel has: those that its rule names, or those that belong where it is.
//
// By place, in this order: the mirror and the pane on whose plane the pixel lies, all area lights, what is traced or else the cube
// map with the nearest centre, the environment.
#pragma once

#include <burnish/input/assign.h>
#include <burnish/job/rig.h>

#include <vector>

namespace burnish {

/// A rule's material under one chain of lights.
struct LitRule {
    size_t rule;
    RigChain chain;
};

/// Assignment::rule and its counts index `looks`.
struct LitAssignment {
    Assignment assignment;
    std::vector<LitRule> looks;  // those that some pixel has; in the order of rules
};

/// `assignment` is by rule. Same looks, in the same order, for any thread count. Throws Error(missing_channel) when lights are
/// chosen by place and the frame has no position.
LitAssignment assign_lights(const AovFrame& frame, Assignment assignment, const Rig& rig);

}  // namespace burnish
