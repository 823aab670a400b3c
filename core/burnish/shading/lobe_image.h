// The image of a lobe's slopes under reflection, to first order: how large, how long and which way round a lobe is.
//
// With J = d reflect(wo, h) / d(sx, sy) at the mirror direction (2 in the plane of incidence, 2 cos theta_o across it) and
// M = diag(mx^2, my^2) / 2 the slopes' covariance, the lobe of directions has covariance J M J^T. Anisotropic materials are
// included: the axes turn with the view.
#pragma once

#include <burnish/base/types.h>

namespace burnish {

/// d reflect(wo, h) / d sx and d sy at h ~ (sx, sy, 1).
struct DirectionSlopes {
    Vec3f x, y;
};
DirectionSlopes direction_slopes(const Vec3f& wo, float sx, float sy);

/// What a blur of directions by `sigma` rad about the mirror direction widens the slopes by, as the widths' squares:
/// 2 sigma^2 (J^T J)^-1. At most the squares of mx and my themselves where sigma is at most LobeImage::minor.
Vec2f widening(const Vec3f& wo, float sigma);

/// Standard deviations along both axes, rad, and the longer axis in slopes, one deviation long.
struct LobeImage {
    float major, minor;
    Vec2f axis;
};
LobeImage lobe_image(const Vec3f& wo, float mx, float my);

}  // namespace burnish
