// Local bandwidth: how fast the light field around a ray varies, in space and in angle.
#pragma once

namespace burnish {

/// The rectangle of the spatio-angular spectrum that holds 95 % of its energy (Bandwidth IV.3): half its sides.
struct Bandwidth {
    float nu_s = 0;  // cycles per unit of length
    float nu_a = 0;  // cycles per radian

    bool operator==(const Bandwidth&) const = default;
};

}  // namespace burnish
