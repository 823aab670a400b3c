// Colour for lobes that were fitted to grey: kd and a tint per lobe and channel, shapes as they are.
#pragma once

#include <burnish/base/json_fields.h>
#include <burnish/fit/search/transfer_samples.h>

namespace burnish {

/// Sets kd and the tints of the lobes on `side` to what fits each channel best, by weighted medians in turn; grey tables are left
/// alone. kd stays in `kd_range`.
void fit_colors(Material& material, const TransferSamples& samples, Side side, NumberRange kd_range);

}  // namespace burnish
