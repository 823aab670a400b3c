#include <burnish/plan/planner.h>

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
constexpr int kMostMeasured = 3;          // configurations beside the probe, for each material
constexpr double kLowestLevel = 15, kHighestLevel = 70;

constexpr Configuration kReference{EstimatorKind::reference, 0};

double level_of_largest(double largest) { return -20 * std::log10(largest / kPeakOverRms); }

bool reads_stack(const Configuration& configuration, float safety) {
    return safety > 0 || configuration.estimator == EstimatorKind::fitted;
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
    const double by_mean = std::min(closeness.psnr_db, closeness.low_db + kToleratedMiss);
    if (target.max_error <= 0) return by_mean;
    const double room = 20 * std::log10(target.max_error / std::max(closeness.largest, 1e-9));
    return std::min(by_mean, level_of(target) + room);
}

float truth_tolerance(const QualityTarget& target) {
    constexpr double kUsual = 40;
    const double level = level_of(target);
    return tolerance_for(level > 0 ? level : kUsual);
}

Planner::Planner(std::vector<PlanSubject> subjects, const QualityTarget& target, const EstimatorSettings& settings,
                 const MachineCosts& machine)
    : m_subjects(std::move(subjects)), m_target(target), m_settings(settings), m_machine(machine) {
    for (const PlanSubject& subject : m_subjects) m_forecasts.emplace_back(*subject.material);
    probe();
    m_level = level_of(target);
    if (target.seconds > 0) m_level = m_level > 0 ? std::min(m_level, highest_level()) : highest_level();
    m_choices = choose_all(m_level);
    Allowed allowed{false, false};
    for (const Choice& choice : m_choices) {
        allowed.pyramid |= reads_pyramid(choice.configuration);
        allowed.stack |= reads_stack(choice.configuration, choice.safety);
    }
    m_plans.resize(m_subjects.size());
    for (size_t i = 0; i < m_subjects.size(); ++i) settle(i, m_choices[i], allowed);
}

void Planner::probe() {
    for (size_t i = 0; i < m_subjects.size(); ++i) {
        const PlanSubject& subject = m_subjects[i];
        const Closeness found = subject.truth.closeness(subject.shader(with(m_settings, kProbe)));
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
    for (const Allowed allowed : {Allowed{true, true}, Allowed{true, false}, Allowed{false, true}}) {
        std::vector<Choice> choices;
        for (size_t i = 0; i < m_subjects.size(); ++i) choices.push_back(choose(i, level, allowed));
        const double seconds = total_seconds(choices);
        if (seconds < least) least = seconds, best = std::move(choices);
    }
    return best;
}

Planner::Choice Planner::choose(size_t subject, double level, const Allowed& allowed) const {
    Choice best{kReference, 0, level, reference_seconds_of(subject, tolerance_for(level))};
    for (const Configuration& configuration : configurations())
        for (const float safety : m_subjects[subject].safeties) {
            if (reads_stack(configuration, safety) && !allowed.stack) continue;
            if (reads_pyramid(configuration) && !allowed.pyramid) continue;
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
    return predicted_seconds(m_machine, *of.material, configuration, safety, filtered);
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
    bool pyramid = false, stack = false;
    for (const Choice& choice : choices) {
        total += choice.seconds;
        pyramid |= reads_pyramid(choice.configuration), stack |= reads_stack(choice.configuration, choice.safety);
    }
    return total + (pyramid ? filter_seconds(false) : 0) + (stack ? filter_seconds(true) : 0);
}

/// Of the light, unless it is there: what a frame bears of it.
double Planner::filter_seconds(bool stack) const {
    for (const PlanSubject& subject : m_subjects) {
        if (subject.cost.is_near || (stack ? subject.cost.has_stack : subject.cost.has_pyramid)) continue;
        CostCase without = subject.cost, filtered = subject.cost;
        filtered.has_pyramid = filtered.has_stack = true;
        (stack ? without.has_pyramid : without.has_stack) = true;
        const Configuration any = stack ? Configuration{EstimatorKind::fitted, 1} : kProbe;
        return predicted_seconds(m_machine, *subject.material, any, 0, without) -
               predicted_seconds(m_machine, *subject.material, any, 0, filtered);
    }
    return 0;
}

/// Measures what was chosen, and the next one where it misses.
void Planner::settle(size_t subject, Choice choice, const Allowed& allowed) {
    Forecast& forecast = m_forecasts[subject];
    for (int tries = 0; tries < kMostMeasured && choice.configuration != kReference; ++tries) {
        if (forecast.knows(choice.configuration)) break;
        const PlanSubject& of = m_subjects[subject];
        const Closeness found = of.truth.closeness(of.shader(with(m_settings, choice.configuration)));
        forecast.learn(choice.configuration, std::min(credit(found, m_target), kHighestLevel));
        if (m_target.psnr <= 0 && m_target.max_error <= 0) break;
        choice = choose(subject, m_level, allowed);
    }
    m_choices[subject] = choice;
    m_plans[subject] = plan_of(choice);
}

MaterialPlan Planner::plan_of(const Choice& choice) const {
    MaterialPlan plan;
    plan.estimator = with(m_settings, choice.configuration);
    if (choice.configuration == kReference) plan.estimator.tolerance = tolerance_for(m_level);
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
    const Choice next = choose(subject, m_level, {});
    const bool is_new = next.configuration != now.configuration || next.safety != now.safety;
    m_choices[subject] = next;
    m_plans[subject] = plan_of(next);
    return is_new;
}

std::string in_words(const MaterialPlan& plan) {
    static const char* const kNames[] = {"fitted", "regular", "filtered_importance", "preconvolved", "split_sum", "reference"};
    const std::string name = kNames[static_cast<size_t>(plan.estimator.kind)];
    char text[96];
    if (plan.estimator.kind == EstimatorKind::reference)
        std::snprintf(text, sizeof text, "reference to %.2g %% of each pixel", 100.0 * plan.estimator.tolerance);
    else if (plan.safety > 0)
        std::snprintf(text, sizeof text, "%s, %d lookups a lobe, sparse at safety %g", name.c_str(), plan.estimator.samples,
                      plan.safety);
    else
        std::snprintf(text, sizeof text, "%s, %d lookups a lobe, every pixel", name.c_str(), plan.estimator.samples);
    return text;
}

}  // namespace burnish
