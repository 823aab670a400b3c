// A frame while someone looks at it: the first picture at once, then pictures that come nearer to the exact one, step by step.
//
//     first look      few lookups of a fixed pattern everywhere: nothing has to be fitted or predicted
//     as set          the job's own estimator and density
//     dense           many lookups at every pixel
//     reference       the unfiltered light, twice as many lookups each step, mixed with the dense picture by their errors (blend.h)
//
// Surfaces, assignment and lights are made once; the reference goes on where it stopped.
#pragma once

#include <burnish/job/run_frame.h>
#include <burnish/shading/reference_run.h>

#include <optional>
#include <string>
#include <vector>

namespace burnish {

struct RefinedFrame {
    int step = 0;
    std::string label;      // "first look", "as set", "dense, 256 lookups", "reference, 512 lookups"
    bool is_final = false;  // every pixel meets the reference's tolerance, or has as many lookups as it may
    FrameResult result;
};

class Refinement {
public:
    /// Arguments as of run_frame; the frames must outlive the refinement. Throws Error(missing_channel |
    /// size_mismatch), and Error(bad_argument) for a job with a target.
    Refinement(const Job& job, const AovFrame& frame, const AovFrame* fine, Wardrobe wardrobe, Rig rig,
               const Assignment* assignment);

    /// The next picture. Same bits for any thread count. Throws Error(cancelled); the step may then be asked for again.
    RefinedFrame next(const Progress& progress);

    bool is_done() const { return m_is_done; }
    const Look& look() const { return m_look; }

private:
    /// How a picture of filtered lookups is made.
    struct Filtered {
        std::string label;
        EstimatorSettings estimator;
        DensitySettings density;
    };
    /// With the new materials, and with the old ones where the mode is `difference`.
    struct Pictures {
        ShadedFrame shaded, old;
    };
    struct References {
        ReferenceRun shaded;
        std::optional<ReferenceRun> old;
    };

    static std::vector<Filtered> filtered_steps(const Job& job, const DensitySettings& density);
    bool is_difference() const { return !m_look.wardrobe.old_materials.empty(); }
    /// With every look shaded so.
    Equipment equipped(const EstimatorSettings& estimator, const DensitySettings& density) const;
    void shade_filtered(const Filtered& settings, const Progress& progress, NamedValues<double>& seconds);
    Pictures shade_references(int lookups, const Progress& progress, NamedValues<double>& seconds);

    Job m_job;
    Look m_look;
    LitFrame m_lit;
    std::vector<Filtered> m_filtered_steps;
    int m_step = 0;
    bool m_is_done = false;
    Pictures m_filtered;  // the latest
    std::optional<References> m_references;
};

}  // namespace burnish
