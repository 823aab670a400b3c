#include <burnish/job/band_source.h>

#include <burnish/job/read_frame.h>
#include <burnish/job/stages.h>

namespace burnish {
std::shared_ptr<Band> BandSource::next() {
    if (m_task >= m_tasks.size()) return nullptr;
    auto band = std::make_shared<Band>();
    band->task = m_task;
    band->is_skipped = !m_reader && m_job.output.skip_existing && is_up_to_date(m_tasks[m_task]);
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
    if (!m_reader) m_reader.emplace(task.aovs, read_options(m_job, m_wardrobe, task.camera), m_band_pixels);
    band.frame = m_reader->read_band();
    band.whole = m_reader->frame().data_window;
    band.is_last = ++m_bands_read == m_reader->band_count();
}

void BandSource::leave_frame() {
    m_reader.reset();
    m_bands_read = 0;
    ++m_task;
}

}  // namespace burnish
