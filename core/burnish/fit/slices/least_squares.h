// Levenberg-Marquardt over numbers that each stay in a range: x = min + (max - min) (1 + sin t) / 2, in logarithms where asked for.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace burnish {

/// Where a number may be; a range without extent fixes it.
struct SearchRange {
    double min, max;
    bool logarithmic = false;

    bool is_fixed() const { return !(max > min); }
    /// The point `share` of the way through, share in [0, 1].
    double at(double share) const;
    double share_of(double value) const;
};

/// Writes the residuals of `numbers`, always as many.
using Residuals = std::function<void(std::span<const double> numbers, std::vector<double>& residuals)>;

/// The numbers at the bottom of the valley of sum residual^2 that `start` lies in; derivatives by differences.
std::vector<double> least_squares(std::span<const SearchRange> ranges, std::vector<double> start, const Residuals& residuals);

}  // namespace burnish
