// One channel of a measurement as a least squares problem in which only the lobes' shapes are searched.
//
//     f = kd / pi + sum over lobes S (a + b c + e (1 - c)^5),   c = cos(theta_d)
//
// With S known, kd and the lobes' (a, b, e) follow from a small linear problem with bounds: strength ks = a + e and generalised
// Schlick (eq. V.5) f0 = a / ks, f1 = -b / ks, which is F(pi/2) = 1 of Bandwidth V.4.2. Searching only the shapes is variable
// projection (Golub & Pereyra 1973): two numbers a lobe instead of six, and no start to be guessed for the rest. Internal.
#pragma once

#include <burnish/base/json_fields.h>
#include <burnish/fit/slices/lobe_shape.h>

#include <Eigen/Core>

namespace burnish {

/// Ranges of the linear numbers.
struct LinearBounds {
    NumberRange kd{0, 1}, ks{0, 1e30}, f0{-20, 20}, f1{-20, 20};
    std::function<double(Shape shape)> ks_unit;  // what a + e is for ks = 1; none: 1
};

struct LobeFit {
    std::vector<double> shape;  // in the order of ShapeFamily::parameters
    double a = 0, b = 0, e = 0;

    double ks() const { return a + e; }
};

struct ChannelFit {
    double kd = 0;
    std::vector<LobeFit> lobes;
    double cost = 0;  // sum of the squared residuals of the problem it was fitted to
};

/// What the sum of squares weighs cells with: their share of the error of V.5.3, or evenly and in ratio to f.
enum class Weighing { error, ratio };
/// Which Fresnel numbers there are to be found: one reflectance, as on a slice of constant theta_d, or all three.
enum class FresnelTerms { constant, bent };

class ChannelProblem {
public:
    ChannelProblem(const BrdfGrid& grid, int channel, Weighing weighing, FresnelTerms terms);

    /// The best linear numbers for lobes of these shapes; weighted f - model of every cell where asked for.
    ChannelFit fit(const ShapeFamily& family, std::span<const std::vector<double>> shapes, const LinearBounds& bounds,
                   std::vector<double>* residuals = nullptr) const;
    /// Sum of the squared residuals of numbers found elsewhere.
    double cost(const ShapeFamily& family, const ChannelFit& fit) const;

private:
    Eigen::Index cells() const { return static_cast<Eigen::Index>(m_target.size()); }
    /// Weighted values of what the linear numbers multiply: 1 / pi, then S, S c, S (1 - c)^5 of each lobe.
    Eigen::MatrixXd columns(const ShapeFamily& family, std::span<const std::vector<double>> shapes) const;
    /// Zeroes the columns of lobes where x makes their reflectance negative; whether there are such.
    bool darken(const Eigen::VectorXd& x, Eigen::MatrixXd& columns) const;
    ChannelFit to_fit(const Eigen::VectorXd& x, std::span<const std::vector<double>> shapes) const;
    int terms() const { return m_terms == FresnelTerms::bent ? 3 : 1; }

    ShapeGrid m_shapes;
    FresnelTerms m_terms;
    std::vector<double> m_weight, m_target;   // square root of the weight, f times it
    std::vector<double> m_cosine, m_schlick;  // cos(theta_d), (1 - cos(theta_d))^5
};

}  // namespace burnish
