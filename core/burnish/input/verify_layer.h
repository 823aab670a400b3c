// A layer just read against what its role promises: judged by numbers, decoded where it is stored otherwise.
#pragma once

#include <burnish/base/image.h>
#include <burnish/input/candidates.h>

#include <string>

namespace burnish {

struct Verdict {
    bool is_sound = true;
    std::string finding;  // what the numbers say, "unit length (median 1.000)"; may be empty
    std::string warning;  // what may go wrong although the layer is taken; may be empty
};

/// Judges `image` as `role`, and brings it to the role's form: encoded vectors are decoded, glossiness becomes roughness,
/// NaN and infinity in colour become 0. Data layers keep theirs: the surface stage masks those pixels.
Verdict verify_layer(Role role, const Candidate& candidate, Image& image);

}  // namespace burnish
