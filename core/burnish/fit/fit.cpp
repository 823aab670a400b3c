#include <burnish/fit/fit.h>

#include <burnish/base/error.h>
#include <burnish/fit/color_shift.h>
#include <burnish/fit/fit_curves.h>
#include <burnish/fit/search/fit_lobes.h>
#include <burnish/fit/search/lobe_mixture_fit.h>
#include <burnish/fit/slices/slice_fit.h>
#include <burnish/material/library.h>
#include <burnish/material/model.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace burnish {
namespace {

using nlohmann::json;

constexpr ModelId kBySlices[] = {ModelId::sgd, ModelId::beckmann, ModelId::ggx, ModelId::abc};
constexpr ModelId kCandidates[] = {ModelId::sgd, ModelId::ggx, ModelId::kurt};  // of dense tables

/// Slices mean something where values are dense, and tell all where turning the surface changes nothing.
bool has_slices(const MeasuredBrdf& data) { return data.is_dense() && data.is_isotropic() && !data.transmits(); }

bool is_fitted_by_slices(ModelId model) { return std::ranges::find(kBySlices, model) != std::end(kBySlices); }

/// By the way that suits model and data.
FitResult fit_one(const MeasuredBrdf& data, const FitSettings& settings, const Progress& progress) {
    if (settings.model == ModelId::table)
        throw Error(ErrorCode::bad_argument,
                    "model table: a table is shown as it is, without a fit: --material " + data.file());
    const bool by_slices = has_slices(data) && settings.model && is_fitted_by_slices(*settings.model);
    if (!by_slices) return fit_lobes(data, settings, progress);
    FitResult result = fit_slices(data, settings, progress).result;
    result.l1 = l1_error(data, result.material);
    return result;
}

/// All candidates, and which of them to take.
FitComparison compare_models(const MeasuredBrdf& data, const FitSettings& settings, const Progress& progress) {
    if (!settings.bounds.empty())
        throw Error(ErrorCode::bad_argument, "bounds are of one model's parameters; name the model, too (--model)");
    FitComparison comparison;
    FitSettings own = settings;
    constexpr auto kParts = static_cast<float>(std::size(kCandidates));
    for (const ModelId model : kCandidates) {
        own.model = model;
        const auto done = static_cast<float>(comparison.tried.size());
        comparison.tried.push_back(fit_one(data, own, part_of(progress, done / kParts, (done + 1) / kParts)));
    }
    const auto price = [](const FitResult& fit) { return *fit.normalised_l2 * (1 + kGainPerNumber * fit.parameters); };
    comparison.chosen = static_cast<size_t>(std::ranges::min_element(comparison.tried, {}, price) - comparison.tried.begin());
    return comparison;
}

void add_color_note(const MeasuredBrdf& data, FitResult& fit) {
    const double shift = color_shift(data.samples(), fit.material);
    if (shift < kVisibleColorShift) return;
    std::ostringstream note;
    note.precision(2);
    note << "its colour changes with the angle, by " << 100 * shift << " % from the fit's; no model here does that";
    fit.notes.push_back(note.str());
}

json errors_to_json(const FitResult& fit) {
    const auto& lobes = fit.material.lobes;
    return {{"model", lobes.empty() ? "diffuse" : model_info(lobes.front().model).name},
            {"lobes", lobes.size()},
            {"parameters", fit.parameters},
            {"normalised_l2", fit.normalised_l2 ? json(*fit.normalised_l2) : json()},
            {"l1", fit.l1},
            {"seconds", fit.seconds}};
}

json colors_to_json(const std::vector<Color3f>& colors) {
    json list = json::array();
    for (const Color3f& color : colors) list.push_back({color.x, color.y, color.z});
    return list;
}

}  // namespace

FitComparison fit_material(const MeasuredBrdf& data, const FitSettings& settings, const Progress& progress) {
    const bool is_settled = settings.model || !has_slices(data);
    FitComparison comparison =
        is_settled ? FitComparison{{fit_one(data, settings, progress)}, 0} : compare_models(data, settings, progress);
    add_color_note(data, comparison.tried[comparison.chosen]);
    return comparison;
}

json fit_report(const MeasuredBrdf& data, const FitComparison& comparison) {
    const FitResult& best = comparison.best();
    json report = {{"table", data.file()},           {"material", material_to_json(best.material)},
                   {"errors", errors_to_json(best)}, {"notes", best.notes},
                   {"tried", json::array()},         {"residuals", json::array()},
                   {"curves", json::array()}};
    for (const FitResult& fit : comparison.tried) report["tried"].push_back(errors_to_json(fit));
    for (const AngleResidual& residual : angle_residuals(data, best.material))
        report["residuals"].push_back({{"theta_i_deg", residual.theta_i_deg},
                                       {"pairs", residual.pairs},
                                       {"relative", {residual.relative.x, residual.relative.y, residual.relative.z}}});
    for (const FitCurve& curve : fit_curves(data, best.material))
        report["curves"].push_back({{"kind", curve.kind},
                                    {"theta_i_deg", curve.theta_i_deg},
                                    {"data_deg", curve.data_deg},
                                    {"fit_deg", curve.fit_deg},
                                    {"data", colors_to_json(curve.data)},
                                    {"fit", colors_to_json(curve.fit)}});
    return report;
}

}  // namespace burnish
