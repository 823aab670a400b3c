#include <burnish/base/error.h>
#include <burnish/input/exr_file.h>
#include <burnish/input/exr_header.h>
#include <burnish/input/metadata_spec.h>

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <thread>

namespace burnish {

struct ExrFile::Parts {
    std::unique_ptr<OIIO::ImageInput> input;
    std::vector<OIIO::ImageSpec> specs;
};

namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
    throw Error(ErrorCode::read_failed, file + ": cannot be read: " + why + "; is it complete? Write it again");
}

PartNames part_names(const OIIO::ImageSpec& spec) {
    PartNames names;
    names.name = spec.get_string_attribute("oiio:subimagename");
    names.view = spec.get_string_attribute("view");
    names.channels = spec.channelnames;
    for (int c = 0; c < spec.nchannels; ++c) {
        const OIIO::TypeDesc type = spec.channelformat(c);
        names.types.push_back(type == OIIO::TypeHalf     ? ChannelType::half
                              : type == OIIO::TypeUInt32 ? ChannelType::uint32
                                                         : ChannelType::float32);
    }
    if (const OIIO::ParamValue* views = spec.find_attribute("multiView"))
        for (int i = 0; i < views->type().arraylen; ++i) names.multi_view.push_back(views->get_string_indexed(i));
    return names;
}

std::string choose_view(const std::string& file, const std::vector<std::string>& views, const std::string& wanted) {
    if (views.empty()) return "";
    if (wanted.empty()) return views.front();
    if (std::find(views.begin(), views.end(), wanted) != views.end()) return wanted;
    std::string known;
    for (const std::string& view : views) known += (known.empty() ? "" : ", ") + view;
    throw Error(ErrorCode::bad_argument, file + ": there is no view \"" + wanted + "\"; the file has " + known);
}

/// Channels [begin, end) of one part, which one call can read, and where they go.
struct Run {
    int begin, end;
    bool is_integer;  // uint channels are read as such: OpenImageIO would scale them to 0..1
    std::vector<const ChannelRead*> reads;
};

/// Per part, neighbouring channels joined: few calls, and no channel decoded that nobody wants.
std::map<int, std::vector<Run>> runs_by_part(const std::vector<ChannelRead>& reads) {
    std::map<std::pair<int, int>, std::vector<const ChannelRead*>> sorted;
    for (const ChannelRead& read : reads) sorted[{read.channel.part, read.channel.index}].push_back(&read);
    std::map<int, std::vector<Run>> parts;
    for (const auto& [place, same_channel] : sorted) {
        std::vector<Run>& runs = parts[place.first];
        const bool is_integer = same_channel.front()->channel.type == ChannelType::uint32;
        if (runs.empty() || runs.back().end != place.second || runs.back().is_integer != is_integer)
            runs.push_back({place.second, place.second, is_integer, {}});
        runs.back().end = place.second + 1;
        runs.back().reads.insert(runs.back().reads.end(), same_channel.begin(), same_channel.end());
    }
    return parts;
}

int rows_of_block(const OIIO::ImageSpec& spec) {
    if (spec.tile_width) return spec.tile_height;
    const std::string compression = spec.get_string_attribute("compression");
    if (compression == "zip" || compression == "pxr24") return 16;
    if (compression == "piz" || compression.starts_with("b44") || compression.starts_with("dwaa")) return 32;
    return compression.starts_with("dwab") ? 256 : 1;
}

/// Size of the pieces a part is read in. OpenEXR keeps its last few blocks unpacked (two a thread): when several runs are
/// read piece by piece, one after the other, each block is unpacked once and not once per run (3 times faster on a Cycles
/// frame of 54 channels, 11 of them wanted).
std::pair<int, int> piece_size(const OIIO::ImageSpec& spec, size_t runs) {
    constexpr int kRowsOfOneRun = 256;
    const int threads = OIIO::get_int_attribute("exr_threads");
    const int kept = 2 * std::max(threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency()), 1);
    if (spec.tile_width) {
        const int rows = runs > 1 ? spec.tile_height : std::max(kRowsOfOneRun / spec.tile_height, 1) * spec.tile_height;
        return {runs > 1 ? std::min(kept, spec.width / spec.tile_width + 1) * spec.tile_width : spec.width, rows};
    }
    return {spec.width, runs > 1 ? kept * rows_of_block(spec) : kRowsOfOneRun};
}

/// The pixels of one piece, in the file's own coordinates, to the images laid out as `window`.
void scatter(const Run& run, const Window& piece, const std::vector<float>& pixels, const Window& window) {
    const int stride = run.end - run.begin;
    const int left = std::max(piece.x, window.x), right = std::min(piece.x + piece.width, window.x + window.width);
    const int top = std::max(piece.y, window.y), bottom = std::min(piece.y + piece.height, window.y + window.height);
    for (int y = top; y < bottom; ++y) {
        const size_t row = static_cast<size_t>(y - piece.y) * piece.width;
        for (const ChannelRead* read : run.reads) {
            size_t from = (row + left - piece.x) * stride + read->channel.index - run.begin;
            for (int x = left; x < right; ++x, from += stride)
                read->image->at(x - window.x, y - window.y + read->top)[read->component] = pixels[from];
        }
    }
}

bool read_piece(OIIO::ImageInput& input, int part, const OIIO::ImageSpec& spec, const Run& run, const Window& piece,
                float* pixels) {
    const int right = piece.x + piece.width, bottom = piece.y + piece.height;
    const OIIO::TypeDesc type = run.is_integer ? OIIO::TypeUInt32 : OIIO::TypeFloat;
    const bool is_read =
        spec.tile_width ? input.read_tiles(part, 0, piece.x, right, piece.y, bottom, 0, 1, run.begin, run.end, type, pixels)
                        : input.read_scanlines(part, 0, piece.y, bottom, 0, run.begin, run.end, type, pixels);
    const size_t values = static_cast<size_t>(piece.width) * piece.height * (run.end - run.begin);
    for (size_t i = 0; is_read && run.is_integer && i < values; ++i)
        pixels[i] = static_cast<float>(std::bit_cast<uint32_t>(pixels[i]));
    return is_read;
}

void read_part(OIIO::ImageInput& input, const std::string& file, int part, const OIIO::ImageSpec& spec,
               const std::vector<Run>& runs, const Window& window) {
    std::vector<float> pixels;
    const auto [width, height] = piece_size(spec, runs.size());
    const int block = rows_of_block(spec), top = std::max(window.y - spec.y, 0) / block * block;
    const int wanted = std::min(window.y + window.height - spec.y, spec.height);
    const int bottom = std::min((wanted + block - 1) / block * block, spec.height);
    for (int y = top; y < bottom; y += height) {
        for (int x = 0; x < spec.width; x += width) {
            const Window piece = {spec.x + x, spec.y + y, std::min(width, spec.width - x), std::min(height, bottom - y)};
            for (const Run& run : runs) {
                pixels.resize(static_cast<size_t>(piece.width) * piece.height * (run.end - run.begin));
                if (!read_piece(input, part, spec, run, piece, pixels.data())) refuse(file, input.geterror());
                scatter(run, piece, pixels, window);
            }
        }
    }
}

}  // namespace

ExrFile::ExrFile(const std::string& file, const std::string& view) : m_name(file), m_parts(std::make_unique<Parts>()) {
    check_exr_header(file);
    m_parts->input = OIIO::ImageInput::create("openexr");
    OIIO::ImageSpec first;
    if (!m_parts->input || !m_parts->input->open(file, first))
        refuse(file, m_parts->input ? m_parts->input->geterror() : OIIO::geterror());
    std::vector<PartNames> names;
    for (int part = 0; m_parts->input->seek_subimage(part, 0); ++part) {
        m_parts->specs.push_back(m_parts->input->spec(part, 0));
        names.push_back(part_names(m_parts->specs.back()));
    }
    m_parts->input->geterror();  // running past the last part is how its end shows
    m_views = views_of(names);
    m_view = choose_view(file, m_views, view);
    m_layers = gather_layers(names, m_view);
}

ExrFile::~ExrFile() = default;

const Layer* ExrFile::find_layer(const std::string& layer) const {
    for (const Layer& candidate : m_layers)
        if (candidate.name == layer) return &candidate;
    return nullptr;
}

Window ExrFile::data_window(int part) const {
    const OIIO::ImageSpec& spec = m_parts->specs[part];
    return {spec.x, spec.y, spec.width, spec.height};
}

Window ExrFile::display_window() const {
    const OIIO::ImageSpec& spec = m_parts->specs[0];
    return {spec.full_x, spec.full_y, spec.full_width, spec.full_height};
}

bool ExrFile::has_views_in_one_part() const { return !m_views.empty() && m_parts->specs.size() == 1; }

std::string ExrFile::compression(int part) const { return m_parts->specs[part].get_string_attribute("compression"); }

int ExrFile::block_rows(int part) const { return rows_of_block(m_parts->specs[part]); }

std::shared_ptr<const Metadata> ExrFile::metadata(int part) const {
    return std::make_shared<Metadata>(Metadata{m_parts->specs[part]});
}

void ExrFile::read(const std::vector<ChannelRead>& reads, const Window& window) const {
    for (const auto& [part, runs] : runs_by_part(reads))
        read_part(*m_parts->input, m_name, part, m_parts->specs[part], runs, window);
}

}  // namespace burnish
