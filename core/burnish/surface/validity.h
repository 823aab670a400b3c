// Why a pixel is not shaded, or that it is.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace burnish {

/// Written as a diagnostic layer and counted in the report.
enum class Validity : uint8_t { valid, background, not_finite, zero_normal, averaged_normal, back_facing, unassigned };
inline constexpr int kValidityCount = 7;
/// Pixels per Validity.
using ValidityCounts = std::array<size_t, kValidityCount>;
std::string_view validity_name(Validity validity);

}  // namespace burnish
