// What a measurement holds, in words: what `burnish info` prints for its file.
#pragma once

#include <burnish/material/measured/measured_brdf.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace burnish {

/// {"file", "kind", "merl_name", "isotropic", "transmits", "samples", "theta_i_deg" [least, most], "kd", "width", "albedo"}: the file's
/// kind in words, its name in the MERL database or "", numbers of valid pairs, and what the material made of it looks like.
nlohmann::json describe_measured_json(const MeasuredBrdf& measured);
std::string describe_measured(const MeasuredBrdf& measured);

}  // namespace burnish
