#include <burnish/fit/fit.h>

#include <burnish/base/error.h>
#include <burnish/fit/fit_curves.h>
#include <burnish/fit/fit_lobes.h>
#include <burnish/material/library.h>
#include <burnish/material/model.h>

#include <nlohmann/json.hpp>

namespace burnish {
namespace {

using nlohmann::json;

json errors_to_json(const FitResult& fit) {
    const auto& lobes = fit.material.lobes;
    return {{"model", lobes.empty() ? "diffuse" : model_info(lobes.front().model).name},
            {"lobes", lobes.size()},
            {"parameters", fit.parameters},
            {"normalised_l2", fit.normalised_l2},
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
    return {{fit_lobes(data, settings, progress)}, 0};
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
