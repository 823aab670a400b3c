// Cornell's .brdf files: spectra measured by the Program of Computer Graphics, as text.
//
//     # comments
//     31                                   how many wavelengths
//     400 410 ... 700                      which, in nm
//     theta_i phi_i theta_o phi_o f...     radians, and f in 1/sr for each wavelength
//
// Rows may break anywhere. Paints, measured isotropic. Spectra become linear Rec.709, see spectrum_color.h.
#pragma once

#include <burnish/material/measured/gonio_table.h>

#include <string>

namespace burnish {

/// Throws Error(read_failed), naming file, line, what was expected and found.
std::shared_ptr<const GonioTable> read_cornell(const std::string& file);

}  // namespace burnish
