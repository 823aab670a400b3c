#include <burnish/job/frame_sink.h>

#include <burnish/job/stages.h>

namespace burnish {
namespace {

void name(const FrameTask& task, FrameReport& entry) {
    entry.frame = task.frame, entry.view = task.view, entry.input = task.aovs, entry.output = task.output;
}

}  // namespace

void FrameSink::take(Band& band, const Look* look) {
    if (m_task != band.task) begin_frame(band.task);
    if (band.is_skipped) m_report.frames.back().status = FrameStatus::skipped;
    if (band.is_skipped || !m_writer) return;
    try {
        if (band.failure) std::rethrow_exception(band.failure);
        write(band, *look);
    } catch (const Error& error) {
        m_writer.reset();
        if (band.is_run_over) throw;
        drop_frame(band, error);
    }
}

void FrameSink::begin_frame(size_t task) {
    m_task = task, m_rows = 0, m_tally = {};
    m_writer.emplace(m_job, m_color, m_tasks[task], m_output, m_hash);
    FrameReport& entry = m_report.frames.emplace_back();
    name(m_tasks[task], entry);
    entry.status = FrameStatus::failed;
}

void FrameSink::write(Band& band, const Look& look) {
    const float rows = static_cast<float>(band.whole.height);
    m_progress.report("writing", (band.task + m_rows / rows) / m_tasks.size());
    Tally tally = band.result.tally;
    tally.seconds.insert(tally.seconds.begin(), band.seconds.begin(), band.seconds.end());
    timed(tally.seconds, "writing", [&] {
        m_writer->append(band.whole, band.frame, band.result);
        if (band.is_last) m_writer->finish();
    });
    m_rows += band.frame.data_window.height - band.frame.margin_above - band.frame.margin_below;
    m_tally += tally;
    if (band.is_last) tell(band, look);
}

void FrameSink::tell(const Band& band, const Look& look) {
    FrameReport& entry = m_report.frames.back();
    entry = frame_report(m_job, band.frame, band.fine ? &*band.fine : nullptr, look, m_tally);
    entry.width = band.whole.width, entry.height = band.whole.height;
    name(m_tasks[band.task], entry);
}

/// A fault of the frame itself is told and passed over, or ends the run, as the job says.
void FrameSink::drop_frame(const Band& band, const Error& error) {
    FrameReport& failed = m_report.frames.back();
    failed.error = std::string(error_name(error.code())) + " " + error.what();
    for (FrameReport& entry : m_report.frames)  // views that share the output
        if (entry.status == FrameStatus::done && entry.output == failed.output)
            entry.status = FrameStatus::failed, entry.error = failed.error;
    if (is_passed_over(m_job, error)) return;
    const FrameTask& task = m_tasks[band.task];
    throw Error(error.code(), (task.frame ? "frame=" + std::to_string(*task.frame) + " " : "") + error.what());
}

}  // namespace burnish
