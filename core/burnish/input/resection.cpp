#include <burnish/input/median.h>
#include <burnish/input/resection.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace burnish {
namespace {

using Projection = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;
using Vector12 = Eigen::Matrix<double, 12, 1>;
using Equation = Eigen::Matrix<double, 1, 12>;

constexpr int kHypotheses = 256;  // six pairs each: with 40 % wrong pairs one of them is clean, but for 1 in 100 000
constexpr size_t kJudges = 300;   // pairs each hypothesis is judged by
constexpr int kRefinements = 8;
constexpr size_t kFewest = 12;        // pairs for least squares
constexpr double kSigma = 1.4826;     // median of absolute deviations -> standard deviation of a normal distribution
constexpr double kFloatNoise = 1e-7;  // of positions, relative: no fit is trusted to be better than this
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Moves points so that the median is the origin and the median distance 1; wrong points cannot pull these.
template <typename V>
struct Normaliser {
    V origin;
    double scale = 1;

    explicit Normaliser(const std::vector<V>& points) {
        std::vector<double> values(points.size());
        for (unsigned axis = 0; axis < V::dimensions(); ++axis) {
            std::transform(points.begin(), points.end(), values.begin(), [axis](const V& p) { return p[axis]; });
            origin[axis] = median(values);
        }
        std::transform(points.begin(), points.end(), values.begin(), [this](const V& p) { return (p - origin).length(); });
        if (const double distance = median(values); distance > 0) scale = distance;
    }
    V operator()(const V& p) const { return (p - origin) / scale; }
};

/// The pairs in normalised coordinates.
struct Pairs {
    std::vector<Imath::V2d> u;
    std::vector<Imath::V3d> x;
    size_t size() const { return u.size(); }
};

Eigen::Vector4d homogeneous(const Imath::V3d& x) { return {x.x, x.y, x.z, 1}; }

/// The two equations of a pair: (p_row - u_row p_2) . (x, 1) = 0 for rows 0 and 1.
Equation equation(const Pairs& pairs, size_t i, int row) {
    Equation e = Equation::Zero();
    const Eigen::RowVector4d x = homogeneous(pairs.x[i]).transpose();
    e.segment<4>(4 * row) = x;
    e.segment<4>(8) = -pairs.u[i][static_cast<unsigned>(row)] * x;
    return e;
}

/// The projection through six pairs: the null vector of the first eleven of their twelve equations.
Projection through_six(const Pairs& pairs, const std::array<size_t, 6>& six) {
    Eigen::Matrix<double, 12, 11> transposed;
    for (int k = 0; k < 11; ++k) transposed.col(k) = equation(pairs, six[static_cast<size_t>(k / 2)], k % 2).transpose();
    const Vector12 p = Eigen::HouseholderQR<Eigen::Matrix<double, 12, 11>>(transposed).householderQ() * Vector12::Unit(11);
    return Eigen::Map<const Projection>(p.data());
}

/// Distance in the image; infinite on the other side of the camera than `front` says.
double residual(const Projection& p, const Pairs& pairs, size_t i, double front) {
    const Eigen::Vector3d q = p * homogeneous(pairs.x[i]);
    if (!(q[2] * front > 0)) return kInfinity;
    return std::hypot(q[0] / q[2] - pairs.u[i].x, q[1] / q[2] - pairs.u[i].y);
}

/// +1 when most points have positive w, else -1.
double front_side(const Projection& p, const Pairs& pairs) {
    size_t positive = 0;
    for (const Imath::V3d& x : pairs.x) positive += p.row(2).dot(homogeneous(x)) > 0;
    return 2 * positive >= pairs.size() ? 1.0 : -1.0;
}

std::vector<double> residuals(const Projection& p, const Pairs& pairs) {
    const double front = front_side(p, pairs);
    std::vector<double> r(pairs.size());
    for (size_t i = 0; i < r.size(); ++i) r[i] = residual(p, pairs, i, front);
    return r;
}

/// Best of many six-pair hypotheses. The smallest median gives the noise; then the sum of capped squares decides, so that
/// a hypothesis from one plane, which fits all of that plane, loses to one that also fits what stands on it.
Projection robust_start(const Pairs& pairs, double tolerance) {
    std::mt19937 random(1);
    std::vector<Projection> hypotheses(kHypotheses);
    std::vector<std::vector<double>> judged(kHypotheses);
    Pairs judges;
    for (size_t k = 0, n = std::min(kJudges, pairs.size()); k < n; ++k) {
        judges.u.push_back(pairs.u[k * pairs.size() / n]);
        judges.x.push_back(pairs.x[k * pairs.size() / n]);
    }
    double smallest = kInfinity;
    for (size_t h = 0; h < kHypotheses; ++h) {
        std::array<size_t, 6> six;
        for (size_t& i : six) i = random() % pairs.size();
        hypotheses[h] = through_six(pairs, six);
        judged[h] = residuals(hypotheses[h], judges);
        smallest = std::min(smallest, median(judged[h]));
    }
    const double cap = std::max(3 * kSigma * smallest, tolerance);
    size_t best = 0;
    double least = kInfinity;
    for (size_t h = 0; h < kHypotheses; ++h) {
        double sum = 0;
        for (double r : judged[h]) sum += std::min(r * r, cap * cap);
        if (sum < least) least = sum, best = h;
    }
    return hypotheses[best];
}

/// Least squares over the chosen pairs, each equation divided by the previous w so that it measures distance in the image.
struct LeastSquares {
    Eigen::JacobiSVD<Eigen::Matrix<double, 12, 12>> svd;
    size_t count = 0;

    LeastSquares(const Pairs& pairs, const std::vector<size_t>& chosen, const Projection& previous) : count(chosen.size()) {
        Eigen::Matrix<double, Eigen::Dynamic, 12> a(2 * static_cast<Eigen::Index>(count), 12);
        for (size_t k = 0; k < count; ++k) {
            const double w = previous.row(2).dot(homogeneous(pairs.x[chosen[k]]));
            for (int row = 0; row < 2; ++row)
                a.row(2 * static_cast<Eigen::Index>(k) + row) = equation(pairs, chosen[k], row) / w;
        }
        const Eigen::Matrix<double, 12, 12> r =
            Eigen::HouseholderQR<Eigen::Ref<decltype(a)>>(a).matrixQR().topRows<12>().template triangularView<Eigen::Upper>();
        svd.compute(r, Eigen::ComputeFullV);
    }
    Projection projection() const {
        const Vector12 p = svd.matrixV().col(11);
        return Eigen::Map<const Projection>(p.data());
    }
};

Eigen::Vector3d centre_of(const Projection& p) { return -p.leftCols<3>().fullPivLu().solve(p.col(3)); }

/// Standard deviation of the centre c: dc = -M^-1 dp (c, 1), with cov(p) = s^2 sum_i v_i v_i^T / sigma_i^2 over all singular
/// vectors but the solution. Points on one plane leave four small sigma_i, an orthographic view a nearly singular M.
double centre_deviation(const LeastSquares& fit, const Projection& p, double noise) {
    const Eigen::Vector3d c = centre_of(p);
    const Eigen::Vector4d c1(c[0], c[1], c[2], 1);
    const Eigen::Matrix3d inverse = p.leftCols<3>().inverse();
    double variance = 0;
    for (int i = 0; i < 11; ++i) {
        const Vector12 v = fit.svd.matrixV().col(i);
        const Eigen::Vector3d dc = inverse * (Eigen::Map<const Projection>(v.data()) * c1);
        const double sigma = fit.svd.singularValues()[i];
        variance += dc.squaredNorm() * noise * noise / (sigma * sigma);
    }
    return std::isfinite(variance) ? std::sqrt(variance) : kInfinity;
}

double median_distance(const Pairs& pairs, const std::vector<size_t>& chosen, const Eigen::Vector3d& c) {
    std::vector<double> distances;
    for (size_t i : chosen) distances.push_back((pairs.x[i] - Imath::V3d(c[0], c[1], c[2])).length());
    return median(distances);
}

/// A projection, the pairs that agree with it, and how well its centre is known.
struct Fit {
    Projection p;
    std::vector<size_t> inliers;
    std::vector<double> residuals;
    double centre_error = kInfinity;
};

std::vector<size_t> within(const std::vector<double>& residuals, double reach) {
    std::vector<size_t> chosen;
    for (size_t i = 0; i < residuals.size(); ++i)
        if (residuals[i] <= reach) chosen.push_back(i);
    return chosen;
}

/// Least squares and the choice of inliers in turn, until the choice stays. `rounding` bounds the noise from below.
Fit refine(const Pairs& pairs, const Projection& start, double tolerance, double rounding) {
    Fit fit{start, {}, residuals(start, pairs)};
    std::vector<size_t> chosen = within(fit.residuals, 4 * std::max(kSigma * median(fit.residuals), tolerance));
    for (int round = 0; round < kRefinements && chosen.size() >= kFewest && chosen != fit.inliers; ++round) {
        const LeastSquares squares(pairs, chosen, fit.p);
        fit.p = squares.projection();
        fit.residuals = residuals(fit.p, pairs);
        fit.inliers = chosen;
        const double noise = kSigma * median(fit.residuals);
        const double distance = median_distance(pairs, chosen, centre_of(fit.p));
        fit.centre_error = centre_deviation(squares, fit.p, std::max(noise, rounding)) / distance;
        chosen = within(fit.residuals, std::max(3 * noise, tolerance));
    }
    return fit;
}

Imath::V3d to_imath(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

}  // namespace

Resection resect(const std::vector<Imath::V2d>& image, const std::vector<Imath::V3d>& world, double tolerance) {
    const Normaliser<Imath::V2d> to_u(image);
    const Normaliser<Imath::V3d> to_x(world);
    Pairs pairs;
    std::transform(image.begin(), image.end(), std::back_inserter(pairs.u), to_u);
    std::transform(world.begin(), world.end(), std::back_inserter(pairs.x), to_x);

    const double reach = tolerance / to_u.scale;
    const double rounding = kFloatNoise * (1 + to_x.origin.length() / to_x.scale);
    const Fit fit = refine(pairs, robust_start(pairs, reach), reach, rounding);

    const Eigen::Matrix3d rays = (fit.p.leftCols<3>() * front_side(fit.p, pairs)).inverse();
    Resection result;
    result.centre = to_imath(centre_of(fit.p)) * to_x.scale + to_x.origin;
    result.ray_u = to_imath(rays.col(0)) / to_u.scale;
    result.ray_v = to_imath(rays.col(1)) / to_u.scale;
    result.ray_0 = to_imath(rays.col(2)) - result.ray_u * to_u.origin.x - result.ray_v * to_u.origin.y;
    result.residual = median(fit.residuals) * to_u.scale;
    result.inliers = static_cast<double>(fit.inliers.size()) / static_cast<double>(pairs.size());
    result.centre_error = fit.centre_error;
    return result;
}

}  // namespace burnish
