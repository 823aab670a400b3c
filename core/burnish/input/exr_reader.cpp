#include <burnish/base/error.h>
#include <burnish/input/channel_names.h>
#include <burnish/input/exr_reader.h>
#include <burnish/input/frame_geometry.h>
#include <burnish/input/metadata_spec.h>
#include <burnish/input/read_cryptomattes.h>
#include <burnish/input/settle.h>

#include <algorithm>
#include <new>

namespace burnish {
namespace {

/// A frame without pixels. Windows and attributes are those of the part that holds the first role found: the beauty's, when
/// there is one.
AovFrame empty_frame(const ExrFile& file, const std::vector<Slot>& slots, const Fingerprint& print) {
    const int part = slots.empty() ? 0 : slots.front().candidates.front().channels.front().part;
    AovFrame frame;
    frame.file = file.name();
    frame.renderer = print.renderer;
    frame.divided_by_albedo = print.renderer == Renderer::cycles;
    frame.data_window = file.data_window(part);
    frame.display_window = file.display_window();
    auto metadata = std::make_shared<Metadata>(*file.metadata(part));
    metadata->layers = list_layers(file.layers());
    frame.metadata = metadata;

    std::string line = "written by " + std::string(renderer_name(print.renderer));
    if (!print.evidence.empty()) line += " (" + print.evidence + ")";
    frame.notes.push_back(line + (file.view().empty() ? "" : ", view " + file.view()));
    return frame;
}

/// Camera and depth, and what they say about position and normal.
void settle_geometry(const ExrFile& file, std::vector<Slot>& slots, const ReadOptions& options, AovFrame& frame) {
    find_camera(frame, options.camera);
    judge_depth(frame);
    for (Slot& slot : slots) {
        const std::string form = normal_form(slot.candidates.front().layer);
        if (slot.role == Role::depth) complete_position(frame, depth_is_ray_length(frame.renderer, form));
    }
    for (Slot& slot : slots)
        if (slot.role == Role::normal) settle_facing(file, slot, frame);
}

void note_layer(const ExrFile& file, const Slot& slot, AovFrame& frame) {
    if (!frame.has(slot.role)) return;
    const Candidate& candidate = slot.candidates.front();
    std::string line = slot.name() + ": " + candidate.description();
    if (!candidate.meaning.remark.empty()) line += ", " + std::string(candidate.meaning.remark);
    if (!slot.finding.empty()) line += ", " + slot.finding;
    if (candidate.is_chosen) line += ", as asked";
    if (!(file.data_window(candidate.channels.front().part) == frame.data_window))
        line += ", of another data window, 0 outside";
    frame.notes.push_back(line);
}

void add_cryptomattes(const ExrFile& file, AovFrame& frame) {
    frame.cryptomattes = read_cryptomattes(file, frame.data_window, frame.warnings);
    for (const Cryptomatte& matte : frame.cryptomattes) {
        const std::string names =
            matte.manifest.empty() ? "no list of names" : std::to_string(matte.manifest.size()) + " names";
        frame.notes.push_back("cryptomatte: " + matte.name + ", " + std::to_string(matte.ranks.size()) + " ranks, " + names);
    }
}

AovFrame read_checked(const std::string& name, const ReadOptions& options) {
    const ExrFile file(name, options.view);
    const Fingerprint print = fingerprint(*file.metadata(0), file.layers());
    std::vector<Slot> slots = wanted_slots(file, options, print.renderer);
    AovFrame frame = empty_frame(file, slots, print);
    read_slots(file, slots, frame);
    for (Slot& slot : slots) settle(file, slot, frame);
    settle_geometry(file, slots, options, frame);
    for (const Slot& slot : slots) note_layer(file, slot, frame);
    if (options.cryptomattes) add_cryptomattes(file, frame);
    return frame;
}

}  // namespace

AovFrame read_frame(const std::string& file, const ReadOptions& options) {
    try {
        return read_checked(file, options);
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::read_failed, file + ": there is not enough memory to read it; ask for fewer roles");
    }
}

}  // namespace burnish
