// What each material is shaded with in a run that has a target: planned in the first frame that shows it, checked in every frame.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/job/run_frame.h>
#include <burnish/output/report.h>
#include <burnish/plan/planner.h>

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace burnish {

/// Share of a frame's progress that its first shading takes.
inline constexpr float kFirstShading = 0.5f;

class LookPlan {
public:
    explicit LookPlan(const QualityTarget& target) : m_target(target) {}

    /// How to shade each look of the frame; plans those that no frame showed before. The look must outlive this.
    /// Throws Error(cancelled).
    std::vector<ShadingSettings> plan(const Look& look, const LitFrame& frame, const Progress& progress);
    /// Compares what was shaded so with the exact integral at some pixels. Whether a plan has changed, as it missed: then the frame
    /// is to be shaded again, once, in the second half of its progress. Throws Error(cancelled).
    bool correct(const Image& overlay);
    /// `correct` without consequences: for what was shaded again.
    void check(const Image& overlay);
    /// Settings of the frame at hand, after `correct` said so.
    std::vector<ShadingSettings> shading() const;
    /// On the frame at hand.
    std::vector<PlanReport> reports(const Look& look) const;

private:
    /// A look with its plan, which it may share with others that were planned in the same frame.
    struct Planned {
        std::shared_ptr<Planner> planner;
        size_t subject;
    };
    /// A look of the frame at hand.
    struct Shown {
        Planned planned;
        LitRule lit;
        Truth truth;
        Closeness found;
        bool is_corrected = false;
    };

    PlanSubject subject_of(const Look& look, const LitFrame& frame, size_t index, Truth truth) const;
    ShadingSettings settings_of(const Planned& planned) const;

    QualityTarget m_target;
    ShadingSettings m_shading;  // of the job
    Progress m_progress;        // of the frame at hand
    float m_done = 0;           // of it
    std::map<std::pair<size_t, RigChain>, Planned> m_planned;
    std::vector<Shown> m_frame;
};

}  // namespace burnish
