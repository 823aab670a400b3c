// Widths of kernels on the sphere, by their mean versine 1 - E[cos]: cosines multiply where kernels are convolved.
//
// A spherical Gaussian exp((cos - 1) / sigma^2) has the mean versine 1 - coth k + 1 / k, k = 1 / sigma^2, which is sigma^2
// where it is narrow. A texel of a cube face, h wide on the cube [-1, 1]^3, seen at a place with q = 1 / (1 + u^2 + v^2), has
// the variance h^2 q^2 towards the face's centre and h^2 q across, each times 1/12 (its area) or 1/6 (the tent of a bilinear
// lookup).
#pragma once

namespace burnish {

/// Mean versine of the spherical Gaussian, in [0, 1).
double versine_of_sigma(double sigma);
/// The inverse, for versines in [0, 1).
double sigma_of_versine(double versine);

/// How many h^2 a texel's mean variance is, at a place with this q.
inline double texel_metric(double q) { return 0.5 * (q + q * q); }
/// Its mean over the sphere.
inline constexpr double kMeanTexelMetric = 0.60972;

/// What a blur from one cube level to another must account for; the tent of lookups in the new level is taken off here.
struct GaussianBlur {
    double target;      // versine that lookups of the new level shall have
    double source;      // versine of what is blurred
    double texel_area;  // h^2 / 12 of the source where its texels stand for their areas, else 0

    /// Versine of the kernel to apply at a place, for a new level of `size`.
    double kernel_versine(double q, int size) const {
        const double tent = 4.0 / (6.0 * size * size);
        return 1.0 - (1.0 - target) / ((1.0 - source) * (1.0 - (tent + texel_area) * texel_metric(q)));
    }
};

}  // namespace burnish
