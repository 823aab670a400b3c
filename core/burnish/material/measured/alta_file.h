// ALTA's text files, as far as measurements of isotropic materials come in them.
//
//     #DIM n m                               columns of angles and of values, 1 or 3 values
//     #PARAM_IN  ISOTROPIC_TL_TV_PROJ_DPHI   theta_l, theta_v cos(dphi), theta_v sin(dphi), radians
//              | ISOTROPIC_TV_TL_DPHI        theta_v, theta_l, dphi
//              | RUSIN_TH_TD_PD              theta_h, theta_d, phi_d
//              | COS_TH                      cos(theta_h) alone: a curve, see half_angle_curve.h
//     #PARAM_OUT INV_STERADIAN | RGB_COLOR   f in 1/sr
//              | INV_STERADIAN_COSINE_FACTOR f times the cosine of theta_v
#pragma once

#include <burnish/material/measured/measured_brdf.h>

#include <memory>
#include <string>

namespace burnish {

/// Throws Error(read_failed), naming file, line, what was expected and found.
std::shared_ptr<const MeasuredBrdf> read_alta(const std::string& file);

}  // namespace burnish
