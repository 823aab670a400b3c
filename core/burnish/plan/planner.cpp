#include <burnish/plan/planner.h>

#include <burnish/shading/factored.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace burnish {
namespace {

constexpr double kCaution = 0.3;          // standard deviations that are taken off what is expected
constexpr double kToleratedMiss = 0.5;    // dB that a target may be missed by
constexpr double kPeakOverRms = 6;        // of display errors, about: what joins a largest error to a PSNR
constexpr double kDisplayChange = 0.215;  // of the signal at middle grey, for a relative change of the light
constexpr int kMostMeasured = 5;          // configurations beside the probe, for each material
constexpr double kWorthATry =
    6;  // dB that filtered lookups may be expected to miss by, as `reference` costs a hundred times more
constexpr double kLowestLevel = 15, kHighestLevel = 70;

constexpr Configuration kReference{EstimatorKind::reference, 0};

double level_of_largest(double largest) { return -20 * std::log10(largest / kPeakOverRms); }

bool reads_stack(const Configuration& configuration, float safety) {
    return safety > 0 || configuration.estimator == EstimatorKind::fitted || configuration == kFactored;
}
bool reads_pyramid(const Configuration& configuration) {
    return configuration.estimator == EstimatorKind::regular || configuration.estimator == EstimatorKind::filtered_importance;
}

/// At which `reference` comes to a display PSNR, with 2 dB to spare.
float tolerance_for(double db) {
    return static_cast<float>(std::clamp(0.8 * std::pow(10, -db / 20) / kDisplayChange, 1e-5, 0.3));
}

}  // namespace

double level_of(const QualityTarget& target) {
    const double by_largest = target.max_error > 0 ? level_of_largest(target.max_error) : 0;
    return std::max<double>(target.psnr, by_largest);
}

double credit(const Closeness& closeness, const QualityTarget& target) {
    const double by_mean = std::min(closeness.psnr_db, closeness.low_db + kToleratedMiss / 2);
    if (target.max_error <= 0) return by_mean;
    const double room = 20 * std::log10(target.max_error / std::max(closeness.largest, 1e-9));
    return std::min(by_mean, level_of(target) + room);
}

bool misses(const Closeness& closeness, const QualityTarget& target) {
    return closeness.psnr_db < target.psnr - kToleratedMiss || (target.max_error > 0 && closeness.largest > target.max_error);
}

float truth_tolerance(const QualityTarget& target) {
    constexpr double kUsual = 40;
    constexpr float kNoisier = 2;  // than a picture that meets the target: more pixels tell more than less noise in each
    const double level = level_of(target);
    return kNoisier * tolerance_for(level > 0 ? level : kUsual);
}

Planner::Planner(std::vector<PlanSubject> subjects, const QualityTarget& target, const EstimatorSettings& settings,
                 const MachineCosts& machine)
    : m_subjects(std::move(subjects)), m_target(target), m_settings(settings), m_machine(machine) {
    for (size_t i = 0; i < m_subjects.size(); ++i) {
        drop_lobes(i);
        m_forecasts.emplace_back(m_materials.emplace_back(with_lobes(*m_subjects[i].material, m_lobes[i])));
    }
    probe();
    m_level = level_of(target);
    if (target.seconds > 0) m_level = m_level > 0 ? std::min(m_level, highest_level()) : highest_level();
    m_choices = choose_all(m_level);
    for (const Choice& choice : m_choices) use(choice);
    m_plans.resize(m_subjects.size());
    for (size_t i = 0; i < m_subjects.size(); ++i) settle(i);
}

/// Of several lobes those whose absence shows least, as long as all that are left out together make a twentieth of the error that
/// may be made.
void Planner::drop_lobes(size_t subject) {
    constexpr double kSpare = 13, kUsual = 40;  // dB
    const PlanSubject& of = m_subjects[subject];
    const double level = level_of(m_target) > 0 ? level_of(m_target) : kUsual;
    LobeChoice kept = all_lobes(*of.material);
    const auto shaded = [&](const LobeChoice& lobes) { return of.truth.shade(of.shader(with(m_settings, kProbe), lobes)); };
    const std::vector<Color3f> whole = kept.size() > 1 ? shaded(kept) : std::vector<Color3f>();
    while (kept.size() > 1) {
        LobeChoice best;
        double most = level + kSpare;
        for (size_t out = 0; out < kept.size(); ++out) {
            LobeChoice fewer = kept;
            fewer.erase(fewer.begin() + static_cast<ptrdiff_t>(out));
            const double db = of.truth.distance_db(shaded(fewer), whole);
            if (db >= most) most = db, best = std::move(fewer);
        }
        if (best.empty()) break;
        kept = std::move(best);
    }
    m_lobes.push_back(std::move(kept));
}

MaterialShader Planner::shader_of(size_t subject, const Configuration& configuration) const {
    return m_subjects[subject].shader(with(m_settings, configuration), m_lobes[subject]);
}

void Planner::probe() {
    for (size_t i = 0; i < m_subjects.size(); ++i) {
        const Closeness found = m_subjects[i].truth.closeness(shader_of(i, kProbe));
        m_forecasts[i].learn(kProbe, std::min(credit(found, m_target), kHighestLevel));
    }
}

double Planner::highest_level() const {
    double low = kLowestLevel, high = kHighestLevel;
    while (high - low > 0.25) {
        const double middle = (low + high) / 2;
        (total_seconds(choose_all(middle)) <= m_target.seconds ? low : high) = middle;
    }
    return low;
}

/// With both filtered forms of the light or with one: whichever comes cheaper, all materials together.
std::vector<Planner::Choice> Planner::choose_all(double level) const {
    std::vector<Choice> best;
    double least = std::numeric_limits<double>::infinity();
    for (const Forms allowed : {Forms{true, true}, Forms{true, false}, Forms{false, true}}) {
        std::vector<Choice> choices;
        for (size_t i = 0; i < m_subjects.size(); ++i) choices.push_back(choose(i, level, allowed));
        const double seconds = total_seconds(choices);
        if (seconds < least) least = seconds, best = std::move(choices);
    }
    return best;
}

Planner::Choice Planner::choose(size_t subject, double level, const Forms& allowed) const {
    Choice best{kReference, 0, level, reference_seconds_of(subject, tolerance_for(level))};
    const bool has_maps = !m_subjects[subject].cost.is_near && can_be_factored(m_materials[subject]);
    for (const Configuration& configuration : configurations())
        for (const float safety : m_subjects[subject].safeties) {
            if (reads_stack(configuration, safety) && !allowed.stack) continue;
            if (reads_pyramid(configuration) && !allowed.pyramid) continue;
            if (configuration == kFactored && (safety > 0 || !has_maps)) continue;
            const double db = m_forecasts[subject].total(configuration, safety, kCaution);
            const double cost = seconds(subject, configuration, safety);
            if (db >= level && cost < best.seconds) best = {configuration, safety, db, cost};
        }
    return best;
}

/// Of a frame, the filtering of light apart.
double Planner::seconds(size_t subject, const Configuration& configuration, float safety) const {
    const PlanSubject& of = m_subjects[subject];
    CostCase filtered = of.cost;
    filtered.has_pyramid = filtered.has_stack = true;
    return predicted_seconds(m_machine, m_materials[subject], configuration, safety, filtered);
}

/// From what the truth took: lookups go like tolerance^(-4/3).
double Planner::reference_seconds_of(size_t subject, float tolerance) const {
    const PlanSubject& of = m_subjects[subject];
    const double a_pixel = of.truth.lookups() / static_cast<double>(std::max<size_t>(1, of.truth.pixel_count()));
    const double lookups = a_pixel * std::pow(truth_tolerance(m_target) / tolerance, 4.0 / 3);
    return reference_seconds(m_machine, lookups * static_cast<double>(of.cost.pixels));
}

double Planner::total_seconds(const std::vector<Choice>& choices) const {
    double total = 0;
    Forms forms;
    for (const Choice& choice : choices) {
        total += choice.seconds;
        forms.pyramid |= reads_pyramid(choice.configuration), forms.stack |= reads_stack(choice.configuration, choice.safety);
    }
    return total + filter_seconds(forms);
}

/// What filtering distant light so adds to a frame, where it is not filtered yet.
double Planner::filter_seconds(const Forms& forms) const {
    const auto distant = std::ranges::find_if(m_subjects, [](const PlanSubject& s) { return !s.cost.is_near; });
    if (distant == m_subjects.end()) return 0;
    const auto seconds_of = [&](const Configuration& any, bool pyramid, bool stack) {
        CostCase of = distant->cost, filtered = distant->cost;
        of.has_pyramid |= !pyramid, of.has_stack |= !stack;
        filtered.has_pyramid = filtered.has_stack = true;
        return predicted_seconds(m_machine, *distant->material, any, 0, of) -
               predicted_seconds(m_machine, *distant->material, any, 0, filtered);
    };
    return (forms.pyramid ? seconds_of(kProbe, true, false) : 0) +
           (forms.stack ? seconds_of({EstimatorKind::fitted, 1}, false, true) : 0);
}

void Planner::use(const Choice& choice) {
    m_forms.pyramid |= reads_pyramid(choice.configuration);
    m_forms.stack |= reads_stack(choice.configuration, choice.safety);
}

/// Of what is filtered already, or of all where that is worth the filtering.
Planner::Choice Planner::choose_next(size_t subject) {
    const Choice within = choose(subject, m_level, m_forms), beyond = choose(subject, m_level, {true, true});
    Forms added{reads_pyramid(beyond.configuration) && !m_forms.pyramid,
                reads_stack(beyond.configuration, beyond.safety) && !m_forms.stack};
    const Choice& next = beyond.seconds + filter_seconds(added) < within.seconds ? beyond : within;
    use(next);
    return next;
}

/// Measures what was chosen, and the next one where it misses.
void Planner::settle(size_t subject) {
    Forecast& forecast = m_forecasts[subject];
    Choice& choice = m_choices[subject];
    const PlanSubject& of = m_subjects[subject];
    const bool asks_quality = level_of(m_target) > 0;
    const auto measure = [&](const Configuration& configuration, bool is_last_resort) {
        Closeness found = of.truth.closeness(shader_of(subject, configuration));
        if (is_last_resort) found.low_db = found.psnr_db;  // caution would cost a hundred times more
        forecast.learn(configuration, std::min(credit(found, m_target), kHighestLevel));
        choice = choose_next(subject);
    };
    for (int tries = 0; asks_quality && tries < kMostMeasured; ++tries) {
        if (choice.configuration == kReference || forecast.knows(choice.configuration)) break;
        measure(choice.configuration, false);
    }
    const Configuration& finest = configurations().back();
    if (choice.configuration == kReference && asks_quality && forecast.dense(finest, 0) > m_level - kWorthATry)
        measure(finest, true);
    m_plans[subject] = plan_of(subject);
}

MaterialPlan Planner::plan_of(size_t subject) const {
    const Choice& choice = m_choices[subject];
    MaterialPlan plan;
    plan.lobes = m_lobes[subject];
    plan.estimator = with(m_settings, choice.configuration);
    if (choice.configuration == kReference) plan.estimator.adaptive = true, plan.estimator.tolerance = tolerance_for(m_level);
    plan.safety = choice.safety, plan.expected_db = choice.db, plan.expected_seconds = choice.seconds;
    return plan;
}

bool Planner::correct(size_t subject, const Closeness& found) {
    const double reached = credit(found, m_target);
    const Choice& now = m_choices[subject];
    if (level_of(m_target) <= 0 || reached >= m_level - kToleratedMiss / 2 || now.configuration == kReference) return false;
    Forecast& forecast = m_forecasts[subject];
    if (now.safety > 0)
        forecast.learn_sparse(now.configuration, now.safety, reached);
    else
        forecast.learn(now.configuration, reached);
    const Choice missed = now;
    m_choices[subject] = choose_next(subject);
    settle(subject);
    return m_choices[subject].configuration != missed.configuration || m_choices[subject].safety != missed.safety;
}

std::string_view estimator_name(EstimatorKind kind) {
    constexpr std::string_view kNames[] = {"fitted",   "regular",  "filtered_importance", "preconvolved", "split_sum",
                                           "factored", "reference"};
    return kNames[static_cast<size_t>(kind)];
}

std::string in_words(const MaterialPlan& plan) {
    const std::string name(estimator_name(plan.estimator.kind));
    char text[96];
    if (plan.estimator.kind == EstimatorKind::reference)
        std::snprintf(text, sizeof text, "reference to %.2g %% of each pixel", 100.0 * plan.estimator.tolerance);
    else if (plan.estimator.kind == EstimatorKind::factored)
        std::snprintf(text, sizeof text, "factored, maps %s of %d texels, every pixel", plan.estimator.parametrization.c_str(),
                      plan.estimator.map_size);
    else if (plan.safety > 0)
        std::snprintf(text, sizeof text, "%s, %d lookups a lobe, sparse at safety %g", name.c_str(), plan.estimator.samples,
                      plan.safety);
    else
        std::snprintf(text, sizeof text, "%s, %d lookups a lobe, every pixel", name.c_str(), plan.estimator.samples);
    return text;
}

}  // namespace burnish
