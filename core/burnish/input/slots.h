// The roles a job wants of a file, and the layers that may fill each: what is decoded first, and what next if that fails.
#pragma once

#include <burnish/input/candidates.h>
#include <burnish/input/exr_file.h>
#include <burnish/input/exr_reader.h>
#include <burnish/input/row_strips.h>

#include <string>
#include <vector>

namespace burnish {

struct Slot {
    Role role;
    std::vector<Candidate> candidates;  // never empty, best first; the front one is read
    std::string finding = {};           // what the numbers say about it
    bool is_encoded = false;            // directions stored as 0..1
    size_t scrubbed = 0;                // pixels of colour that were not finite and were set to 0

    std::string name() const { return std::string(role_info(role).name); }
};

/// One slot per wanted role that any layer fits by name. A pass that holds direct and indirect light together stands in the
/// direct role; the indirect one is then left out, it would count twice.
std::vector<Slot> wanted_slots(const ExrFile& file, const ReadOptions& options, Renderer renderer);

/// Reads the front candidate of every slot into the frame, as stored, in one pass over the file. `rows`: which of them.
void read_slots(const ExrFile& file, const std::vector<const Slot*>& slots, const RowStrips& rows, AovFrame& frame);

/// Brings the layer that was read for the slot to its role's form.
void decode_slot(Slot& slot, AovFrame& frame);

}  // namespace burnish
