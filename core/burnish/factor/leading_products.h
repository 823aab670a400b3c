// A matrix with holes as a sum of a few products u v^T.
// Internal.
#pragma once

#include <Eigen/Core>

namespace burnish {

struct HoledMatrix {
    Eigen::MatrixXf values;        // 0 in holes
    const Eigen::MatrixXf& known;  // 1, and 0 in holes
};

/// One column a product.
struct Products {
    Eigen::MatrixXf u, v;
};

/// The products with the least sum of squares left over, strongest first, each shared out evenly between u and v: by alternating least
/// squares, which is subspace iteration towards the singular vectors where there are no holes.
Products least_squares_products(const HoledMatrix& matrix, int terms);

/// The normalised decomposition: u the mean size of each row, v the mean of rows divided by it, and again of what is left over.
Products normalised_products(HoledMatrix matrix, int terms);

}  // namespace burnish
