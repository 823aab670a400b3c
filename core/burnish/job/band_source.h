// Where bands come from: the files of a job, one after the other, each read from the top. Of a frame with finer AOVs two files
// are read side by side, each for what it knows: the picture here, the surfaces there.
#pragma once

#include <burnish/composite/sample_grid.h>
#include <burnish/input/frame_reader.h>
#include <burnish/job/band.h>
#include <burnish/job/finished_frames.h>

#include <memory>
#include <optional>

namespace burnish {

class BandSource {
public:
    /// All arguments must outlive the source. `progress`: of reading alone.
    BandSource(const Job& job, const Wardrobe& wardrobe, const std::vector<FrameTask>& tasks, size_t band_pixels,
               Progress progress)
        : m_job(job),
          m_wardrobe(wardrobe),
          m_tasks(tasks),
          m_finished(job, wardrobe),
          m_band_pixels(band_pixels),
          m_progress(std::move(progress)) {}

    /// The next band; null after the last, and after a failure that ends the run. Throws Error(cancelled); every other error
    /// is in the band.
    std::shared_ptr<Band> next();

private:
    void open(const FrameTask& task);
    void read(Band& band);
    AovFrame read_fine(const Band& band);
    void leave_frame();

    const Job& m_job;
    const Wardrobe& m_wardrobe;
    const std::vector<FrameTask>& m_tasks;
    FinishedFrames m_finished;
    size_t m_band_pixels;
    Progress m_progress;
    size_t m_task = 0;
    int m_bands_read = 0;
    std::optional<FrameReader> m_reader, m_fine;
    SampleGrid m_grid;
};

}  // namespace burnish
