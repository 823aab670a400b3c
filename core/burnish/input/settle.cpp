#include <burnish/input/role_checks.h>
#include <burnish/input/settle.h>
#include <burnish/input/verify_layer.h>

#include <cstdio>

namespace burnish {
namespace {

constexpr double kFacingShare = 0.9;

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof(text), "%.1f %%", 100 * share);
    return text;
}

Facing facing_of_frame(const AovFrame& frame) {
    return facing_share(frame.layer(Role::normal), frame.layer(Role::position), frame.camera->centre);
}

/// Reads the next candidate in place of the first.
void pass_over(const ExrFile& file, Slot& slot, const RowStrips& rows, AovFrame& frame) {
    slot.candidates.erase(slot.candidates.begin());
    read_slots(file, {&slot}, rows, frame);
}

/// What the numbers say about the layer just read, which is decoded by them.
Verdict judge(Slot& slot, AovFrame& frame) {
    const Verdict verdict = verify_layer(slot.role, slot.candidates.front(), frame.layers.at(slot.role));
    slot.finding = verdict.finding, slot.is_encoded = verdict.is_encoded;
    decode_slot(slot, frame);
    return verdict;
}

std::string doubt_about(const std::string& layer, double share) {
    const std::string start = "normal: " + layer;
    if (share < 1 - kFacingShare)
        return start + " points away from the camera on " + percent(1 - share) +
               " of pixels: the normals are flipped, or position and normal are of different spaces";
    return start + " faces the camera on only " + percent(share) +
           " of pixels: it may be in camera space; burnish needs world space. Name another layer with --channel normal=NAME";
}

void warn_unchecked(const Candidate& normal, AovFrame& frame) {
    if (normal.meaning.is_camera_space)
        frame.warnings.push_back("normal: " + normal.layer + " is in camera space by the renderer's habit, and could not be " +
                                 "checked without position and camera; burnish needs world space");
}

}  // namespace

void settle(const ExrFile& file, Slot& slot, const RowStrips& rows, AovFrame& frame) {
    for (;; pass_over(file, slot, rows, frame)) {
        const Candidate& candidate = slot.candidates.front();
        const Verdict verdict = judge(slot, frame);
        if (!verdict.warning.empty()) frame.warnings.push_back(verdict.warning);
        if (verdict.is_sound) return;

        const std::string complaint = slot.name() + ": " + candidate.layer + " is " + verdict.finding;
        if (candidate.is_chosen) return frame.warnings.push_back(complaint + ", but was asked for");
        if (slot.candidates.size() == 1) {
            frame.layers.erase(slot.role);
            return frame.warnings.push_back(complaint + " and is not used; name another layer with --channel " + slot.name() +
                                            "=NAME");
        }
        frame.notes.push_back(complaint + ", passed over");
    }
}

void settle_facing(const ExrFile& file, Slot& slot, const RowStrips& rows, AovFrame& frame) {
    if (!frame.has(Role::normal)) return;
    const Facing first = frame.has(Role::position) && frame.camera ? facing_of_frame(frame) : Facing{};
    const auto accept = [&](const Facing& facing) {
        slot.finding += ", facing the camera on " + percent(facing.share) + " of pixels";
    };
    if (first.pixels == 0) return warn_unchecked(slot.candidates.front(), frame);
    if (first.share > kFacingShare) return accept(first);

    const Slot first_slot = slot;
    const Image first_image = frame.layer(Role::normal);
    const std::string doubt = doubt_about(slot.candidates.front().layer, first.share);
    while (slot.candidates.size() > 1) {
        pass_over(file, slot, rows, frame);
        const Verdict verdict = judge(slot, frame);
        const Facing facing = facing_of_frame(frame);
        if (!verdict.is_sound || facing.share <= kFacingShare) continue;
        frame.notes.push_back(doubt + ", passed over");
        return accept(facing);
    }
    slot = first_slot;
    frame.layers[Role::normal] = first_image;
    frame.warnings.push_back(doubt);
}

}  // namespace burnish
