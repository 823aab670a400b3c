#include <burnish/job/flow.h>

#include <burnish/composite/sample_grid.h>
#include <burnish/job/band_source.h>
#include <burnish/job/build_lights.h>
#include <burnish/job/color_check.h>
#include <burnish/job/flow_progress.h>
#include <burnish/job/frame_sink.h>
#include <burnish/job/savings.h>
#include <burnish/job/stages.h>

#include <oneapi/tbb/parallel_pipeline.h>

#include <algorithm>
#include <iterator>

namespace burnish {
namespace {

/// The stage between source and sink. Lights and tables are made once, for the first frame, which tells which way is up; only lights
/// that are another picture for each frame are read again.
class BandShader {
public:
    BandShader(const Job& job, const ColorFlow& color, const Wardrobe& wardrobe, const std::vector<FrameTask>& tasks,
               Progress progress, std::optional<Look>& look, Report& report)
        : m_job(job),
          m_color(color),
          m_wardrobe(wardrobe),
          m_frames(tasks),
          m_tasks(static_cast<float>(tasks.size())),
          m_progress(std::move(progress)),
          m_report(report),
          m_look(look) {}

    /// Shades the band, unless its frame failed before. Throws Error(cancelled); every other error is in the band.
    void shade(Band& band) {
        if (m_task != band.task) m_task = band.task, m_has_failed = false;
        m_has_failed = m_has_failed || band.failure;
        if (m_has_failed || band.is_skipped) return;
        try {
            prepare(band);
            LightNotes told = load_own_lights(band);
            run(band);
            tell_of_lights(*m_look, m_report);
            band.result.tally.notes = std::move(told.notes), band.result.tally.warnings = std::move(told.warnings);
        } catch (const Error& error) {
            if (error.code() == ErrorCode::cancelled) throw;
            band.failure = std::current_exception();
            m_has_failed = true;
        }
    }

    const Look* look() const { return m_look ? &*m_look : nullptr; }

private:
    void prepare(Band& band) {
        if (m_look) return;
        band.is_run_over = true;
        Rig rig = timed(m_report.seconds, "light",
                        [&] { return build_rig(m_job, m_wardrobe.rules, m_color, nullptr, light_frame(band)); });
        m_look = prepare_look(m_job, m_wardrobe, std::move(rig), {samples_of(band), static_cast<int>(m_frames.size())});
        std::ranges::move(color_warnings(m_job, band.frame), std::back_inserter(m_look->wardrobe.warnings));
        band.is_run_over = false;
    }

    /// Of its whole frame.
    static size_t samples_of(const Band& band) {
        const size_t pixels = static_cast<size_t>(band.whole.width) * static_cast<size_t>(band.whole.height);
        return pixels * static_cast<size_t>(band.fine ? sample_grid(band.frame, *band.fine).sample_count() : 1);
    }

    /// The lights that are the frame's own, with its first band.
    LightNotes load_own_lights(Band& band) {
        if (m_lit_task == band.task || !has_frame_lights(m_look->rig)) return {};
        LightNotes told =
            timed(band.seconds, "light", [&] { return load_frame_lights(m_look->rig, m_color, light_frame(band)); });
        m_lit_task = band.task;
        return told;
    }

    LightFrame light_frame(const Band& band) const {
        const AovFrame& shown = band.fine ? *band.fine : band.frame;
        return {band.frame.renderer, shown.camera, m_frames[band.task].frame};
    }

    void run(Band& band) {
        const Window& rows = band.frame.data_window;
        const float height = static_cast<float>(band.whole.height), top = static_cast<float>(rows.y - band.whole.y);
        const float begin = (band.task + top / height) / m_tasks;
        const Progress part = part_of(m_progress, begin, begin + rows.height / height / m_tasks);
        band.result = run_frame(m_job, band.frame, band.fine ? &*band.fine : nullptr, *m_look, nullptr, part);
    }

    const Job& m_job;
    const ColorFlow& m_color;
    const Wardrobe& m_wardrobe;
    const std::vector<FrameTask>& m_frames;
    float m_tasks;
    Progress m_progress;
    Report& m_report;
    std::optional<size_t> m_task, m_lit_task;  // the frame at hand; the one whose own lights are loaded
    bool m_has_failed = false;
    std::optional<Look>& m_look;
};

}  // namespace

void run_flow(const Job& job, const FlowSettings& settings, const std::vector<FrameTask>& tasks, const ColorFlow& color,
              const Wardrobe& wardrobe, std::optional<Look>& look, const Progress& whole, Report& report) {
    using Item = std::shared_ptr<Band>;
    FlowProgress progress(whole);
    BandSource source(job, wardrobe, tasks, settings.band_pixels, progress.of(FlowStage::read));
    BandShader shader(job, color, wardrobe, tasks, progress.of(FlowStage::shade), look, report);
    FrameSink sink(job, color, tasks, progress.of(FlowStage::write), report);

    const auto read = [&](tbb::flow_control& control) {
        Item band = source.next();
        if (!band) control.stop();
        return band;
    };
    const auto shade = [&](const Item& band) { return shader.shade(*band), band; };
    const auto write = [&](const Item& band) {
        try {
            sink.take(*band, shader.look());
        } catch (...) {
            progress.stop(std::current_exception());
            throw;
        }
    };
    constexpr auto kInOrder = tbb::filter_mode::serial_in_order;
    try {
        tbb::parallel_pipeline(static_cast<size_t>(settings.bands_in_flight),
                               tbb::make_filter<void, Item>(kInOrder, read) & tbb::make_filter<Item, Item>(kInOrder, shade) &
                                   tbb::make_filter<Item, void>(kInOrder, write));
    } catch (...) {
        progress.rethrow();
        throw;
    }
}

}  // namespace burnish
