// Resection: the projective camera that sees given world points at given image points, by direct linear transform.
//
//     w (u, v, 1)^T = M (x - c),   M 3x3, c the centre
//
// Two linear equations per pair, eleven unknowns, so six pairs that are not all on one plane determine it. Source: Hartley
// and Zisserman, Multiple View Geometry, 7.1 (normalised DLT); Rousseeuw 1984 (least median of squares) for the robust start.
#pragma once

#include <burnish/base/types.h>

#include <vector>

namespace burnish {

struct Resection {
    Imath::V3d centre{0, 0, 0};
    Imath::V3d ray_u, ray_v, ray_0;  // columns of M^-1: x - centre ~ ray_0 + u ray_u + v ray_v, towards the points
    double residual = 0;             // median distance in the image, in the unit of `image`
    double inliers = 0;              // share of the pairs that agree, [0, 1]
    double centre_error = 0;         // predicted standard deviation of `centre`, over the median distance to the points;
                                     // infinite when the points do not determine a centre
};

/// Fits a camera to pairs of image and world points, of which up to half may be wrong. `tolerance` is the distance in the
/// image that a good pair may be off. Deterministic. Needs at least 12 pairs.
Resection resect(const std::vector<Imath::V2d>& image, const std::vector<Imath::V3d>& world, double tolerance);

}  // namespace burnish
