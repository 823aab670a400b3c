#include <burnish/plan/cost_model.h>

#include <burnish/material/model.h>
#include <burnish/shading/albedo_ratio.h>
#include <burnish/shading/bend_sums.h>
#include <burnish/shading/fitted.h>
#include <burnish/shading/tap_table.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr double kFitEvaluations = 2500;  // of the model, for one fit
constexpr double kFitGrowth = 1.4;        // of a fit's time with its lookups
constexpr double kTypicalShare = 0.3, kShareGrowth = 0.75;
constexpr size_t kPairs = 130'000;                                        // of normal and view that maps are made from
constexpr Configuration kSampler{EstimatorKind::fitted, 6};               // that these are shaded by
constexpr Configuration kProbes{EstimatorKind::fitted, kPredictionTaps};  // that sparse shading predicts by

/// `factored` has no lobes at a pixel but for the suns, which maps that are given hold, and maps made from shaded pairs of normal and view.
PredictedCost factored_cost(const MachineCosts& machine, const Material& material, const CostCase& of) {
    PredictedCost cost;
    if (!of.has_maps) {
        CostCase pairs = of;
        pairs.pixels = kPairs;
        cost = predicted_cost(machine, material, kSampler, 0, pairs);
        cost.tables += (cost.shading + machine.maps) / of.frames;
    }
    const double suns = of.has_maps ? 0 : static_cast<double>(of.suns) * static_cast<double>(material.lobes.size());
    cost.shading = static_cast<double>(of.pixels) * (machine.map_pixel + suns * machine.sun);
    return cost;
}

/// A measured table has no numbers of its own to be calibrated by: it is as dear as the dearest model, and a half more.
double evaluation_seconds(const MachineCosts& machine, ModelId model) {
    const auto found = machine.evaluation.find(model_info(model).name);
    if (found != machine.evaluation.end()) return found->second;
    double dearest = 0;
    for (const auto& [name, seconds] : machine.evaluation) dearest = std::max(dearest, seconds);
    return 1.5 * dearest;
}

double fit_seconds(const MachineCosts& machine, const LobeParameters& lobe, int lookups) {
    const double growing = lobe.mx == lobe.my ? machine.fit_lookup : machine.turned_fit_lookup;
    const double fit = kFitEvaluations * evaluation_seconds(machine, lobe.model) + growing * std::pow(lookups, kFitGrowth);
    return fit_count(lobe) * fit / machine.cores;
}

/// What is made once for a lobe.
double table_seconds(const MachineCosts& machine, const LobeParameters& lobe, const EstimatorSettings& settings) {
    if (settings.kind == EstimatorKind::reference) return 0;
    const int nodes = TapTable::covers(lobe, settings.samples) ? TapTable::node_count(TapTable::axes_of(lobe)) : 0;
    const double rows = nodes * machine.table_lookup * settings.samples;
    if (settings.kind == EstimatorKind::fitted) return fit_seconds(machine, lobe, settings.samples) + rows;
    const double evaluations = AlbedoRatio::evaluations(lobe);
    return evaluations * evaluation_seconds(machine, lobe.model) / machine.cores + rows;
}

/// Of one pixel. Without a table every pixel makes its own taps.
double pixel_seconds(const MachineCosts& machine, const LobeParameters& lobe, const EstimatorSettings& settings,
                     const CostCase& of) {
    if (settings.kind == EstimatorKind::reference) return settings.samples * machine.reference_lookup;
    const bool is_fitted = settings.kind == EstimatorKind::fitted;
    double lookup = of.is_near ? machine.near_ray : is_fitted ? machine.stack_lookup : machine.lookup;
    if (!TapTable::covers(lobe, settings.samples)) lookup += machine.table_lookup;
    return machine.pixel + settings.samples * lookup + of.suns * machine.sun;
}

double light_seconds(const MachineCosts& machine, bool reads_pyramid, bool reads_stack, const CostCase& of) {
    const auto texels = static_cast<double>(of.face_texels);
    return (reads_pyramid && !of.has_pyramid ? texels * machine.pyramid_texel : 0) +
           (reads_stack && !of.has_stack ? texels * machine.stack_texel : 0);
}

}  // namespace

double sparse_share(float safety, double at_one) {
    return std::min(1.0, (at_one > 0 ? at_one : kTypicalShare) * std::pow(static_cast<double>(safety), kShareGrowth));
}

PredictedCost predicted_cost(const MachineCosts& machine, const Material& material, const Configuration& configuration,
                             float safety, const CostCase& of) {
    if (configuration == kFactored) return factored_cost(machine, material, of);
    const bool is_sparse = safety > 0;
    const double pixels = static_cast<double>(of.pixels) * (is_sparse ? sparse_share(safety, of.sparse_share) : 1);
    PredictedCost cost;
    bool reads_pyramid = false, reads_stack = is_sparse;
    for (const LobeParameters& lobe : material.lobes) {
        const EstimatorSettings settings = settled(lobe, with({}, configuration));
        const bool by_stack = settings.kind == EstimatorKind::fitted || of.is_near;
        reads_stack |= by_stack, reads_pyramid |= !by_stack && settings.kind != EstimatorKind::reference;
        cost.tables += table_seconds(machine, lobe, settings);
        if (is_sparse) cost.tables += table_seconds(machine, lobe, settled(lobe, with({}, kProbes)));
        cost.shading += pixels * pixel_seconds(machine, lobe, settings, of);
    }
    if (is_sparse) cost.shading += static_cast<double>(of.frame_pixels) * machine.sparse_pixel;
    cost.light = light_seconds(machine, reads_pyramid, reads_stack, of) / of.frames;
    cost.tables /= of.frames;
    return cost;
}

double predicted_seconds(const MachineCosts& machine, const Material& material, const Configuration& configuration,
                         float safety, const CostCase& of) {
    return predicted_cost(machine, material, configuration, safety, of).total();
}

double reference_seconds(const MachineCosts& machine, double lookups) { return lookups * machine.reference_lookup; }

}  // namespace burnish
