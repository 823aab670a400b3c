// A fit beside its data, as curves: what plots and the report show.
//
//     half        theta_d = 0: wo = wi = h, over theta_h: the distribution of slopes, seen along itself (Bandwidth V.1)
//     difference  theta_h = 0: mirror reflection, over theta_d: Fresnel and shadowing
//     lobe        light from theta_i, over theta_o in the plane of incidence, positive on the mirror's side
//     through     the same behind a sheet that lets light through
//     pairs       measured pairs of one incident angle, over theta_h: for tables too sparse for slices
#pragma once

#include <burnish/material/measured/measured_brdf.h>
#include <burnish/material/parameters.h>

#include <string>
#include <vector>

namespace burnish {

struct FitCurve {
    std::string kind;
    float theta_i_deg = 0;  // of lobes and pairs
    std::vector<float> data_deg = {}, fit_deg = {};
    std::vector<Color3f> data = {}, fit = {};  // f, 1/sr
};

/// Of dense tables both slices and lobes of a few incident angles; of others the pairs of the incident angles that have most of
/// them, and lobes whose data are the pairs near the plane of incidence.
std::vector<FitCurve> fit_curves(const MeasuredBrdf& data, const Material& fit);

/// How far the fit is off, by the light's angle: mean of |data - fit| |cos_o| over that of data |cos_o|, all measured pairs.
struct AngleResidual {
    float theta_i_deg;
    int pairs;
    Color3f relative;
};
/// Angles are gathered to steps of ten degrees, ascending.
std::vector<AngleResidual> angle_residuals(const MeasuredBrdf& data, const Material& fit);

}  // namespace burnish
