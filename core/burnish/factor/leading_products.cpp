#include <burnish/factor/leading_products.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace burnish {
namespace {

using Eigen::MatrixXf;
using Eigen::VectorXf;

/// The u that fit the matrix best with these v; `values` and `known` have a row for each u.
template <class Values, class Known>
MatrixXf fitted(const Values& values, const Known& known, const MatrixXf& v) {
    constexpr float kRidge = 1e-3f;  // of what holes take away: rows of a few values alone are not to be fitted at any price
    constexpr float kSmallest = 1e-6f;
    const Eigen::Index terms = v.cols();
    MatrixXf squares(v.rows(), terms * terms);
    for (Eigen::Index a = 0; a < terms; ++a)
        for (Eigen::Index b = 0; b < terms; ++b) squares.col(a * terms + b) = v.col(a).cwiseProduct(v.col(b));
    const MatrixXf right = values * v, normal = known * squares;
    const VectorXf whole = squares.colwise().sum();
    const float whole_trace = Eigen::Map<const MatrixXf>(whole.data(), terms, terms).trace();
    MatrixXf u = MatrixXf::Zero(right.rows(), terms);
    for (Eigen::Index row = 0; row < u.rows(); ++row) {
        const VectorXf flat = normal.row(row);
        MatrixXf A = Eigen::Map<const MatrixXf>(flat.data(), terms, terms);
        const float trace = A.trace();
        if (!(trace > 0)) continue;
        A.diagonal().array() += kRidge * (whole_trace - trace) + kSmallest * trace;
        u.row(row) = A.ldlt().solve(right.row(row).transpose());
    }
    return u;
}

/// Columns unlike each other.
MatrixXf start(Eigen::Index rows, Eigen::Index terms) {
    constexpr double kGolden = 0.6180339887498949;
    MatrixXf v(rows, terms);
    for (Eigen::Index t = 0; t < terms; ++t)
        for (Eigen::Index row = 0; row < rows; ++row) {
            const double at = static_cast<double>(row * terms + t) * kGolden;
            v(row, t) = static_cast<float>(at - std::floor(at)) - (t == 0 ? 0.0f : 0.5f);
        }
    return v;
}

MatrixXf orthonormal(const MatrixXf& columns) {
    return Eigen::HouseholderQR<MatrixXf>(columns).householderQ() * MatrixXf::Identity(columns.rows(), columns.cols());
}

/// The same sum, as singular vectors of it.
Products in_singular_order(const MatrixXf& u, const MatrixXf& v) {
    const MatrixXf Qu = orthonormal(u), Qv = orthonormal(v);
    const MatrixXf core = (Qu.transpose() * u) * (Qv.transpose() * v).transpose();
    const Eigen::JacobiSVD<MatrixXf> svd(core, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const VectorXf strength = svd.singularValues().cwiseSqrt();
    return {Qu * svd.matrixU() * strength.asDiagonal(), Qv * svd.matrixV() * strength.asDiagonal()};
}

}  // namespace

Products least_squares_products(const HoledMatrix& matrix, int terms) {
    constexpr int kSweeps = 60;
    constexpr float kSettled = 1e-5f;
    MatrixXf v = orthonormal(start(matrix.values.cols(), terms)), u;
    VectorXf before = VectorXf::Zero(terms);
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        u = orthonormal(fitted(matrix.values, matrix.known, v));
        v = fitted(matrix.values.transpose(), matrix.known.transpose(), u);
        const VectorXf strength = v.colwise().norm();
        if ((strength - before).norm() <= kSettled * strength.norm()) break;
        before = strength;
        if (sweep + 1 < kSweeps) v = orthonormal(v);
    }
    return in_singular_order(u, v);
}

Products normalised_products(HoledMatrix matrix, int terms) {
    constexpr float kVanishing = 1e-12f;  // rows this much smaller than the largest tell nothing of the others
    Products products{MatrixXf::Zero(matrix.values.rows(), terms), MatrixXf::Zero(matrix.values.cols(), terms)};
    const VectorXf row_counts = matrix.known.rowwise().sum().cwiseMax(1), counts = matrix.known.colwise().sum().cwiseMax(1);
    for (int term = 0; term < terms; ++term) {
        VectorXf size = matrix.values.rowwise().lpNorm<1>().cwiseQuotient(row_counts);
        Eigen::Index largest = 0;
        size.maxCoeff(&largest);
        // What is left over has signs: rows that run against the largest one are taken as negative multiples of its kind.
        const VectorXf along = matrix.values * matrix.values.row(largest).transpose();
        const VectorXf u = (along.array() < 0).select(-size, size);
        const VectorXf inverse = (size.array() > kVanishing * size.maxCoeff()).select(u.cwiseInverse(), 0.0f);
        const VectorXf v = (matrix.values.transpose() * inverse).cwiseQuotient(counts);
        products.u.col(term) = u;
        products.v.col(term) = v;
        matrix.values -= matrix.known.cwiseProduct(u * v.transpose());
    }
    return products;
}

}  // namespace burnish
