// Measured reflectance from whatever file holds it.
#pragma once

#include <burnish/material/measured/measured_brdf.h>

#include <memory>
#include <string>

namespace burnish {

/// Reads MERL's .binary, Cornell's .brdf, ALTA's .alta and .dat, and burnish's own text (gonio_file.h, any extension). Files are not
/// trusted: sizes are checked before memory is taken. Throws Error(read_failed), naming file, what was expected and found.
std::shared_ptr<const MeasuredBrdf> read_measured(const std::string& file);

/// Whether a file's name says that it holds measured reflectance: .binary, .brdf, .alta, .dat, .gonio.
bool is_measured_name(const std::string& file);

}  // namespace burnish
