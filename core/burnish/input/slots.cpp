#include <burnish/input/slots.h>
#include <burnish/input/verify_layer.h>

#include <algorithm>

namespace burnish {
namespace {

bool is_wanted(Role role, const ReadOptions& options) {
    if (options.roles.empty() || options.roles.count(role) || options.channels.count(role)) return true;
    return role == Role::depth && options.roles.count(Role::position);  // position may have to come from it
}

void drop_counted_twice(std::vector<Slot>& slots) {
    const auto holds_both = [&](Role role) {
        return std::any_of(slots.begin(), slots.end(),
                           [&](const Slot& s) { return s.role == role && s.candidates.front().meaning.holds_both; });
    };
    const bool diffuse = holds_both(Role::diffuse_direct), specular = holds_both(Role::specular_direct);
    std::erase_if(slots, [&](const Slot& s) {
        return (diffuse && s.role == Role::diffuse_indirect) || (specular && s.role == Role::specular_indirect);
    });
}

}  // namespace

std::vector<Slot> wanted_slots(const ExrFile& file, const ReadOptions& options, Renderer renderer) {
    std::vector<Slot> slots;
    for (const RoleInfo& info : roles()) {
        if (!is_wanted(info.role, options)) continue;
        const auto chosen = options.channels.find(info.role);
        std::vector<Candidate> fitting =
            chosen == options.channels.end()
                ? candidates(info.role, file.layers(), renderer)
                : std::vector{chosen_candidate(file.name(), info.role, chosen->second, file.layers())};
        if (!fitting.empty()) slots.push_back({info.role, std::move(fitting)});
    }
    drop_counted_twice(slots);
    return slots;
}

void read_slots(const ExrFile& file, const std::vector<const Slot*>& slots, const RowStrips& rows, AovFrame& frame) {
    for (int begin = 0; begin < rows.rows; begin += rows.height) {
        const Window strip{rows.data.x, rows.data.y + rows.row(begin), rows.data.width, std::min(rows.height, rows.rows)};
        std::vector<ChannelRead> reads;
        for (const Slot* slot : slots) {
            const std::vector<Channel>& channels = slot->candidates.front().channels;
            const int count = static_cast<int>(channels.size());
            Image& image = frame.layers[slot->role];
            if (begin == 0) image = Image(rows.data.width, rows.rows, count);
            for (int c = 0; c < count; ++c) reads.push_back({channels[c], &image, c, begin});
        }
        file.read(reads, strip);
    }
}

void decode_slot(Slot& slot, AovFrame& frame) {
    slot.scrubbed += decode_layer(slot.role, slot.candidates.front(), slot.is_encoded, frame.layers.at(slot.role),
                                  frame.margin_above, frame.margin_below);
}

}  // namespace burnish
