// Measured pairs as plain text, in degrees; what `read_measured` reads and users write themselves.
//
//     # burnish gonio 1
//     # surface isotropic                    or anisotropic
//     # values brdf                          f in 1/sr, or transfer: f |cos theta_o|
//     # columns theta_i phi_i theta_o phi_o R G B          or ... phi_o value
//     10 0  12.5 180  0.31 0.30 0.22
//
// theta is the angle to the normal, theta_o > 90 light that comes through; other lines that begin with # are comments.
#pragma once

#include <burnish/material/measured/gonio_table.h>

#include <string>

namespace burnish {

/// Whether a file's first line says that it is such a text.
bool is_gonio_file(const std::string& first_line);
/// Throws Error(read_failed), naming file, line, what was expected and found.
std::shared_ptr<const GonioTable> read_gonio(const std::string& file);
/// Writes f; the file appears whole or not at all.
void write_gonio(const std::vector<BrdfSample>& samples, bool isotropic, const std::string& file);

}  // namespace burnish
