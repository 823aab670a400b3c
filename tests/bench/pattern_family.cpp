#include "pattern_family.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

/// The unknowns of a family, one width after the other: logarithms of what must stay positive, and levels.
std::vector<double> unknowns(const Family& family) {
    std::vector<double> x;
    for (const std::vector<Orbit>& orbits : family.orbits())
        for (const Orbit& orbit : orbits) {
            if (orbit.u > 0) x.push_back(std::log(orbit.u));
            if (orbit.v > 0) x.push_back(std::log(orbit.v));
            x.push_back(std::log(orbit.share)), x.push_back(orbit.level);
        }
    return x;
}

Family with_unknowns(Family family, const double* x) {
    for (std::vector<Orbit>& orbits : family.orbits())
        for (Orbit& orbit : orbits) {
            if (orbit.u > 0) orbit.u = static_cast<float>(std::exp(*x++));
            if (orbit.v > 0) orbit.v = static_cast<float>(std::exp(*x++));
            orbit.share = static_cast<float>(std::exp(*x++)), orbit.level = static_cast<float>(*x++);
        }
    return family;
}

/// Errors of a family and their differences with its unknowns.
class FamilyErrors : public ceres::CostFunction {
public:
    FamilyErrors(const Family& family, LobeTail tail, const TrainingSet& training)
        : m_family(family), m_tail(tail), m_training(training), m_point_widths(training.point_widths()) {
        set_num_residuals(static_cast<int>(training.size()));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(unknowns(family).size()));
    }

    bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
        const int count = parameter_block_sizes()[0], per_width = count / static_cast<int>(m_family.widths().size());
        std::vector<double> x(parameters[0], parameters[0] + count);
        const std::vector<double> here = errors(x);
        std::ranges::copy(here, residuals);
        if (!jacobians || !jacobians[0]) return true;
        std::fill_n(jacobians[0], here.size() * count, 0.0);
        for (int k = 0; k < per_width; ++k) {  // a step at all widths at once is a step of what lies between them
            std::vector<double> stepped = x;
            for (int i = k; i < count; i += per_width) stepped[i] += kStep;
            const std::vector<double> there = errors(stepped);
            for (size_t i = 0; i < here.size(); ++i) {
                const auto [low, part] = m_family.place(m_point_widths[i]);
                double* row = jacobians[0] + i * count + low * per_width + k;
                row[0] = (1 - part) * (there[i] - here[i]) / kStep;
                if (part > 0) row[per_width] = part * (there[i] - here[i]) / kStep;
            }
        }
        return true;
    }

private:
    static constexpr double kStep = 0.02;  // wide enough to see past the kinks of trilinear lookups

    std::vector<double> errors(const std::vector<double>& x) const {
        const Family family = with_unknowns(m_family, x.data());
        return m_training.errors([&](float m) { return unfolded(family.at(m), m_tail); });
    }

    const Family& m_family;
    LobeTail m_tail;
    const TrainingSet& m_training;
    std::vector<float> m_point_widths;
};

}  // namespace

Fit fitted(const Family& start, LobeTail tail, const TrainingSets& sets, int iterations) {
    std::vector<double> x = unknowns(start);
    ceres::Problem problem;
    for (const TrainingSet& set : sets) problem.AddResidualBlock(new FamilyErrors(start, tail, set), nullptr, x.data());
    ceres::Solver::Options options;
    options.max_num_iterations = iterations, options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
    options.function_tolerance = 1e-4, options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return {2 * summary.final_cost / static_cast<double>(sets.size()), with_unknowns(start, x.data())};
}

}  // namespace burnish
