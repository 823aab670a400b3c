#include <burnish/job/run_frame.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/composite/sample_grid.h>
#include <burnish/job/build_lights.h>
#include <burnish/job/frame_cover.h>
#include <burnish/job/look_plan.h>
#include <burnish/job/savings.h>
#include <burnish/job/stages.h>
#include <burnish/shading/sparse.h>

#include <algorithm>
#include <functional>
#include <numeric>

namespace burnish {
namespace {

/// Which axis brushing runs around, when an anisotropic material meets a frame without tangents.
void warn_of_tangents(const Look& look, const Vec3f& a, FrameReport& report) {
    for (const Material& material : look.wardrobe.materials) {
        if (std::none_of(material.lobes.begin(), material.lobes.end(), std::mem_fn(&LobeParameters::is_anisotropic))) continue;
        char axis[96];
        std::snprintf(axis, sizeof axis, "%g,%g,%g", a.x, a.y, a.z);
        report.warnings.push_back("no tangent layer: anisotropic lobes of '" + material.name + "' run around the axis " + axis +
                                  " (--tangent-axis)");
    }
}

void report_pixels(const Tally& tally, const Look& look, FrameReport& report) {
    for (int i = 0; i < kValidityCount; ++i)
        report.pixels.emplace_back(validity_name(static_cast<Validity>(i)), tally.pixels[static_cast<size_t>(i)]);
    for (size_t rule = 0; rule < look.wardrobe.rules.size(); ++rule) {
        const AssignRule& r = look.wardrobe.rules[rule];
        report.materials.emplace_back(r.material, tally.shaded[rule]);
        const bool selects = r.object_index || r.material_index || !r.cryptomatte.empty();
        if (selects && tally.selected[rule] == 0)
            report.warnings.push_back("the rule for material '" + r.material + "' finds no pixel of its own");
    }
    const size_t broken = tally.pixels[static_cast<size_t>(Validity::not_finite)];
    if (broken > 0)
        report.warnings.push_back(std::to_string(broken) + " pixels hold NaN or infinity in P or N and are left as they were");
    if (tally.unlit > 0)
        report.warnings.push_back(std::to_string(tally.unlit) +
                                  " pixels have no light: no mirror or pane is on their plane, and there is no other light; "
                                  "add an environment or a cube map");
    if (tally.pixels[0] == 0) report.warnings.push_back("no pixel was shaded: see the counts under pixels");
}

/// What was found in the finer AOVs, and how they became pixels.
void report_fine(const Job& job, const AovFrame& frame, const AovFrame& fine, FrameReport& report) {
    const PixelFilter filter = pixel_filter(job.antialias, frame);
    char line[96];
    std::snprintf(line, sizeof line, "%d samples a pixel, which counts speak of; filter %s, %g pixels wide",
                  sample_grid(frame, fine).sample_count(), std::string(filter_name(filter.kind)).c_str(), filter.width);
    report.notes.push_back("fine_aovs: " + fine.label() + ": " + line);
    for (const std::string& note : fine.notes) report.notes.push_back("fine_aovs: " + note);
    report.warnings.insert(report.warnings.end(), fine.warnings.begin(), fine.warnings.end());
}

void add(const std::vector<size_t>& counts, std::vector<size_t>& sums) {
    sums.resize(counts.size());
    for (size_t i = 0; i < counts.size(); ++i) sums[i] += counts[i];
}

/// Lookups of the frame's own rows: those of its margins are another band's.
double own_lookups(const AovFrame& frame, const ShadedFrame& shaded) {
    if (!frame.has_shaded_margins()) return shaded.lookups;
    double lookups = 0;
    for (int y = frame.margin_above; y < shaded.samples.height - frame.margin_below; ++y)
        lookups = std::accumulate(shaded.samples.at(0, y), shaded.samples.at(0, y) + shaded.samples.width, lookups);
    return lookups;
}

/// `selected`: pixels of each rule.
Tally tally_of(const Surfaces& surfaces, const std::vector<LitRule>& looks, std::vector<size_t> selected) {
    Tally tally;
    tally.pixels = surfaces.counts(), tally.shaded.resize(selected.size()), tally.selected = std::move(selected);
    for (size_t i = 0; i < looks.size(); ++i) {
        tally.shaded[looks[i].rule] += surfaces.rule_counts()[i];
        if (looks[i].chain.empty()) tally.unlit += surfaces.rule_counts()[i];
    }
    tally.lacks_tangents = surfaces.tangent_source() == TangentSource::axis;
    return tally;
}

Image validity_image(const Surfaces& surfaces, int width, int height) {
    Image image = Image::unset(width, height, 1);
    for_each_index(height, [&](int y) {
        const size_t begin = static_cast<size_t>(y) * width;
        for (size_t i = begin; i < begin + width; ++i) image.data[i] = static_cast<float>(surfaces.validity(i));
    });
    return image;
}

/// Of each look.
std::vector<DiffuseReflectance> kd_of(const Wardrobe& wardrobe, const std::vector<LitRule>& looks) {
    std::vector<DiffuseReflectance> kd;
    for (const LitRule& look : looks) kd.push_back(wardrobe.kd[look.rule]);
    return kd;
}

void check_size(const Assignment& given, const Window& window) {
    if (given.width == window.width && given.height == window.height) return;
    throw Error(ErrorCode::size_mismatch, "assign: the masks are " + std::to_string(given.width) + "x" +
                                              std::to_string(given.height) + ", the frame is " + std::to_string(window.width) +
                                              "x" + std::to_string(window.height));
}

/// Who wears what: as given, or by the rules.
Assignment assignment_of(const AovFrame& frame, const Wardrobe& wardrobe, const Assignment* given) {
    if (!given) return assign_rules(frame, wardrobe.rules);
    check_size(*given, frame.data_window);
    return *given;
}

LitAssignment lit_assignment(const AovFrame& frame, const Wardrobe& wardrobe, const Rig& rig, const Assignment* given,
                             std::vector<size_t>& selected) {
    Assignment by_rule = assignment_of(frame, wardrobe, given);
    selected = by_rule.counts;
    return assign_lights(frame, std::move(by_rule), rig);
}

}  // namespace

void Tally::operator+=(const Tally& band) {
    for (size_t i = 0; i < pixels.size(); ++i) pixels[i] += band.pixels[i];
    add(band.shaded, shaded), add(band.selected, selected);
    lookups += band.lookups, unlit += band.unlit;
    plan.insert(plan.end(), band.plan.begin(), band.plan.end());
    notes.insert(notes.end(), band.notes.begin(), band.notes.end());
    warnings.insert(warnings.end(), band.warnings.begin(), band.warnings.end());
    lacks_tangents = band.lacks_tangents;
    for (const auto& [stage, elapsed] : band.seconds) add_seconds(seconds, stage, elapsed);
}

LitFrame::LitFrame(const Job& job, const AovFrame& frame, const AovFrame* fine, const Wardrobe& wardrobe, const Rig& rig,
                   const Assignment* given)
    : m_frame(frame),
      m_fine(fine),
      m_shown(fine ? *fine : frame),
      m_lit(lit_assignment(m_shown, wardrobe, rig, given, m_selected)),
      m_surfaces(m_shown, m_lit.assignment, job.surface),
      m_kd(kd_of(wardrobe, m_lit.looks)) {}

ShadedFrame LitFrame::shade(const std::vector<MaterialShader>& shaders, const std::vector<BandwidthPredictor>& predictors,
                            const Progress& progress, bool with_samples) const {
    const bool all_samples = with_samples || m_shown.has_shaded_margins();
    if (predictors.empty()) return shade_dense(m_surfaces, m_lit.assignment, shaders, progress, all_samples);
    return shade_sparse(m_shown, m_surfaces, m_lit.assignment, shaders, predictors, progress, all_samples);
}

FrameResult LitFrame::finish(const Job& job, ShadedFrame shaded, ShadedFrame* old) const {
    FrameResult result;
    result.shaded = std::move(shaded);
    result.tally = tally_of(m_surfaces, m_lit.looks, m_selected);
    result.tally.lookups = own_lookups(m_shown, result.shaded) + (old ? own_lookups(m_shown, *old) : 0);
    if (job.output.diagnostics) result.validity = validity_image(m_surfaces, assignment().width, assignment().height);
    ShadedFrame none;
    NamedValues<double>& seconds = result.tally.seconds;
    const Cover cover = timed(seconds, m_fine ? "antialiasing" : "composite", [&] {
        Assignment covered = m_lit.assignment;
        if (m_fine || job.composite.mode == CompositeMode::replace) cover_shaded(m_surfaces, covered);
        if (!m_fine) return pixel_cover(m_frame, m_surfaces, covered, m_kd);
        return resolve_samples(job.antialias, m_frame, *m_fine, m_surfaces, covered, m_kd, result, old ? *old : none);
    });
    result.composite = timed(seconds, "composite", [&] {
        return composite(m_frame, cover, std::move(result.shaded.overlay), old ? &old->overlay : nullptr, job.composite);
    });
    return result;
}

FrameResult run_frame(const Job& job, const AovFrame& frame, const AovFrame* fine, const Look& look, const Assignment* given,
                      const Progress& progress) {
    NamedValues<double> seconds;
    const bool difference = !look.wardrobe.old_materials.empty();
    std::optional<LitFrame> lit;
    timed(seconds, "surface", [&] { lit.emplace(job, frame, fine, look.wardrobe, look.rig, given); });
    load_needed(look.rig, lit->looks(), seconds, progress);
    std::vector<ShadingSettings> settings;
    if (look.plan) settings = timed(seconds, "planning", [&] { return look.plan->plan(look, *lit, progress); });
    ShadedFrame shaded, old;
    const auto shade = [&](const Progress& part) {
        const Equipment equipment = timed(seconds, "tables", [&] { return equip(look, lit->looks(), settings); });
        timed(seconds, "shading", [&] {
            shaded = lit->shade(equipment.shaders, equipment.predictors, part_of(part, 0.0f, difference ? 0.5f : 1.0f),
                                job.output.diagnostics);
            if (difference) old = lit->shade(equipment.old_shaders, equipment.old_predictors, part_of(part, 0.5f, 1.0f), false);
        });
    };
    shade(look.plan ? part_of(progress, 0.0f, kFirstShading) : progress);
    if (look.plan && timed(seconds, "checking", [&] { return look.plan->correct(shaded.overlay); })) {
        settings = look.plan->shading();
        shade(part_of(progress, kFirstShading, 1.0f));
        timed(seconds, "checking", [&] { look.plan->check(shaded.overlay); });
    }
    FrameResult result = lit->finish(job, std::move(shaded), difference ? &old : nullptr);
    NamedValues<double>& told = result.tally.seconds;
    told.insert(told.begin(), seconds.begin(), seconds.end());
    if (look.plan) result.tally.plan = look.plan->reports(look);
    return result;
}

FrameReport frame_report(const Job& job, const AovFrame& frame, const AovFrame* fine, const Look& look, const Tally& tally) {
    FrameReport report;
    const AovFrame& shown = fine ? *fine : frame;
    report.input = frame.file;
    report.width = frame.data_window.width, report.height = frame.data_window.height;
    report.notes = frame.notes;
    report.warnings = frame.warnings;
    for (const RoleInfo& info : roles())
        if (frame.has(info.role) || shown.has(info.role)) report.roles.emplace_back(info.name);
    if (shown.camera) report.camera = shown.camera->source;
    if (fine) report_fine(job, frame, *fine, report);
    report_pixels(tally, look, report);
    report.notes.insert(report.notes.end(), tally.notes.begin(), tally.notes.end());
    report.warnings.insert(report.warnings.end(), tally.warnings.begin(), tally.warnings.end());
    if (tally.lacks_tangents) warn_of_tangents(look, job.surface.tangent_axis, report);
    report.saved = saved_reading(shown);
    report.lookups = tally.lookups;
    report.seconds = tally.seconds;
    report.plan = tally.plan;
    for (const PlanReport& plan : tally.plan)
        if (plan.is_missed) report.warnings.push_back("the target is missed: " + summary(plan));
    return report;
}

Assignment assign_masks(const std::vector<Image>& masks) {
    Assignment assignment;
    assignment.width = masks.front().width, assignment.height = masks.front().height;
    const size_t pixels = masks.front().pixel_count();
    assignment.rule.assign(pixels, -1), assignment.coverage.assign(pixels, 0.0f), assignment.counts.assign(masks.size(), 0);
    for (size_t rule = 0; rule < masks.size(); ++rule) {
        if (masks[rule].width != assignment.width || masks[rule].height != assignment.height)
            throw Error(ErrorCode::size_mismatch, "assign: the masks differ in size");
        for (size_t i = 0; i < pixels; ++i) {
            const float coverage = *masks[rule].at(i);
            if (coverage > 0)
                assignment.rule[i] = static_cast<int16_t>(rule), assignment.coverage[i] = std::min(coverage, 1.0f);
        }
    }
    for (const int16_t rule : assignment.rule)
        if (rule >= 0) ++assignment.counts[static_cast<size_t>(rule)];
    return assignment;
}

}  // namespace burnish
