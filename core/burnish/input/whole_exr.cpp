#include <burnish/input/whole_exr.h>

#include <burnish/base/error.h>
#include <burnish/input/exr_context.h>
#include <burnish/input/exr_header.h>

#include <filesystem>

namespace burnish {
namespace {

/// What of a file's chunks lies in the file.
class Chunks {
public:
    explicit Chunks(const std::string& file)
        : m_context(open_exr(file)), m_bytes(static_cast<uint64_t>(std::filesystem::file_size(file))) {}

    bool are_whole() const {
        int parts = 0;
        exr_get_count(m_context.get(), &parts);
        for (int part = 0; part < parts; ++part)
            if (!is_whole(part)) return false;
        return true;
    }

    std::string attribute(const std::string& name) const {
        int32_t length = 0;
        const char* text = nullptr;
        if (exr_attr_get_string(m_context.get(), 0, name.c_str(), &length, &text) != EXR_ERR_SUCCESS) return "";
        return {text, static_cast<size_t>(length)};
    }

private:
    bool is_whole(int part) const {
        exr_storage_t storage = EXR_STORAGE_LAST_TYPE;
        exr_get_storage(m_context.get(), part, &storage);
        return storage == EXR_STORAGE_TILED ? has_tiles(part) : has_rows(part);
    }

    bool lies_in_file(exr_result_t result, const exr_chunk_info_t& chunk) const {
        return result == EXR_ERR_SUCCESS && chunk.data_offset + chunk.packed_size <= m_bytes;
    }

    bool has_rows(int part) const {
        exr_attr_box2i_t window{};
        int32_t rows = 1;
        exr_get_data_window(m_context.get(), part, &window);
        exr_get_scanlines_per_chunk(m_context.get(), part, &rows);
        for (int64_t y = window.min.y; y <= window.max.y; y += rows) {
            exr_chunk_info_t chunk{};
            const auto result = exr_read_scanline_chunk_info(m_context.get(), part, static_cast<int>(y), &chunk);
            if (!lies_in_file(result, chunk)) return false;
        }
        return true;
    }

    bool has_tiles(int part) const {
        int32_t levels_x = 0, levels_y = 0;
        exr_get_tile_levels(m_context.get(), part, &levels_x, &levels_y);
        uint32_t tile_width = 0, tile_height = 0;
        exr_tile_level_mode_t mode = EXR_TILE_ONE_LEVEL;
        exr_tile_round_mode_t rounding = EXR_TILE_ROUND_DOWN;
        exr_get_tile_descriptor(m_context.get(), part, &tile_width, &tile_height, &mode, &rounding);
        for (int y = 0; y < levels_y; ++y)
            for (int x = 0; x < levels_x; ++x)
                if ((mode == EXR_TILE_RIPMAP_LEVELS || x == y) && !has_level(part, x, y)) return false;
        return levels_x > 0 && levels_y > 0;
    }

    bool has_level(int part, int level_x, int level_y) const {
        int32_t width = 0, height = 0, tile_width = 1, tile_height = 1;
        exr_get_level_sizes(m_context.get(), part, level_x, level_y, &width, &height);
        exr_get_tile_sizes(m_context.get(), part, level_x, level_y, &tile_width, &tile_height);
        for (int y = 0; y * tile_height < height; ++y)
            for (int x = 0; x * tile_width < width; ++x) {
                exr_chunk_info_t chunk{};
                const auto result = exr_read_tile_chunk_info(m_context.get(), part, x, y, level_x, level_y, &chunk);
                if (!lies_in_file(result, chunk)) return false;
            }
        return true;
    }

    ExrContext m_context;
    uint64_t m_bytes;
};

}  // namespace

bool is_whole_exr(const std::string& file, const std::string& name, std::string& attribute) {
    try {
        check_exr_header(file);
        const Chunks chunks(file);
        attribute = chunks.attribute(name);
        return chunks.are_whole();
    } catch (const Error&) {
        return false;
    }
}

}  // namespace burnish
