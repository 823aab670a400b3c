// Small least squares with linear bounds: the strengths and Fresnel numbers of a fit, once the shapes of its lobes are known.
//
// Internal. Bounds that hold are found by Hildreth's ascent on their multipliers; then the unknowns are solved for exactly on them.
#pragma once

#include <Eigen/Core>

namespace burnish {

/// |A x - b|^2 as the normal equations that are all that is left of it: x^T H x - 2 g^T x + c, subject to bounds x >= limits.
struct BoundedLeastSquares {
    Eigen::MatrixXd H;       // A^T A, positive semidefinite
    Eigen::VectorXd g;       // A^T b
    Eigen::MatrixXd bounds;  // a row each
    Eigen::VectorXd limits;
};

/// The x of least error; unknowns without influence are 0.
Eigen::VectorXd solve(const BoundedLeastSquares& problem);

}  // namespace burnish
