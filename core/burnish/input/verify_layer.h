// A layer just read against what its role promises: judged by numbers, and brought to the role's form where it is stored
// otherwise. Judging may look at a part of the pixels; decoding is for every pixel.
#pragma once

#include <burnish/base/image.h>
#include <burnish/input/candidates.h>

#include <string>

namespace burnish {

struct Verdict {
    bool is_sound = true;
    bool is_encoded = false;  // directions stored as 0..1
    std::string finding;      // what the numbers say, "unit length (median 1.000)"; may be empty
    std::string warning;      // what may go wrong although the layer is taken; may be empty
};

/// Whether verify_layer looks at the pixels of this role: directions and position. The others are what their name says.
bool is_judged(Role role);

/// Judges `image` as `role`.
Verdict verify_layer(Role role, const Candidate& candidate, const Image& image);

/// Brings a layer to its role's form: encoded vectors are decoded, glossiness becomes roughness, NaN and infinity in colour
/// become 0. Data layers keep theirs: the surface stage masks those pixels. Returns how many pixels of colour were set to 0, but
/// for `above` rows at the top and `below` rows at the bottom.
size_t decode_layer(Role role, const Candidate& candidate, bool is_encoded, Image& image, int above, int below);

}  // namespace burnish
