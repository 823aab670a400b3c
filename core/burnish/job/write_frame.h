// A finished frame to its files, band by band: EXR layers and preview.
#pragma once

#include <burnish/job/color_flow.h>
#include <burnish/job/frame_tasks.h>
#include <burnish/job/joined_output.h>
#include <burnish/job/run_frame.h>
#include <burnish/output/exr_writer.h>
#include <burnish/output/preview.h>

#include <optional>

namespace burnish {

class FrameWriter {
public:
    /// The files are made with the first band and are there when finished, else never; of several views with the last. `hash`: of the
    /// job (job_hash.h) that the pixels are the result of, "" = of none. All references must outlive the writer.
    FrameWriter(const Job& job, const ColorFlow& color, const FrameTask& task, JoinedOutput& output, std::string hash = {})
        : m_job(job), m_color(color), m_task(task), m_output(output), m_hash(std::move(hash)) {}

    /// Appends a band. Layers: R G B A, burnish_spec (the overlay as added), burnish_diffuse where the frame had no beauty; with
    /// diagnostics also burnish_validity, burnish_samples and burnish_error. Colours go to the job's output space; `result` is
    /// used up. `whole`: the frame's data window. Throws Error(write_failed | color_space).
    void append(const Window& whole, const AovFrame& band, FrameResult& result);
    /// Throws Error(read_failed | write_failed).
    void finish();

private:
    void open(const Window& whole, const AovFrame& band, const std::vector<OutputLayer>& layers);

    const Job& m_job;
    const ColorFlow& m_color;
    const FrameTask& m_task;
    JoinedOutput& m_output;
    std::string m_hash;
    std::optional<ExrWriter> m_exr;
    std::optional<PreviewWriter> m_preview;
};

}  // namespace burnish
