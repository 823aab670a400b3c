// Which of a slot's candidates is taken: the first that is what its name says. Further ones are decoded only when needed; a
// layer the user named is kept whatever the numbers say, with a warning.
#pragma once

#include <burnish/input/slots.h>

namespace burnish {

/// Judges the layer that was read for the slot by itself, and decodes it. When no candidate is sound the role is taken out of
/// the frame.
void settle(const ExrFile& file, Slot& slot, const RowStrips& rows, AovFrame& frame);

/// Judges normals by the camera: those in another space, or turned inside out, have unit length too, but face away. When no
/// candidate faces the camera on more than 90 % of the interior pixels, the first one stays, with a warning.
void settle_facing(const ExrFile& file, Slot& slot, const RowStrips& rows, AovFrame& frame);

}  // namespace burnish
