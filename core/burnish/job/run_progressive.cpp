#include <burnish/job/run_progressive.h>

#include <burnish/base/error.h>
#include <burnish/composite/sample_grid.h>
#include <burnish/job/build_lights.h>
#include <burnish/job/color_check.h>
#include <burnish/job/frame_tasks.h>
#include <burnish/job/read_frame.h>
#include <burnish/job/refinement.h>
#include <burnish/job/run_reported.h>
#include <burnish/job/savings.h>
#include <burnish/job/stages.h>
#include <burnish/job/write_frame.h>

#include <algorithm>
#include <iterator>

namespace burnish {
namespace {

FrameTask only_task(const Job& job) {
    std::vector<FrameTask> tasks = frame_tasks(job);
    if (tasks.size() == 1) return std::move(tasks.front());
    throw Error(ErrorCode::bad_argument, "progressive: expected one frame, found " + std::to_string(tasks.size()) +
                                             "; choose one with --frames N or --view NAME, or leave --progressive out");
}

/// What is read before the first picture.
struct Shot {
    AovFrame frame;
    std::optional<AovFrame> fine;

    Shot(const Job& job, const FrameTask& task, const Wardrobe& wardrobe) {
        const bool has_fine = !task.fine_aovs.empty();
        frame = read_job_frame(job, wardrobe, task.aovs, task.camera, has_fine ? FramePart::picture : FramePart::whole,
                               task.view_in_file);
        if (!has_fine) return;
        fine = read_job_frame(job, wardrobe, task.fine_aovs, task.camera, FramePart::surfaces, task.view_in_file);
        check_samples(sample_grid(frame, *fine), frame, *fine);
    }

    const AovFrame* samples() const { return fine ? &*fine : nullptr; }
    LightFrame light_frame(const FrameTask& task) const { return {frame.renderer, (fine ? *fine : frame).camera, task.frame}; }
};

Rig rig_of(const Job& job, const Wardrobe& wardrobe, const ColorFlow& color, const LightFrame& frame, Report& report) {
    return timed(report.seconds, "light", [&] {
        Rig rig = build_rig(job, wardrobe.rules, color, nullptr, frame);
        load_frame_lights(rig, color, frame);
        return rig;
    });
}

class Watched {
public:
    Watched(const Job& job, const ColorFlow& color, const FrameTask& task, Report& report)
        : m_job(job), m_color(color), m_task(task), m_report(report) {}

    /// Writes the step's files and reports on the frame as it is now.
    StepReport take(const Shot& shot, const Look& look, RefinedFrame refined, double seconds, double since_start) {
        FrameReport entry = frame_report(m_job, shot.frame, shot.samples(), look, refined.result.tally);
        entry.frame = m_task.frame, entry.input = m_task.aovs, entry.output = m_task.output;
        timed(entry.seconds, "writing", [&] {
            JoinedOutput output(m_job);
            FrameWriter writer(m_job, m_color, m_task, output);
            writer.append(shot.frame.data_window, shot.frame, refined.result);
            writer.finish();
        });
        const StepReport step{refined.step, refined.label, refined.is_final, refined.result.tally.lookups,
                              seconds,      since_start};
        m_steps.push_back(step);
        entry.steps = m_steps;
        m_report.frames = {std::move(entry)};
        tell_of_lights(look, m_report);
        return step;
    }

private:
    const Job& m_job;
    const ColorFlow& m_color;
    const FrameTask& m_task;
    Report& m_report;
    std::vector<StepReport> m_steps;
};

void run_steps(const Job& job, const Progress& progress, const std::function<void(const StepReport&)>& told, Report& report) {
    const auto begin = std::chrono::steady_clock::now();
    const auto since = [](std::chrono::steady_clock::time_point then) {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
    };
    const FrameTask task = only_task(job);
    const ColorFlow color(job);
    Wardrobe wardrobe = prepare_wardrobe(job);
    report.warnings = wardrobe.warnings;
    const Shot shot = timed(report.seconds, "reading", [&] { return Shot(job, task, wardrobe); });
    std::ranges::move(color_warnings(job, shot.frame), std::back_inserter(wardrobe.warnings));
    Rig rig = rig_of(job, wardrobe, color, shot.light_frame(task), report);
    Refinement refinement(job, shot.frame, shot.samples(), std::move(wardrobe), std::move(rig), nullptr);
    Watched watched(job, color, task, report);
    while (!refinement.is_done()) {
        const auto step_begin = std::chrono::steady_clock::now();
        RefinedFrame refined = refinement.next(progress);
        told(watched.take(shot, refinement.look(), std::move(refined), since(step_begin), since(begin)));
        progress.report("done", refinement.is_done() ? 1.0f : 0.0f);
    }
}

}  // namespace

Report run_progressive(const Job& job, const Progress& progress, const std::function<void(const StepReport&)>& told) {
    return run_reported(job, [&](Report& report) {
        try {
            run_steps(job, progress, told, report);
        } catch (const Error& error) {
            if (error.code() != ErrorCode::cancelled || report.frames.empty()) throw;
            report.notes.push_back("stopped while refining: the files hold step " +
                                   std::to_string(report.frames.front().steps.back().step));
        }
    });
}

}  // namespace burnish
