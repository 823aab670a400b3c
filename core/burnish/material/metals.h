// Optical constants of the common metals, for linear Rec.709 channels.
#pragma once

#include <burnish/base/types.h>

#include <span>
#include <string_view>

namespace burnish {

struct Metal {
    std::string_view name, alias;  // alias: a second spelling, may equal the name
    Color3f eta, k;                // complex index of refraction eta + i k, per channel
};

/// Silver, aluminium, gold, copper, chromium and tungsten.
std::span<const Metal> metals();

}  // namespace burnish
