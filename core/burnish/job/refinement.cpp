#include <burnish/job/refinement.h>

#include <burnish/base/error.h>
#include <burnish/job/build_lights.h>
#include <burnish/job/stages.h>
#include <burnish/shading/blend.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kFirstLookups = 7;      // a picture to recognise, of tables that cost nothing
constexpr int kDenseLookups = 256;    // where errors of filtering and of sampling are about the same
constexpr int kFirstReference = 512;  // a lobe: fewer improve the dense picture hardly anywhere

std::string lookups_text(int lookups) { return std::to_string(lookups) + (lookups == 1 ? " lookup" : " lookups"); }

EstimatorSettings few_lookups() {
    EstimatorSettings settings;
    settings.kind = EstimatorKind::regular, settings.samples = kFirstLookups;
    settings.albedo_correction = false;  // its table takes longer than the picture
    return settings;
}

EstimatorSettings many_lookups() {
    EstimatorSettings settings;
    settings.kind = EstimatorKind::preconvolved, settings.samples = kDenseLookups;
    return settings;
}

DensitySettings dense() {
    DensitySettings settings;
    settings.density = ShadingDensity::dense;
    return settings;
}

}  // namespace

std::vector<Refinement::Filtered> Refinement::filtered_steps(const Job& job, const DensitySettings& density) {
    EstimatorSettings own = job.estimator;
    if (own.kind == EstimatorKind::reference) own = {};
    std::vector<Filtered> steps{{"first look", few_lookups(), dense()}, {"as set", own, density}};
    if (lookup_count(own) < kDenseLookups) steps.push_back({"dense, " + lookups_text(kDenseLookups), many_lookups(), dense()});
    return steps;
}

Refinement::Refinement(const Job& job, const AovFrame& frame, const AovFrame* fine, Wardrobe wardrobe, Rig rig,
                       const Assignment* assignment)
    : m_job(job),
      m_look(prepare_look(job, std::move(wardrobe), std::move(rig), {(fine ? *fine : frame).pixel_count()})),
      m_lit(m_job, frame, fine, m_look.wardrobe, m_look.rig, assignment),
      m_filtered_steps(filtered_steps(job, m_look.shading.density)) {
    if (job.target.is_set())
        throw Error(ErrorCode::bad_argument,
                    "progressive: refines down to the exact picture and takes no target; leave out psnr, max_error and time");
}

RefinedFrame Refinement::next(const Progress& progress) {
    if (m_is_done) throw Error(ErrorCode::bad_argument, "refine: the last step was taken");
    NamedValues<double> seconds;
    RefinedFrame refined;
    refined.step = m_step;
    if (m_step == 0) load_needed(m_look.rig, m_lit.looks(), seconds, progress);
    Pictures pictures;
    if (const size_t step = static_cast<size_t>(m_step); step < m_filtered_steps.size()) {
        shade_filtered(m_filtered_steps[step], progress, seconds);
        pictures = m_filtered, refined.label = m_filtered_steps[step].label;
    } else {
        const int64_t wanted = int64_t{kFirstReference} << (step - m_filtered_steps.size());
        const int lookups = static_cast<int>(std::min<int64_t>(wanted, m_job.estimator.max_samples));
        pictures = shade_references(lookups, progress, seconds), refined.label = "reference, " + lookups_text(lookups);
    }
    refined.is_final = m_is_done;
    refined.result = m_lit.finish(m_job, std::move(pictures.shaded), is_difference() ? &pictures.old : nullptr);
    NamedValues<double>& told = refined.result.tally.seconds;
    told.insert(told.begin(), seconds.begin(), seconds.end());
    ++m_step;
    return refined;
}

Equipment Refinement::equipped(const EstimatorSettings& estimator, const DensitySettings& density) const {
    return equip(m_look, m_lit.looks(), {m_lit.looks().size(), {estimator, density, {}}});
}

void Refinement::shade_filtered(const Filtered& settings, const Progress& progress, NamedValues<double>& seconds) {
    const Equipment equipment = timed(seconds, "tables", [&] { return equipped(settings.estimator, settings.density); });
    const float middle = is_difference() ? 0.5f : 1.0f;
    timed(seconds, "shading", [&] {
        const bool with_samples = m_job.output.diagnostics;
        m_filtered.shaded = m_lit.shade(equipment.shaders, equipment.predictors, part_of(progress, 0.0f, middle), with_samples);
        if (is_difference())
            m_filtered.old =
                m_lit.shade(equipment.old_shaders, equipment.old_predictors, part_of(progress, middle, 1.0f), false);
    });
}

Refinement::Pictures Refinement::shade_references(int lookups, const Progress& progress, NamedValues<double>& seconds) {
    EstimatorSettings settings = m_job.estimator;
    settings.kind = EstimatorKind::reference, settings.adaptive = false;
    const auto run_of = [&](std::vector<MaterialShader> shaders) {
        return ReferenceRun(m_lit.surfaces(), m_lit.assignment(), std::move(shaders), settings);
    };
    if (!m_references) {
        Equipment equipment = equipped(settings, dense());
        m_references.emplace(run_of(std::move(equipment.shaders)), std::nullopt);
        if (is_difference()) m_references->old.emplace(run_of(std::move(equipment.old_shaders)));
    }
    References& running = *m_references;
    const float middle = is_difference() ? 0.5f : 1.0f;
    timed(seconds, "shading", [&] {
        running.shaded.carry_on(lookups, part_of(progress, 0.0f, middle));
        if (running.old) running.old->carry_on(lookups, part_of(progress, middle, 1.0f));
    });
    m_is_done = running.shaded.is_done() && (!running.old || running.old->is_done());
    return timed(seconds, "blending", [&] {
        const auto blended = [&](const ShadedFrame& filtered, const ReferenceRun& run) {
            return blend(filtered, run.frame(), m_lit.surfaces(), m_lit.assignment());
        };
        Pictures pictures{blended(m_filtered.shaded, running.shaded), {}};
        if (running.old) pictures.old = blended(m_filtered.old, *running.old);
        return pictures;
    });
}

}  // namespace burnish
