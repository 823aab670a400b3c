// The window through which a lobe is seen: laid around its image for one view, by the moments of what it holds.
#pragma once

#include <burnish/base/types.h>

#include <functional>

namespace burnish {

/// Azimuthal equidistant about `centre`: the direction x along + y across, radian, away from it. (x, y) in [-1, 1]^2 is inside.
struct LobeWindow {
    Vec3f centre, along, across;  // the latter two perpendicular to it and to each other

    Vec3f direction(float x, float y) const;
    /// The inverse, for unit vectors.
    Vec2f place(const Vec3f& w) const;
    /// Largest stretch of the mapping at (x, y): window units per radian.
    float stretch(float x, float y) const;
};

/// A window two and a half standard deviations of value^2 wide either way along the lobe's own axes, at most a quarter turn;
/// `guess` is where its peak is looked for first. A lobe that is zero all around gets the widest.
LobeWindow lobe_window(const std::function<float(const Vec3f& wi)>& value, const Vec3f& guess);

}  // namespace burnish
