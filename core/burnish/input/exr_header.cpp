#include <burnish/base/error.h>
#include <burnish/input/exr_context.h>
#include <burnish/input/exr_header.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>

namespace burnish {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
    throw Error(ErrorCode::read_failed, file + ": " + why);
}

/// First complaint of OpenEXR's parser on this thread; the library gives it to a callback only.
thread_local std::string first_complaint;

void note_complaint(exr_const_context_t, exr_result_t, const char* message) {
    if (first_complaint.empty()) first_complaint = message;
}

/// Most bytes one byte of a chunk can decode to: exact for deflate (1032) and PIZ's run lengths, 64 coefficients per DWA byte.
double largest_expansion(exr_compression_t compression) {
    switch (compression) {
        case EXR_COMPRESSION_NONE: return 1;
        case EXR_COMPRESSION_RLE: return 64;
        case EXR_COMPRESSION_PIZ: return 512;
        case EXR_COMPRESSION_B44: return 32.0 / 14;
        case EXR_COMPRESSION_B44A: return 32.0 / 3;
        case EXR_COMPRESSION_PXR24: return 1032 * 4.0 / 3;
        case EXR_COMPRESSION_DWAA:
        case EXR_COMPRESSION_DWAB: return 1032 * 64;
        default: return 1032;
    }
}

double bytes_per_pixel(const std::string& file, const exr_attr_chlist_t& channels) {
    double bytes = 0;
    for (int c = 0; c < channels.num_channels; ++c) {
        const exr_attr_chlist_entry_t& channel = channels.entries[c];
        if (channel.x_sampling != 1 || channel.y_sampling != 1)
            refuse(file, "channel " + std::string(channel.name.str) +
                             " is subsampled (luminance/chroma); convert the file to RGB channels");
        bytes += channel.pixel_type == EXR_PIXEL_HALF ? 2 : 4;
    }
    return bytes;
}

void check_part(const std::string& file, exr_const_context_t context, int part, double file_bytes) {
    exr_storage_t storage = EXR_STORAGE_LAST_TYPE;
    exr_get_storage(context, part, &storage);
    if (storage == EXR_STORAGE_DEEP_SCANLINE || storage == EXR_STORAGE_DEEP_TILED)
        refuse(file,
               "is a deep file; flatten it first (for example: oiiotool in.exr --flatten -o out.exr), but only the beauty: "
               "positions, "
               "normals and ids of what lies behind one another must not be mixed, so render those flat");
    exr_attr_box2i_t window{};
    exr_compression_t compression = EXR_COMPRESSION_LAST_TYPE;
    const exr_attr_chlist_t* channels = nullptr;
    int32_t chunks = 0;
    if (exr_get_data_window(context, part, &window) != EXR_ERR_SUCCESS ||
        exr_get_compression(context, part, &compression) != EXR_ERR_SUCCESS || compression >= EXR_COMPRESSION_LAST_TYPE ||
        exr_get_channels(context, part, &channels) != EXR_ERR_SUCCESS ||
        exr_get_chunk_count(context, part, &chunks) != EXR_ERR_SUCCESS)
        refuse(file, "the header of part " + std::to_string(part) + " is damaged or of an unknown kind; write the file again");

    const long long width = 1LL + window.max.x - window.min.x, height = 1LL + window.max.y - window.min.y;
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    if (width > kLargestSide || height > kLargestSide || width * height > kMostPixels)
        refuse(file, "is " + size + " pixels, more than the " + std::to_string(kMostPixels) + " burnish takes");
    if (channels->num_channels > kMostChannels)
        refuse(file, "has " + std::to_string(channels->num_channels) + " channels in one part, more than the " +
                         std::to_string(kMostChannels) + " burnish takes");
    const double needed = static_cast<double>(width) * height * bytes_per_pixel(file, *channels);
    constexpr double kTableEntry = 8;  // bytes; every chunk has one
    if (needed > largest_expansion(compression) * file_bytes || chunks * kTableEntry > file_bytes)
        refuse(file, "claims " + size + " pixels, more than its " + std::to_string(static_cast<long long>(file_bytes)) +
                         " bytes can hold: it is truncated or damaged; write it again");
}

double size_of(const std::string& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) refuse(file, "there is no such file");
    if (!std::filesystem::is_regular_file(file, error)) refuse(file, "is not a file");
    const auto bytes = std::filesystem::file_size(file, error);
    if (error) refuse(file, "cannot be read (" + error.message() + ")");
    return static_cast<double>(bytes);
}

bool has_exr_magic(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) refuse(file, "cannot be opened; check its permissions");
    std::array<char, 4> start{};
    stream.read(start.data(), start.size());
    return stream && start == std::array<char, 4>{0x76, 0x2f, 0x31, 0x01};
}

}  // namespace

ExrContext open_exr(const std::string& file) {
    exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
    settings.error_handler_fn = note_complaint;
    settings.max_image_width = settings.max_image_height = kLargestSide;
    settings.max_tile_width = settings.max_tile_height = kLargestSide;
    first_complaint.clear();
    exr_context_t context = nullptr;
    const exr_result_t result = exr_start_read(&context, file.c_str(), &settings);
    if (result != EXR_ERR_SUCCESS) {
        const std::string reason = first_complaint.empty() ? exr_get_default_error_message(result) : first_complaint;
        refuse(file, "the OpenEXR header is damaged or out of bounds (" + reason + "); write the file again");
    }
    return ExrContext(context);
}

void check_exr_header(const std::string& file) {
    const double bytes = size_of(file);
    if (!has_exr_magic(file)) refuse(file, "is not an OpenEXR file; frames are read from .exr");
    const ExrContext header = open_exr(file);
    int parts = 0;
    exr_get_count(header.get(), &parts);
    for (int part = 0; part < parts; ++part) check_part(file, header.get(), part, bytes);
}

}  // namespace burnish
