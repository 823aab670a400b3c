// One frame in memory, or a band of one: the one implementation behind files and arrays.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/job/look.h>
#include <burnish/output/report.h>
#include <burnish/shading/dense.h>

#include <map>
#include <set>

namespace burnish {

/// What a report counts; the bands of a frame add up.
struct Tally {
    ValidityCounts pixels{};
    std::vector<size_t> shaded, selected;  // pixels of each rule: shaded, and assigned to it
    double lookups = 0;
    size_t unlit = 0;  // shaded pixels that no light is assigned to
    bool lacks_tangents = false;
    NamedValues<double> seconds;
    std::vector<PlanReport> plan;
    std::vector<std::string> notes, warnings;  // of the frame's own lights

    void operator+=(const Tally& band);
};

struct FrameResult {
    Composite composite;
    ShadedFrame shaded;  // its overlay went into the composite
    Image validity;      // 1 channel: the number of each pixel's Validity; with diagnostics only, as shaded.samples
    Tally tally;
};

/// The roles a job reads when the frame has them.
std::set<Role> wanted_roles(const Job& job, const Wardrobe& wardrobe);
/// Roles it reads only where another is not found: what the diffuse part is made of for the beauty, UVs for tangents.
std::map<Role, std::set<Role>> substitute_roles(const Job& job, const Wardrobe& wardrobe);

/// A frame before it is shaded: its surfaces, and who wears what under which lights. The same for every way of shading one wardrobe
/// under one rig. The frames must outlive it.
class LitFrame {
public:
    /// As run_frame. Throws Error(missing_channel | size_mismatch).
    LitFrame(const Job& job, const AovFrame& frame, const AovFrame* fine, const Wardrobe& wardrobe, const Rig& rig,
             const Assignment* assignment);
    LitFrame(const LitFrame&) = delete;
    LitFrame& operator=(const LitFrame&) = delete;

    const Surfaces& surfaces() const { return m_surfaces; }
    /// By place in `looks`.
    const Assignment& assignment() const { return m_lit.assignment; }
    const std::vector<LitRule>& looks() const { return m_lit.looks; }

    /// Sparsely where there are predictors.
    ShadedFrame shade(const std::vector<MaterialShader>& shaders, const std::vector<BandwidthPredictor>& predictors,
                      const Progress& progress, bool with_samples) const;

    /// The result of a frame that was shaded. `old`: with the materials of before; null = they do not matter.
    FrameResult finish(const Job& job, ShadedFrame shaded, ShadedFrame* old) const;

private:
    const AovFrame& m_frame;
    const AovFrame* m_fine;
    const AovFrame& m_shown;
    std::vector<size_t> m_selected;  // pixels of each rule
    LitAssignment m_lit;
    Surfaces m_surfaces;
    std::vector<DiffuseReflectance> m_kd;  // of each look
};

/// Surfaces, shading and compositing of a frame or band. `fine`: where its surfaces are, at a multiple of its size, shaded there
/// and resolved to the frame's pixels; null = in the frame itself. `assignment`: who wears what; null = by the rules.
/// Throws Error(missing_channel | size_mismatch | color_space | cancelled).
FrameResult run_frame(const Job& job, const AovFrame& frame, const AovFrame* fine, const Look& look,
                      const Assignment* assignment, const Progress& progress);

/// The report on a frame whose bands add up to `tally`; `frame` and `fine`: any of them, the warnings of the last. Pixels are
/// counted by sample where there are finer AOVs.
FrameReport frame_report(const Job& job, const AovFrame& frame, const AovFrame* fine, const Look& look, const Tally& tally);

/// Assignment from one mask per rule (1 channel, coverage in [0, 1], 0 = not this material); later masks win.
/// Throws Error(size_mismatch).
Assignment assign_masks(const std::vector<Image>& masks);

}  // namespace burnish
