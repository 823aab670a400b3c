#include <burnish/job/run.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/job/color_flow.h>
#include <burnish/job/frame_tasks.h>
#include <burnish/job/read_frame.h>
#include <burnish/job/run_frame.h>
#include <burnish/job/shot_file.h>
#include <burnish/job/stages.h>
#include <burnish/job/write_frame.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace burnish {
namespace {

constexpr float kRead = 0.1f, kShaded = 0.9f;  // progress within a frame

bool is_frames_fault(const Error& error) {
    return error.code() == ErrorCode::read_failed || error.code() == ErrorCode::missing_channel ||
           error.code() == ErrorCode::size_mismatch;
}

/// Output of an earlier run that its inputs have not outdated.
bool is_up_to_date(const FrameTask& task) {
    std::error_code none;
    const auto written = std::filesystem::last_write_time(task.output, none);
    return !none && written > std::filesystem::last_write_time(task.aovs, none) && !none;
}

class Runner {
public:
    Runner(const Job& job, Report& report, const Progress& progress)
        : m_job(job),
          m_report(report),
          m_progress(progress),
          m_tasks(frame_tasks(job)),
          m_color(job),
          m_wardrobe(prepare_wardrobe(job)) {
        report.warnings = m_wardrobe.warnings;
    }

    void run() {
        for (size_t i = 0; i < m_tasks.size(); ++i) {
            const float count = static_cast<float>(m_tasks.size()), begin = static_cast<float>(i) / count;
            run_one(m_tasks[i], part_of(m_progress, begin, begin + 1 / count));
        }
        m_progress.report("done", 1.0f);
    }

private:
    void run_one(const FrameTask& task, const Progress& progress) {
        FrameReport& entry = m_report.frames.emplace_back();
        name(task, entry);
        entry.status = FrameStatus::failed;
        if (m_job.output.skip_existing && is_up_to_date(task))
            entry.status = FrameStatus::skipped;
        else
            produce(task, entry, progress);
    }

    void produce(const FrameTask& task, FrameReport& entry, const Progress& progress) {
        AovFrame frame;
        NamedValues<double> seconds;
        progress.report("reading", 0.0f);
        const auto read = [&] { frame = read_job_frame(m_job, m_wardrobe, task.aovs, task.camera); };
        if (!attempt(task, entry, [&] { timed(seconds, "reading", read); })) return;
        prepare(frame.renderer);
        attempt(task, entry, [&] {
            FrameResult result = run_frame(m_job, frame, *m_look, nullptr, part_of(progress, kRead, kShaded));
            progress.report("writing", kShaded);
            timed(seconds, "writing", [&] { write_frame(m_job, m_color, task, frame, result); });
            entry = std::move(result.report);
            entry.seconds.insert(entry.seconds.begin(), seconds.front());
            entry.seconds.push_back(seconds.back());
            name(task, entry);
        });
    }

    /// Does `work`; a fault of the frame itself is told and passed over, or ends the run, as the job says.
    template <class Work>
    bool attempt(const FrameTask& task, FrameReport& entry, Work&& work) {
        try {
            work();
            return true;
        } catch (const Error& error) {
            entry.error = std::string(error_name(error.code())) + " " + error.what();
            if (m_job.bad_frames == BadFrames::skip && is_frames_fault(error)) return false;
            throw Error(error.code(), (task.frame ? "frame=" + std::to_string(*task.frame) + " " : "") + error.what());
        }
    }

    static void name(const FrameTask& task, FrameReport& entry) {
        entry.frame = task.frame, entry.input = task.aovs, entry.output = task.output;
    }

    /// Light and tables, once; the first frame tells which way is up.
    void prepare(Renderer renderer) {
        if (m_look) return;
        auto light = timed(m_report.seconds, "light", [&] { return load_light(m_job, m_color, renderer); });
        m_report.notes = light->notes();
        m_report.warnings.insert(m_report.warnings.end(), light->warnings().begin(), light->warnings().end());
        m_look = timed(m_report.seconds, "tables", [&] { return prepare_look(m_job, m_wardrobe, std::move(light)); });
    }

    const Job& m_job;
    Report& m_report;
    const Progress& m_progress;
    std::vector<FrameTask> m_tasks;
    ColorFlow m_color;
    Wardrobe m_wardrobe;
    std::optional<Look> m_look;
};

void write_report(const Job& job, const Report& report) {
    if (!job.output.report.empty()) write_text(job.output.report, report_to_json(report).dump(2) + "\n");
}

/// What made the run fail is the error to tell, not a report that could not be written either.
void write_report_of_failure(const Job& job, const Report& report) {
    try {
        write_report(job, report);
    } catch (const Error&) {
    }
}

}  // namespace

std::string_view version() { return BURNISH_VERSION; }

int exit_code(const Report& report) {
    constexpr int kPartial = 3;
    const auto told = [](const FrameReport& frame) { return !frame.error.empty(); };
    return std::any_of(report.frames.begin(), report.frames.end(), told) ? kPartial : 0;
}

Report run(const Job& job, const Progress& progress) {
    const ThreadLimit limit(job.threads);
    Report report;
    report.version = version();
    report.job = job_to_json(job).dump();
    try {
        timed(report.seconds, "total", [&] { Runner(job, report, progress).run(); });
    } catch (const Error& error) {
        if (error.code() != ErrorCode::cancelled) write_report_of_failure(job, report);
        throw;
    }
    write_report(job, report);
    return report;
}

}  // namespace burnish
