#include <burnish/job/run_bandwidth.h>

#include <burnish/base/parallel.h>
#include <burnish/job/band.h>
#include <burnish/job/bandwidth_layers.h>
#include <burnish/job/build_lights.h>
#include <burnish/job/color_flow.h>
#include <burnish/job/finished_frames.h>
#include <burnish/job/job_hash.h>
#include <burnish/job/read_frame.h>
#include <burnish/job/stages.h>
#include <burnish/output/exr_threads.h>
#include <burnish/output/exr_writer.h>
#include <burnish/output/preview.h>

#include <nlohmann/json.hpp>

#include <cstdio>

namespace burnish {
namespace {

/// What all frames share; light and tables are made with the first.
class BandwidthRun {
public:
    BandwidthRun(const Job& job, const ColorFlow& color)
        : m_job(job),
          m_color(color),
          m_wardrobe(prepare_wardrobe(job)),
          m_finished(job, m_wardrobe, kKind),
          m_hash(job_hash(job, kKind)) {
        m_job.density.density = ShadingDensity::sparse;  // predicts whatever is shaded densely
    }

    void run(const FrameTask& task, BandwidthReport& report, const Progress& progress) {
        report.frame = task.frame, report.input = task.aovs, report.output = task.output;
        report.is_skipped = m_finished.has(task);
        if (report.is_skipped) return;
        progress.report("reading", 0.0f);
        const bool has_fine = !task.fine_aovs.empty();
        const AovFrame frame = read_job_frame(m_job, m_wardrobe, has_fine ? task.fine_aovs : task.aovs, task.camera,
                                              has_fine ? FramePart::surfaces : FramePart::whole, task.view_in_file);
        prepare(frame, task.frame);
        NamedValues<double> seconds;
        const BandwidthLayers layers =
            timed(seconds, "predicting", [&] { return predict(frame, part_of(progress, 0.1f, 0.9f)); });
        report.seconds = seconds.front().second;
        report.width = layers.level.width, report.height = layers.level.height;
        count_levels(layers, report);
        progress.report("writing", 0.9f);
        write_bandwidth(task.output, frame, layers, m_job.output.pixel_type, {{kJobHashAttribute, m_hash}});
        if (!task.preview.empty()) write_code_values(task.preview, level_picture(layers));
    }

private:
    void prepare(const AovFrame& frame, std::optional<int> number) {
        const LightFrame of_light{frame.renderer, frame.camera, number};
        if (!m_look) {
            Rig rig = build_rig(m_job, m_wardrobe.rules, m_color, nullptr, of_light);
            m_look = prepare_look(m_job, m_wardrobe, std::move(rig), {});
            if (const Environment* environment = m_look->rig.environment())
                m_variances = prepare_variances(m_wardrobe.materials, *environment, m_job.density);
        }
        load_frame_lights(m_look->rig, m_color, of_light);
    }

    BandwidthLayers predict(const AovFrame& frame, const Progress& progress) const {
        const LitAssignment lit = assign_lights(frame, assign_rules(frame, m_wardrobe.rules), m_look->rig);
        NamedValues<double> seconds;
        load_needed(m_look->rig, lit.looks, seconds, progress);
        const Surfaces surfaces(frame, lit.assignment, m_job.surface);
        BandwidthLook look{equip(*m_look, lit.looks).predictors, {}};
        for (const LitRule& own : lit.looks)
            look.variances.push_back(m_look->rig.is_distant(own.chain) ? m_variances[own.rule] : nullptr);
        return bandwidth_layers(frame, lit.assignment, surfaces, look, m_job.estimator.kind, progress);
    }

    static void count_levels(const BandwidthLayers& layers, BandwidthReport& report) {
        for (size_t i = 0; i < layers.level.pixel_count(); ++i) {
            if (!(*layers.shaded.at(i) > 0)) continue;
            const auto level = static_cast<size_t>(*layers.level.at(i));
            report.levels.resize(std::max(report.levels.size(), level + 1));
            ++report.levels[level], ++report.pixels;
        }
    }

    static constexpr const char* kKind = "bandwidth";

    Job m_job;
    const ColorFlow& m_color;
    Wardrobe m_wardrobe;
    FinishedFrames m_finished;
    std::string m_hash;
    std::optional<Look> m_look;
    Variances m_variances;  // of each rule under the environment alone
};

}  // namespace

double BandwidthReport::grid_samples() const {
    double sum = 0, share = 1;
    for (const size_t count : levels) sum += static_cast<double>(count) * share, share /= 4;
    return sum;
}

std::vector<BandwidthReport> run_bandwidth(const Job& job, const Progress& progress) {
    const ThreadLimit limit(job.threads);
    const ExrThreads exr_threads(job.threads);
    const std::vector<FrameTask> tasks = frame_tasks(job);
    for (const FrameTask& task : tasks)
        if (task.views > 1)
            throw Error(ErrorCode::bad_argument,
                        "view: all views share '" + task.output + "'; put %V where the view's name goes");
    const ColorFlow color(job);
    BandwidthRun run(job, color);
    std::vector<BandwidthReport> reports(tasks.size());
    const auto count = static_cast<float>(tasks.size());
    for (size_t i = 0; i < tasks.size(); ++i) {
        const auto done = static_cast<float>(i);
        try {
            run.run(tasks[i], reports[i], part_of(progress, done / count, (done + 1) / count));
        } catch (const Error& error) {
            const std::string frame = tasks[i].frame ? "frame=" + std::to_string(*tasks[i].frame) + " " : "";
            if (error.code() == ErrorCode::cancelled) throw;
            if (!is_passed_over(job, error)) throw Error(error.code(), frame + error.what());
            reports[i].error = std::string(error_name(error.code())) + " " + error.what();
        }
    }
    if (!job.output.report.empty()) write_text(job.output.report, report_to_json(reports).dump(2) + "\n");
    progress.report("done", 1.0f);
    return reports;
}

std::string summary(const BandwidthReport& report) {
    char text[128];
    if (!report.error.empty()) return report.output + "  skipped: " + report.error;
    if (report.is_skipped) return report.output + "  skipped: it is there already";
    const double percent = 100.0 / static_cast<double>(std::max<size_t>(report.pixels, 1));
    std::snprintf(text, sizeof text, "  %dx%d  %.2f s  %zu pixels, of which grids take %.1f %%: level", report.width,
                  report.height, report.seconds, report.pixels, percent * report.grid_samples());
    std::string line = report.output + text, separator = " ";
    for (size_t level = 0; level < report.levels.size(); ++level) {
        if (report.levels[level] == 0) continue;
        std::snprintf(text, sizeof text, "%s%zu %.1f %%", separator.c_str(), level,
                      percent * static_cast<double>(report.levels[level]));
        line += text, separator = ", ";
    }
    return line;
}

nlohmann::json report_to_json(const std::vector<BandwidthReport>& reports) {
    nlohmann::json frames = nlohmann::json::array();
    for (const BandwidthReport& report : reports) {
        nlohmann::json& frame = frames.emplace_back(nlohmann::json{{"input", report.input},
                                                                   {"output", report.output},
                                                                   {"width", report.width},
                                                                   {"height", report.height},
                                                                   {"pixels", report.pixels},
                                                                   {"levels", report.levels},
                                                                   {"grid_samples", report.grid_samples()},
                                                                   {"seconds", report.seconds},
                                                                   {"skipped", report.is_skipped},
                                                                   {"error", report.error}});
        if (report.frame) frame["frame"] = *report.frame;
    }
    return {{"frames", frames}};
}

}  // namespace burnish
