#include <burnish/plan/configuration.h>

namespace burnish {

const std::vector<Configuration>& configurations() {
    using enum EstimatorKind;
    static const std::vector<Configuration> all = [] {
        std::vector<Configuration> list;
        list.push_back(kFactored);
        for (const int samples : {1, 2, 3, 4, 6, 8, 12, 16}) list.push_back({fitted, samples});
        for (const int samples : {4, 7, 12, 19, 30, 61}) list.push_back({regular, samples});
        for (const int samples : {16, 32, 64, 128, 256, 512, 1024, 2048}) list.push_back({filtered_importance, samples});
        return list;
    }();
    return all;
}

EstimatorSettings with(EstimatorSettings settings, const Configuration& configuration) {
    settings.kind = configuration.estimator, settings.samples = configuration.samples, settings.adaptive = false;
    return settings;
}

EstimatorSettings other_probe(EstimatorSettings settings) {
    settings = with(settings, {EstimatorKind::filtered_importance, 32});
    settings.albedo_correction = false;  // its table takes longer than all else
    return settings;
}

}  // namespace burnish
