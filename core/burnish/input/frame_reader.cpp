#include <burnish/base/error.h>
#include <burnish/input/channel_names.h>
#include <burnish/input/depth.h>
#include <burnish/input/frame_geometry.h>
#include <burnish/input/frame_reader.h>
#include <burnish/input/lossy.h>
#include <burnish/input/metadata_spec.h>
#include <burnish/input/read_cryptomattes.h>
#include <burnish/input/role_checks.h>
#include <burnish/input/settle.h>
#include <burnish/input/told_space.h>
#include <burnish/input/verify_layer.h>

#include <algorithm>
#include <bit>
#include <new>
#include <utility>

namespace burnish {
namespace {

constexpr size_t kJudgedPixels = size_t{1} << 21;  // just above 1920 x 1080
constexpr size_t kFewestHits = 20000;              // pixels on surfaces that strips should see

std::string view_list(const std::vector<std::string>& views) {
    std::string text;
    for (const std::string& view : views) text += (text.empty() ? "" : ", ") + view;
    return text;
}

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
    frame.notes.push_back(line);
    if (!file.view().empty()) frame.notes.push_back("view " + file.view() + " of " + view_list(file.views()));
    if (const ToldSpace told = told_space(*frame.metadata); !told.evidence.empty())
        frame.notes.push_back("colour: " + (told.space.empty() ? "" : told.space + ", by ") + told.evidence);
    return frame;
}

void note_layer(const ExrFile& file, const Slot& slot, AovFrame& frame) {
    const Candidate& candidate = slot.candidates.front();
    std::string line = slot.name() + ": " + candidate.description();
    if (!candidate.meaning.remark.empty()) line += ", " + std::string(candidate.meaning.remark);
    if (candidate.is_inverted) line += ", glossiness, turned into roughness 1 - g";
    if (!slot.finding.empty()) line += ", " + slot.finding;
    if (candidate.is_chosen) line += ", as asked";
    if (!(file.data_window(candidate.channels.front().part) == frame.data_window))
        line += ", of another data window, 0 outside";
    frame.notes.push_back(line);
}

/// The channels lie in one part.
void warn_of_packing(const ExrFile& file, const std::string& name, const std::vector<Channel>& channels, AovFrame& frame) {
    const std::string packing = file.compression(channels.front().part);
    std::string changed;
    for (const std::string& channel : changed_channels(packing, channels)) changed += (changed.empty() ? "" : ", ") + channel;
    if (!changed.empty())
        frame.warnings.push_back(name + ": " + packing + " compression has changed " + changed +
                                 "; write data layers and ids with zip");
}

void warn_of_packing(const ExrFile& file, const std::vector<Slot>& slots, AovFrame& frame) {
    for (const Slot& slot : slots) {
        const std::vector<Channel>& channels = slot.candidates.front().channels;
        const bool is_fine = role_info(slot.role).is_color || slot.role == Role::alpha ||
                             file.compression(channels.front().part) == "pxr24";  // 24 bits are enough for what is no id
        if (!is_fine) warn_of_packing(file, slot.name(), channels, frame);
    }
}

void add_cryptomattes(const ExrFile& file, AovFrame& frame) {
    frame.cryptomattes = find_cryptomattes(file, frame.warnings);
    for (const Cryptomatte& matte : frame.cryptomattes) {
        const std::string names =
            matte.manifest.empty() ? "no list of names" : std::to_string(matte.manifest.size()) + " names";
        warn_of_packing(file, "cryptomatte " + matte.name, channels_of(file, matte), frame);
        frame.notes.push_back("cryptomatte: " + matte.name + ", " + std::to_string(matte.channels.size() / 2) + " ranks, " +
                              names);
    }
}

void count_channels(const ExrFile& file, const std::vector<Slot>& slots, AovFrame& frame) {
    auto metadata = std::make_shared<Metadata>(*frame.metadata);
    ChannelCounts& counts = metadata->channels;
    for (const Layer& layer : file.layers()) counts.all += layer.channels.size();
    for (const Slot& slot : slots) counts.decoded += slot.candidates.front().channels.size();
    for (const Cryptomatte& matte : frame.cryptomattes) counts.decoded += matte.channels.size();
    frame.metadata = std::move(metadata);
}

/// Roles whose pixels decide how the frame is read.
bool is_decisive(Role role) { return is_judged(role) || role == Role::depth; }

int block_rows(const ExrFile& file, const std::vector<Slot>& slots) {
    int rows = 1;
    for (const Slot& slot : slots)
        for (const Channel& channel : slot.candidates.front().channels) rows = std::max(rows, file.block_rows(channel.part));
    return rows;
}

void warn_of_scrubbed(const std::vector<Slot>& slots, AovFrame& frame) {
    for (const Slot& slot : slots)
        if (slot.scrubbed > 0)
            frame.warnings.push_back(slot.name() + ": " + std::to_string(slot.scrubbed) +
                                     " pixels are not finite numbers and were set to 0");
}

[[noreturn]] void fail_memory(const std::string& file) {
    throw Error(ErrorCode::read_failed, file + ": there is not enough memory to read it; ask for fewer roles");
}

}  // namespace

FrameReader::FrameReader(const std::string& file, const ReadOptions& options, size_t band_pixels) try
    : m_file(file, options.view),
      m_shaded_block(options.shaded_block),
      m_print(fingerprint(*m_file.metadata(0), m_file.layers())),
      m_slots(wanted_slots(m_file, options, m_print.renderer)),
      m_frame(empty_frame(m_file, m_slots, m_print)) {
    plan_bands(band_pixels);
    judge(options);
    add_substitutes(options);
    m_whole = std::exchange(m_frame.layers, {});
    for (const Slot& slot : m_slots) note_layer(m_file, slot, m_frame);
    warn_of_packing(m_file, m_slots, m_frame);
    if (options.cryptomattes) add_cryptomattes(m_file, m_frame);
    count_channels(m_file, m_slots, m_frame);
} catch (const std::bad_alloc&) {
    fail_memory(file);
}

void FrameReader::plan_bands(size_t band_pixels) {
    const Window& window = m_frame.data_window;
    const unsigned block = static_cast<unsigned>(block_rows(m_file, m_slots));
    const size_t width = static_cast<size_t>(std::max(window.width, 1)),
                 height = static_cast<size_t>(std::max(window.height, 1));
    const unsigned rows = static_cast<unsigned>(std::clamp<size_t>(band_pixels / width, 1, height));
    m_band_rows = static_cast<int>(rows == height ? rows : rows >= block ? rows / block * block : std::bit_floor(rows));
    m_band_count = (window.height + m_band_rows - 1) / m_band_rows;
}

void FrameReader::judge(const ReadOptions& options) {
    const std::vector<Slot> slots = m_slots;
    const AovFrame frame = m_frame;
    for (size_t pixels = kJudgedPixels;; pixels *= 4) {
        const RowStrips rows = RowStrips::spread(frame.data_window, block_rows(m_file, slots), pixels);
        m_is_read = m_band_count == 1 && rows.is_whole();
        judge_rows(options, rows);
        if (rows.is_whole() || sees_surface()) break;
        m_slots = slots, m_frame = frame, m_depth_is_ray.reset();
    }
    if (!m_is_read) m_frame.layers.clear();
}

/// Layers that are not looked at are sound by their names.
void FrameReader::judge_rows(const ReadOptions& options, const RowStrips& rows) {
    std::vector<const Slot*> looked_at;
    for (const Slot& slot : m_slots)
        if (m_is_read || is_decisive(slot.role)) looked_at.push_back(&slot);
    read_slots(m_file, looked_at, rows, m_frame);
    for (Slot& slot : m_slots)
        if (m_frame.has(slot.role)) settle(m_file, slot, rows, m_frame);
    settle_geometry(options, rows);
    std::erase_if(m_slots, [&](const Slot& s) { return (m_is_read || is_decisive(s.role)) && !m_frame.has(s.role); });
}

/// Camera and depth, and what they say about position and normal.
void FrameReader::settle_geometry(const ReadOptions& options, const RowStrips& rows) {
    find_camera(m_frame, rows, options.camera);
    judge_depth(m_frame, rows);
    for (const Slot& slot : m_slots)
        if (const Candidate& layer = slot.candidates.front();
            slot.role == Role::position && layer.channels.front().type == ChannelType::half)
            warn_of_half_positions(layer.layer, m_frame);
    for (const Slot& slot : m_slots) {
        const bool is_ray = depth_is_ray_length(m_print.renderer, normal_form(slot.candidates.front().layer));
        if (slot.role == Role::depth && complete_position(m_frame, rows, is_ray)) m_depth_is_ray = is_ray;
    }
    for (Slot& slot : m_slots)
        if (slot.role == Role::normal) settle_facing(m_file, slot, rows, m_frame);
}

/// Strips may miss what a small object in a large frame shows.
bool FrameReader::sees_surface() const {
    if (const Image* position = m_frame.find(Role::position)) return check_positions(*position).pixels >= kFewestHits;
    return !has_slot(Role::depth);
}

void FrameReader::add_substitutes(const ReadOptions& options) {
    for (const auto& [role, substitutes] : options.substitutes) {
        if (has_slot(role)) continue;
        ReadOptions more;
        more.roles = substitutes;
        for (Slot& slot : wanted_slots(m_file, more, m_print.renderer)) {
            if (has_slot(slot.role)) continue;
            if (m_is_read) read_slots(m_file, {&slot}, m_frame.data_window, m_frame), decode_slot(slot, m_frame);
            m_slots.push_back(std::move(slot));
        }
    }
    std::stable_sort(m_slots.begin(), m_slots.end(), [](const Slot& a, const Slot& b) { return a.role < b.role; });
}

bool FrameReader::has_slot(Role role) const {
    return std::any_of(m_slots.begin(), m_slots.end(), [&](const Slot& slot) { return slot.role == role; });
}

AovFrame FrameReader::read_band() {
    const int begin = m_bands_read++ * m_band_rows;
    return read_rows(begin, std::min(begin + m_band_rows, m_frame.data_window.height), 0, m_bands_read == m_band_count);
}

AovFrame FrameReader::read_rows(int begin, int end, int shaded, bool is_last) try {
    const int height = m_frame.data_window.height, block = m_shaded_block;
    int top = begin - shaded, bottom = end + shaded;
    if (block > 1) top = (top / block - 1) * block, bottom = ((bottom - 1) / block + 2) * block + 1;
    AovFrame band = m_frame;
    band.shaded_above = std::min(begin - top, begin), band.shaded_below = std::min(bottom - end, height - end);
    const int more = has_slot(Role::uv) ? block : 0;
    band.margin_above = std::min(begin - top + more, begin), band.margin_below = std::min(bottom - end + more, height - end);
    band.data_window.y += begin - band.margin_above;
    band.data_window.height = end - begin + band.margin_above + band.margin_below;
    const bool is_whole = band.data_window == m_frame.data_window;
    if (is_whole && !m_whole.empty())
        band.layers = std::exchange(m_whole, {});
    else
        read_pixels(band);
    for (Cryptomatte& matte : band.cryptomattes) read_ranks(m_file, band.data_window, matte);
    if (is_last) warn_of_scrubbed(m_slots, band);
    return band;
} catch (const std::bad_alloc&) {
    fail_memory(m_file.name());
}

void FrameReader::read_pixels(AovFrame& band) {
    if (!std::exchange(m_whole, {}).empty())
        for (Slot& slot : m_slots) slot.scrubbed = 0;
    std::vector<const Slot*> slots;
    for (const Slot& slot : m_slots) slots.push_back(&slot);
    read_slots(m_file, slots, band.data_window, band);
    for (Slot& slot : m_slots) decode_slot(slot, band);
    if (m_depth_is_ray)
        band.layers[Role::position] =
            position_from_depth(band.layer(Role::depth), *band.camera, band.data_window, band.display_window, *m_depth_is_ray);
}

}  // namespace burnish
