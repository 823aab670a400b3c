// From a target to settings: the cheapest way to shade each material that is expected to meet it.
//
//     probe        each material by kProbe at a few hundred pixels, against the exact integral
//     choose       of all configurations and densities, by models of error and cost
//     measure      the chosen one at the same pixels; where it misses, the next one
//
// A time is met by the highest quality that costs no more. Nothing here looks at a clock: the same job gives the same plan.
#pragma once

#include <burnish/plan/cost_model.h>
#include <burnish/plan/forecast.h>
#include <burnish/plan/lobe_choice.h>
#include <burnish/plan/quality_target.h>
#include <burnish/plan/truth.h>

#include <deque>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

/// A material under its lights in one frame.
struct PlanSubject {
    const Material* material;
    Truth truth;
    CostCase cost;
    /// Of these lobes of the material.
    std::function<MaterialShader(const EstimatorSettings&, const LobeChoice&)> shader;
    std::vector<float> safeties;  // to choose from; 0 = dense
};

struct MaterialPlan {
    LobeChoice lobes;
    EstimatorSettings estimator;
    float safety = 0;             // of sparse shading; 0 = dense
    double expected_db = 0;       // of the whole, sparse shading included
    double expected_seconds = 0;  // of the clock, a frame; light and its filtering apart
};

/// dB that stand for the target: its psnr, or what keeps single pixels within its max_error; 0 for a time alone.
double level_of(const QualityTarget& target);
/// What a closeness counts for: its dB, but no more than a quarter above what it is at least; less where single pixels miss.
double credit(const Closeness& closeness, const QualityTarget& target);
/// Whether what was found misses what was asked, by more than half a dB or at a single pixel; a time asks for no quality.
bool misses(const Closeness& closeness, const QualityTarget& target);
/// Tolerance of `reference` at which a few hundred pixels tell whether the target is met.
float truth_tolerance(const QualityTarget& target);

class Planner {
public:
    Planner(std::vector<PlanSubject> subjects, const QualityTarget& target, const EstimatorSettings& settings,
            const MachineCosts& machine);

    Planner(const Planner&) = delete;
    Planner& operator=(const Planner&) = delete;

    /// One a subject.
    const std::vector<MaterialPlan>& plans() const { return m_plans; }
    const Truth& truth(size_t subject) const { return m_subjects[subject].truth; }
    /// What the target comes to, dB: of a time, the highest that it allows.
    double level() const { return m_level; }

    /// `found`: of subject in the frame that its plan shaded. Whether that misses the target; then its plan has changed, once.
    bool correct(size_t subject, const Closeness& found);

private:
    struct Choice {
        Configuration configuration;
        float safety = 0;
        double db = 0, seconds = 0;
    };
    /// Of the filtered light.
    struct Forms {
        bool pyramid = false, stack = false;
    };

    void drop_lobes(size_t subject);
    void probe();
    double highest_level() const;
    std::vector<Choice> choose_all(double level) const;
    Choice choose(size_t subject, double level, const Forms& allowed) const;
    Choice choose_next(size_t subject);
    double seconds(size_t subject, const Configuration& configuration, float safety) const;
    double reference_seconds_of(size_t subject, float tolerance) const;
    double total_seconds(const std::vector<Choice>& choices) const;
    double filter_seconds(const Forms& forms) const;
    void use(const Choice& choice);
    void settle(size_t subject);
    MaterialShader shader_of(size_t subject, const Configuration& configuration) const;
    MaterialPlan plan_of(size_t subject) const;

    std::vector<PlanSubject> m_subjects;
    QualityTarget m_target;
    EstimatorSettings m_settings;
    const MachineCosts& m_machine;
    double m_level = 0;
    Forms m_forms;  // that some plan reads
    std::vector<LobeChoice> m_lobes;
    std::deque<Material> m_materials;  // with these lobes alone
    std::vector<Forecast> m_forecasts;
    std::vector<Choice> m_choices;
    std::vector<MaterialPlan> m_plans;
};

/// As the command line has it.
std::string_view estimator_name(EstimatorKind kind);
/// "fitted, 6 lookups a lobe, sparse at safety 1"
std::string in_words(const MaterialPlan& plan);

}  // namespace burnish
