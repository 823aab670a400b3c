// Light thrown back towards where it came from, which no model of burnish does: told from the table alone.
#pragma once

#include <burnish/fit/search/transfer_samples.h>

namespace burnish {

/// Mean f close to three kinds of direction, over incident directions whose mirror direction is far from them.
struct RetroReflection {
    float back = 0;    // within kCone_deg of the incident direction
    float around = 0;  // in a ring about it
    float mirror = 0;  // within kCone_deg of the mirror direction

    /// A peak about the incident direction: models fall off or stay level there.
    bool seen() const { return back > kPeak * around && around > 0; }

    static constexpr float kCone_deg = 6, kPeak = 2;
};

/// All 0 where the table is not recorded around the incident directions, as gonioreflectometers shadow themselves there.
RetroReflection retro_reflection(const TransferSamples& samples);

}  // namespace burnish
