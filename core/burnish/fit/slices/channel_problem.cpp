#include <burnish/fit/slices/channel_problem.h>

#include <burnish/fit/slices/bounded_least_squares.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace burnish {

namespace {

constexpr double kInversePi = std::numbers::inv_pi;

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Rows of bounds over (kd, a, b, e, a, b, e, ...) or (kd, a, a, ...).
class BoundRows {
public:
    BoundRows(int lobes, int terms) : m_terms(terms), m_unknowns(1 + lobes * terms) {}

    void add(int lobe, double a, double b, double e, double limit) {
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(m_unknowns);
        row[1 + lobe * m_terms] = a;
        if (m_terms == 3) row[2 + lobe * m_terms] = b, row[3 + lobe * m_terms] = e;
        push(row, limit);
    }
    void add_kd(double sign, double limit) {
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(m_unknowns);
        row[0] = sign;
        push(row, limit);
    }
    void write(BoundedLeastSquares& problem) const {
        problem.bounds.resize(static_cast<Eigen::Index>(m_rows.size()), m_unknowns);
        problem.limits.resize(static_cast<Eigen::Index>(m_rows.size()));
        for (size_t i = 0; i < m_rows.size(); ++i) {
            problem.bounds.row(static_cast<Eigen::Index>(i)) = m_rows[i];
            problem.limits[static_cast<Eigen::Index>(i)] = m_limits[i];
        }
    }

private:
    void push(const Eigen::RowVectorXd& row, double limit) { m_rows.push_back(row), m_limits.push_back(limit); }

    int m_terms, m_unknowns;
    std::vector<Eigen::RowVectorXd> m_rows;
    std::vector<double> m_limits;
};

/// Strength, f0 and f1 in their ranges.
void add_lobe(BoundRows& rows, int lobe, const LinearBounds& bounds, double unit) {
    rows.add(lobe, 1, 0, 1, bounds.ks.min * unit);
    rows.add(lobe, -1, 0, -1, -bounds.ks.max * unit);
    rows.add(lobe, 1 - bounds.f0.min, 0, -bounds.f0.min, 0);
    rows.add(lobe, bounds.f0.max - 1, 0, bounds.f0.max, 0);
    rows.add(lobe, -bounds.f1.min, -1, -bounds.f1.min, 0);
    rows.add(lobe, bounds.f1.max, 1, bounds.f1.max, 0);
}

}  // namespace

ChannelProblem::ChannelProblem(const BrdfGrid& grid, int channel, Weighing weighing, FresnelTerms terms)
    : m_shapes(grid), m_terms(terms) {
    constexpr double kFloor = 0.01;  // of the median: below it, measurements are noise
    const std::vector<double>& f = grid.f(channel);
    const double floor = std::max(kFloor * median(f), 1e-12);
    for (size_t j = 0; j < f.size(); ++j) {
        const BrdfGrid::Cell& cell = grid.cells()[j];
        const double c = std::cos(grid.theta_d(cell.d));
        m_weight.push_back(weighing == Weighing::error ? std::sqrt(cell.weight) : 1 / std::max(f[j], floor));
        m_target.push_back(f[j] * m_weight.back());
        m_cosine.push_back(c);
        m_schlick.push_back(std::pow(1 - c, 5));
    }
}

ChannelFit ChannelProblem::fit(const ShapeFamily& family, std::span<const std::vector<double>> shapes,
                               const LinearBounds& bounds, std::vector<double>* residuals) const {
    constexpr int kRounds = 4;
    const int lobes = static_cast<int>(shapes.size());
    const Eigen::Map<const Eigen::VectorXd> target(m_target.data(), cells());
    const Eigen::MatrixXd all = columns(family, shapes);
    BoundRows rows(lobes, terms());
    rows.add_kd(1, bounds.kd.min), rows.add_kd(-1, -bounds.kd.max);
    for (int lobe = 0; lobe < lobes; ++lobe) {
        const double unit = bounds.ks_unit ? bounds.ks_unit(shapes[static_cast<size_t>(lobe)]) : 1;
        m_terms == FresnelTerms::bent ? add_lobe(rows, lobe, bounds, unit) : rows.add(lobe, 1, 0, 0, 0);
    }
    // Reflectance is not below 0: where it would be, the lobe is taken out and the rest solved for again, until that settles.
    Eigen::MatrixXd A = all;
    Eigen::VectorXd x, left;
    ChannelFit best{0, {}, std::numeric_limits<double>::infinity()};
    for (int round = 0; round < kRounds; ++round) {
        BoundedLeastSquares problem{A.transpose() * A, A.transpose() * target, {}, {}};
        rows.write(problem);
        x = solve(problem);
        Eigen::MatrixXd lit = all;
        const bool dark = darken(x, lit);
        left = target - lit * x;
        if (left.squaredNorm() < best.cost) {
            best = to_fit(x, shapes);
            best.cost = left.squaredNorm();
            if (residuals) residuals->assign(left.begin(), left.end());
        }
        if (m_terms == FresnelTerms::constant || (round == 0 && !dark) || lit == A) break;
        A = std::move(lit);
    }
    return best;
}

Eigen::MatrixXd ChannelProblem::columns(const ShapeFamily& family, std::span<const std::vector<double>> shapes) const {
    const Eigen::Map<const Eigen::ArrayXd> weight(m_weight.data(), cells()), cosine(m_cosine.data(), cells()),
        schlick(m_schlick.data(), cells());
    Eigen::MatrixXd A(cells(), 1 + static_cast<int>(shapes.size()) * terms());
    A.col(0) = weight * kInversePi;
    std::vector<double> S;
    Eigen::Index column = 1;
    for (const auto& shape : shapes) {
        m_shapes.evaluate(family, shape, S);
        A.col(column) = Eigen::Map<const Eigen::ArrayXd>(S.data(), cells()) * weight;
        if (m_terms == FresnelTerms::bent) {
            A.col(column + 1) = A.col(column).array() * cosine;
            A.col(column + 2) = A.col(column).array() * schlick;
        }
        column += terms();
    }
    return A;
}

bool ChannelProblem::darken(const Eigen::VectorXd& x, Eigen::MatrixXd& columns) const {
    if (m_terms == FresnelTerms::constant) return false;
    bool any = false;
    for (Eigen::Index lobe = 1; lobe < x.size(); lobe += terms())
        for (Eigen::Index j = 0; j < columns.rows(); ++j) {
            const auto k = static_cast<size_t>(j);
            if (x[lobe] + x[lobe + 1] * m_cosine[k] + x[lobe + 2] * m_schlick[k] >= 0) continue;
            columns.row(j).segment(lobe, terms()).setZero();
            any = true;
        }
    return any;
}

ChannelFit ChannelProblem::to_fit(const Eigen::VectorXd& x, std::span<const std::vector<double>> shapes) const {
    ChannelFit fit{std::max(x[0], 0.0), {}, 0};
    Eigen::Index column = 1;
    for (const auto& shape : shapes) {
        const bool bent = m_terms == FresnelTerms::bent;
        fit.lobes.push_back({shape, x[column], bent ? x[column + 1] : 0, bent ? x[column + 2] : 0});
        column += terms();
    }
    return fit;
}

double ChannelProblem::cost(const ShapeFamily& family, const ChannelFit& fit) const {
    std::vector<double> left = m_target, S;
    for (size_t j = 0; j < left.size(); ++j) left[j] -= m_weight[j] * fit.kd * kInversePi;
    for (const LobeFit& lobe : fit.lobes) {
        m_shapes.evaluate(family, lobe.shape, S);
        for (size_t j = 0; j < left.size(); ++j)
            left[j] -= m_weight[j] * S[j] * std::max(0.0, lobe.a + lobe.b * m_cosine[j] + lobe.e * m_schlick[j]);
    }
    return std::inner_product(left.begin(), left.end(), left.begin(), 0.0);
}

}  // namespace burnish
