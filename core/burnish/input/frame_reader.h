// An open frame: what its layers are and where its camera stands is settled once, then its pixels are read band by band, so
// that a frame of any size is never whole in memory.
#pragma once

#include <burnish/input/exr_file.h>
#include <burnish/input/exr_reader.h>
#include <burnish/input/fingerprint.h>
#include <burnish/input/row_strips.h>
#include <burnish/input/slots.h>

#include <optional>
#include <string>
#include <vector>

namespace burnish {

class FrameReader {
public:
    /// Opens the file and settles layers and camera as read_frame does; throws what it throws. Frames up to 1920 x 1080 are
    /// judged whole, larger ones by strips spread over them, and by more strips while these see no surface.
    /// `band_pixels`: how large a band may get, though it has one row at least; it ends where a block of the file's rows does,
    /// or after a power of two of them where blocks are larger.
    FrameReader(const std::string& file, const ReadOptions& options, size_t band_pixels);

    /// Everything but pixels: layers and the ranks of cryptomattes are empty. Notes are complete.
    const AovFrame& frame() const { return m_frame; }
    int band_count() const { return m_band_count; }
    /// Other bands than those of the constructor, before the first is read.
    void plan_bands(size_t band_pixels);
    /// The next band of rows, from the top. The last one tells all warnings. Throws Error(read_failed).
    AovFrame read_band();
    /// Rows [begin, end) of the data window, 0 its top, and as margins `shaded` rows more on either side, where there are any, to
    /// be shaded with them. With ReadOptions::shaded_block the margins make whole blocks of so many rows, counted from the top of
    /// the data window, and have one block more on either side and the row after it. Where UVs are read there is a row (block)
    /// more still: their differences need neighbours. `is_last`: of a frame read from the top; it tells all warnings.
    /// Throws Error(read_failed).
    AovFrame read_rows(int begin, int end, int shaded, bool is_last);

private:
    void judge(const ReadOptions& options);
    void judge_rows(const ReadOptions& options, const RowStrips& rows);
    void settle_geometry(const ReadOptions& options, const RowStrips& rows);
    void add_substitutes(const ReadOptions& options);
    bool sees_surface() const;
    bool has_slot(Role role) const;
    void read_pixels(AovFrame& band);

    ExrFile m_file;
    int m_shaded_block;
    Fingerprint m_print;
    std::vector<Slot> m_slots;  // once judged: what a band is made of, each with its front candidate
    AovFrame m_frame;
    bool m_is_read = false;              // the frame is its only band, and was judged whole: its layers are
    std::map<Role, Image> m_whole;       // kept here until they are asked for
    std::optional<bool> m_depth_is_ray;  // position is made from depth, which is the length of the ray or planar
    int m_band_rows = 0, m_band_count = 1, m_bands_read = 0;
};

}  // namespace burnish
