// The layers that could play a role, best first: by name and by what the renderer means with it. Whether a candidate is
// what it says is role_checks.h's business.
#pragma once

#include <burnish/input/fingerprint.h>
#include <burnish/input/layers.h>
#include <burnish/input/roles.h>

#include <string>
#include <vector>

namespace burnish {

struct Candidate {
    std::string layer;
    std::vector<Channel> channels;  // as many as the role has, in its order
    Meaning meaning;
    bool is_inverted = false;  // glossiness: roughness = 1 - value
    bool is_chosen = false;    // by the user: problems are reported, but it is not passed over

    /// "ViewLayer.Normal (XYZ, float)".
    std::string description() const;
};

/// All layers that fit, best first: those beside the beauty (same view layer) before others, then in the order of the
/// role's aliases, then in the order of the file.
std::vector<Candidate> candidates(Role role, const std::vector<Layer>& layers, Renderer renderer);

/// The layer (or single channel) the user names for a role. Throws Error(missing_channel) that lists the file's layers when
/// there is none, or when it lacks components.
Candidate chosen_candidate(const std::string& file, Role role, const std::string& name, const std::vector<Layer>& layers);

/// Names of all layers with their components, "ViewLayer.Normal.XYZ, ViewLayer.Depth.Z".
std::string list_layers(const std::vector<Layer>& layers);

}  // namespace burnish
