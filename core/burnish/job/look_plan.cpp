#include <burnish/job/look_plan.h>

#include <burnish/job/ready_materials.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace burnish {
namespace {

constexpr size_t kFewestPixels = 160, kMostPixels = 400;  // of a material that are checked
constexpr float kEveryPixel = 100;                        // safety that leaves nothing to interpolate but what is flat

CostCase cost_case(const Look& look, const LitFrame& frame, size_t index) {
    CostCase of;
    of.pixels = frame.surfaces().rule_counts()[index];
    const auto& counts = frame.surfaces().rule_counts();  // what a frame costs whatever is shaded is shared by these
    of.frame_pixels =
        frame.assignment().rule.size() * of.pixels / std::max<size_t>(1, std::reduce(counts.begin(), counts.end()));
    of.is_near = !look.rig.is_distant(frame.looks()[index].chain);
    const Environment* environment = look.rig.environment();
    if (environment && !of.is_near) of.suns = static_cast<int>(environment->discs().size());
    if (environment)
        of.face_texels = 6 * static_cast<size_t>(environment->face_size()) * static_cast<size_t>(environment->face_size());
    of.frames = look.frames;
    of.has_maps = look.wardrobe.factors.contains(look.wardrobe.rules[frame.looks()[index].rule].material);
    return of;
}

/// Pixels that are checked of each look: so many that their truth takes a tenth of what the frame would take by the defaults.
size_t pixels_to_check(const Look& look, const LitFrame& frame, const QualityTarget& target) {
    constexpr double kShare = 0.1, kLookupsAPixel = 700, kUsualTolerance = 0.074;
    double seconds = 0;
    for (size_t i = 0; i < frame.looks().size(); ++i) {
        CostCase of = cost_case(look, frame, i);
        of.has_stack = of.has_pyramid = i > 0;  // filtered once
        seconds += predicted_seconds(machine_costs(), look.wardrobe.materials[frame.looks()[i].rule],
                                     {EstimatorKind::fitted, 6}, 0, of);
    }
    const double lookups = kLookupsAPixel * std::pow(kUsualTolerance / truth_tolerance(target), 4.0 / 3);
    const double pixels = kShare * seconds / reference_seconds(machine_costs(), lookups);
    const double each = pixels / static_cast<double>(std::max<size_t>(1, frame.looks().size()));
    return std::clamp(static_cast<size_t>(each), kFewestPixels, kMostPixels);
}

EstimatorSettings truth_settings(EstimatorSettings settings, const QualityTarget& target) {
    constexpr int kMostLookups = 8192;
    settings.kind = EstimatorKind::reference, settings.adaptive = true;
    settings.tolerance = truth_tolerance(target), settings.max_samples = kMostLookups;
    return settings;
}

}  // namespace

std::vector<ShadingSettings> LookPlan::plan(const Look& look, const LitFrame& frame, const Progress& progress) {
    m_shading = look.shading, m_progress = progress, m_done = 0;
    m_frame.clear();
    const size_t count = pixels_to_check(look, frame, m_target);
    std::vector<PlanSubject> subjects;
    std::vector<size_t> fresh;
    for (size_t i = 0; i < frame.looks().size(); ++i) {
        m_progress.report("planning", m_done);
        const auto shader = [&](const EstimatorSettings& settings) {
            return equip_shader(look, frame.looks()[i], {settings, {}, {}});
        };
        const MaterialShader one = shader(with(look.shading.estimator, kProbe)),
                             other = shader(other_probe(look.shading.estimator));
        CheckSample sample = check_sample(frame.surfaces(), frame.assignment(), static_cast<int>(i), count, {one, other});
        const Truth truth(frame.surfaces(), std::move(sample), shader(truth_settings(look.shading.estimator, m_target)));
        m_frame.push_back({{}, frame.looks()[i], truth, {}, false});
        if (const auto known = m_planned.find({frame.looks()[i].rule, frame.looks()[i].chain}); known != m_planned.end()) {
            m_frame.back().planned = known->second;
            continue;
        }
        fresh.push_back(i);
        subjects.push_back(subject_of(look, frame, i, truth));
    }
    if (!fresh.empty()) {
        const auto planner = std::make_shared<Planner>(std::move(subjects), m_target, look.shading.estimator, machine_costs());
        for (size_t subject = 0; subject < fresh.size(); ++subject) {
            Shown& shown = m_frame[fresh[subject]];
            shown.planned = {planner, subject};
            m_planned[{shown.lit.rule, shown.lit.chain}] = shown.planned;
        }
    }
    return shading();
}

PlanSubject LookPlan::subject_of(const Look& look, const LitFrame& frame, size_t index, Truth truth) const {
    PlanSubject subject{
        &look.wardrobe.materials[frame.looks()[index].rule], std::move(truth), cost_case(look, frame, index), {}, {0}};
    subject.shader = [this, &look, lit = frame.looks()[index]](const EstimatorSettings& settings, const LobeChoice& lobes) {
        m_progress.report("planning", m_done);
        return equip_shader(look, lit, {settings, {}, lobes});
    };
    if (look.shading.density.density == ShadingDensity::sparse) subject.safeties.clear();
    if (look.shading.density.density != ShadingDensity::dense)
        subject.safeties.insert(subject.safeties.end(), {0.5f, 1.0f, 2.0f, 4.0f});
    return subject;
}

ShadingSettings LookPlan::settings_of(const Planned& planned) const {
    const MaterialPlan& plan = planned.planner->plans()[planned.subject];
    ShadingSettings settings{plan.estimator, m_shading.density, plan.lobes};
    settings.density.density = plan.safety > 0 ? ShadingDensity::sparse : ShadingDensity::dense;
    settings.density.safety = plan.safety > 0 ? plan.safety : kEveryPixel;
    return settings;
}

std::vector<ShadingSettings> LookPlan::shading() const {
    std::vector<ShadingSettings> all;
    for (const Shown& shown : m_frame) all.push_back(settings_of(shown.planned));
    return all;
}

bool LookPlan::correct(const Image& overlay) {
    check(overlay);
    m_done = kFirstShading;
    bool changed = false;
    for (Shown& shown : m_frame) {
        shown.is_corrected = shown.planned.planner->correct(shown.planned.subject, shown.found);
        changed |= shown.is_corrected;
    }
    return changed;
}

void LookPlan::check(const Image& overlay) {
    for (Shown& shown : m_frame) shown.found = shown.truth.closeness(overlay);
}

std::vector<PlanReport> LookPlan::reports(const Look& look) const {
    std::vector<PlanReport> reports;
    for (const Shown& shown : m_frame) {
        const MaterialPlan& plan = shown.planned.planner->plans()[shown.planned.subject];
        PlanReport& report = reports.emplace_back();
        report.material = look.wardrobe.rules[shown.lit.rule].material;
        for (const size_t light : shown.lit.chain) report.lights.push_back(look.rig.lights[light].name);
        report.words = in_words(plan);
        report.estimator = estimator_name(plan.estimator.kind), report.samples = plan.estimator.samples,
        report.safety = plan.safety;
        if (plan.estimator.kind == EstimatorKind::reference) report.tolerance = plan.estimator.tolerance;
        report.lobes = plan.lobes.size(),
        report.dropped_lobes = look.wardrobe.materials[shown.lit.rule].lobes.size() - plan.lobes.size();
        report.target_db = shown.planned.planner->level();
        report.expected_db = plan.expected_db, report.expected_seconds = plan.expected_seconds;
        report.found_db = shown.found.psnr_db, report.least_db = shown.found.low_db, report.largest_error = shown.found.largest;
        report.checked_pixels = shown.found.pixels, report.is_corrected = shown.is_corrected;
        report.is_missed = misses(shown.found, m_target);
    }
    return reports;
}

}  // namespace burnish
