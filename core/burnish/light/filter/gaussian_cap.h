// The texels under a Gaussian: a cap of directions, cut into the rows of cube faces, with weights Omega_i exp(-(1 - cos) / s^2).
#pragma once

#include <burnish/base/types.h>
#include <burnish/light/filter/gaussian_width.h>

#include <array>
#include <span>
#include <vector>

namespace burnish {

/// Of the texels of a face, 1 / sqrt(1 + u^2 + v^2) at their centres, row by row: they are all the weights' square roots.
std::vector<float> texel_cosines(int size);

/// Inclusive; empty when last < first.
struct TexelRange {
    int first, last;
};

/// The cap around d where the Gaussian is more than 4e-3 of its peak; d is a unit vector along (forward, right, up) of
/// whichever face is asked about, with `size` texels a side.
class GaussianCap {
public:
    /// The weights' mean versine is `versine`.
    GaussianCap(double versine, int size);

    /// Whether the cap is less than 18 degrees wide each side: then rows and columns are exact, else whole faces.
    bool small() const { return m_small; }
    bool on_the_face(const Vec3f& d) const;
    /// Rows that hold texel centres in the cap.
    TexelRange rows(const Vec3f& d) const;
    /// Columns of a row that do.
    TexelRange columns(const Vec3f& d, int row) const;
    /// The weights of columns `range` of a row, 0 outside the cap; `cosines` are the face's.
    void weigh(const Vec3f& d, int row, const TexelRange& range, std::span<const float> cosines, float* weights) const;

private:
    double along(int i) const { return (2.0 * i + 1.0) / m_size - 1.0; }
    std::array<double, 2> extent(double forward, double other) const;
    TexelRange texels(double low, double high) const;

    double m_variance, m_reach, m_sine2;
    bool m_small;
    int m_size;
};

}  // namespace burnish
