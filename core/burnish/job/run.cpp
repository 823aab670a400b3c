#include <burnish/job/run.h>

#include <burnish/job/run_reported.h>

#include <algorithm>

namespace burnish {

struct ShotRunner::Prepared {
    explicit Prepared(const Job& job) : color(job), wardrobe(prepare_wardrobe(job)) {}

    ColorFlow color;
    Wardrobe wardrobe;
    std::optional<Look> look;
};

ShotRunner::ShotRunner(Job job) : m_job(std::move(job)) {}
ShotRunner::~ShotRunner() = default;

Report ShotRunner::run(const std::string& frames, const Progress& progress) {
    m_job.frames = frames;
    return run(FlowSettings{}, progress);
}

Report ShotRunner::run(const FlowSettings& flow, const Progress& progress) {
    return run_reported(m_job, [&](Report& report) {
        const std::vector<FrameTask> tasks = frame_tasks(m_job);
        if (!m_prepared) m_prepared = std::make_unique<Prepared>(m_job);
        report.warnings = m_prepared->wardrobe.warnings;
        run_flow(m_job, flow, tasks, m_prepared->color, m_prepared->wardrobe, m_prepared->look, progress, report);
        progress.report("done", 1.0f);
    });
}

std::string_view version() { return BURNISH_VERSION; }

int exit_code(const Report& report) {
    constexpr int kPartial = 3;
    const auto told = [](const FrameReport& frame) { return !frame.error.empty(); };
    return std::any_of(report.frames.begin(), report.frames.end(), told) ? kPartial : 0;
}

Report run(const Job& job, const Progress& progress, const FlowSettings& flow) { return ShotRunner(job).run(flow, progress); }

}  // namespace burnish
