#include <burnish/job/band_source.h>

#include <burnish/job/frame_cover.h>
#include <burnish/job/read_frame.h>
#include <burnish/job/stages.h>

#include <algorithm>

namespace burnish {

std::shared_ptr<Band> BandSource::next() {
    if (m_task >= m_tasks.size()) return nullptr;
    auto band = std::make_shared<Band>();
    band->task = m_task;
    band->is_skipped = !m_reader && m_finished.has(m_tasks[m_task]);
    try {
        if (!band->is_skipped) timed(band->seconds, "reading", [&] { read(*band); });
        if (band->is_skipped || band->is_last) leave_frame();
    } catch (const Error& error) {
        if (error.code() == ErrorCode::cancelled) throw;
        band->failure = std::current_exception();
        leave_frame();
        if (!is_passed_over(m_job, error)) m_task = m_tasks.size();
    }
    return band;
}

void BandSource::read(Band& band) {
    const FrameTask& task = m_tasks[m_task];
    const float done = m_reader ? static_cast<float>(m_bands_read) / m_reader->band_count() : 0.0f;
    m_progress.report("reading", (m_task + done) / m_tasks.size());
    if (!m_reader) open(task);
    band.frame = m_reader->read_band();
    band.whole = m_reader->frame().data_window;
    band.is_last = ++m_bands_read == m_reader->band_count();
    if (m_fine) band.fine = read_fine(band);
}

/// Bands are as large as their samples allow.
void BandSource::open(const FrameTask& task) {
    const bool has_fine = !task.fine_aovs.empty();
    const auto options = [&](FramePart part) { return read_options(m_job, m_wardrobe, task.camera, part, task.view_in_file); };
    m_reader.emplace(task.aovs, options(has_fine ? FramePart::picture : FramePart::whole), m_band_pixels);
    if (!has_fine) return;
    m_fine.emplace(task.fine_aovs, options(FramePart::surfaces), m_band_pixels);
    const AovFrame &frame = m_reader->frame(), &fine = m_fine->frame();
    m_grid = sample_grid(frame, fine);
    check_samples(m_grid, frame, fine);
    const size_t row = static_cast<size_t>(std::max(m_grid.factor * fine.data_window.width, frame.data_window.width));
    m_reader->plan_bands(m_band_pixels / row * static_cast<size_t>(frame.data_window.width));
}

/// The samples of a band, and about them those that its filter reaches.
AovFrame BandSource::read_fine(const Band& band) {
    const Window &data = m_fine->frame().data_window, own = m_grid.samples_of(band.frame.data_window);
    const int begin = std::clamp(own.y - data.y, 0, data.height);
    const int end = std::clamp(own.y + own.height - data.y, begin, data.height);
    const int reach = filter_taps(pixel_filter(m_job.antialias, band.frame), m_grid.factor).reach;
    return m_fine->read_rows(begin, end, begin < end ? reach : std::max(reach, 1), band.is_last);
}

void BandSource::leave_frame() {
    m_reader.reset(), m_fine.reset();
    m_bands_read = 0;
    ++m_task;
}

}  // namespace burnish
