#include <burnish/fit/search/absolute_fit.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr int kMaxEdges = 40;  // some five are the rule

class Descent {
public:
    Descent(const AbsoluteProblem& problem, AbsoluteScratch& scratch) : m_problem(problem), m_scratch(scratch) {
        m_scratch.residual.resize(problem.target.size());
        m_scratch.direction.resize(problem.target.size());
    }

    /// The least error over the line `from` + x (ds, dt), x in [low, high]; `index`: the sample that became exact.
    AbsoluteFit along(const AbsoluteFit& from, float ds, float dt, float low, float high, int* index = nullptr) {
        const auto& [target, a, b, weight] = m_problem;
        for (size_t j = 0; j < target.size(); ++j) {
            m_scratch.residual[j] = target[j] - from.first * a[j] - from.second * b[j];
            m_scratch.direction[j] = ds * a[j] + dt * b[j];
        }
        const WeightedValue best = scale_to(m_scratch.residual, m_scratch.direction, weight, m_scratch.quotients);
        const float x = std::clamp(best.value, low, high);
        if (index) *index = best.index;
        return with_error({from.first + x * ds, from.second + x * dt});
    }

    AbsoluteFit with_error(AbsoluteFit fit) const {
        const auto& [target, a, b, weight] = m_problem;
        fit.error = 0;
        for (size_t j = 0; j < target.size(); ++j)
            fit.error += weight[j] * std::abs(target[j] - fit.first * a[j] - fit.second * b[j]);
        return fit;
    }

    /// The minimum, whatever the signs.
    AbsoluteFit unbounded() {
        int exact = -1;
        AbsoluteFit best = along({}, 1, 0, -kAnything, kAnything, &exact);
        for (int edge = 0; edge < kMaxEdges && exact >= 0; ++edge) {
            const size_t j = static_cast<size_t>(exact);
            const float a = m_problem.first[j], b = m_problem.second[j], length = std::hypot(a, b);
            const AbsoluteFit next = along(best, b / length, -a / length, -kAnything, kAnything, &exact);
            if (!(next.error < best.error * (1 - kSame))) break;
            best = next;
        }
        return best;
    }

    static constexpr float kAnything = 1e20f;

private:
    static constexpr double kSame = 1e-7;

    const AbsoluteProblem& m_problem;
    AbsoluteScratch& m_scratch;
};

}  // namespace

AbsoluteFit fit_absolute(const AbsoluteProblem& problem, float min_sum, float max_sum, AbsoluteScratch& scratch) {
    Descent descent(problem, scratch);
    AbsoluteFit best = descent.unbounded();
    // Outside the allowed wedge, the least error of a convex function lies on the border that the way in crosses.
    if (best.first < 0 || best.second < 0) {
        const AbsoluteFit first = descent.along({}, 1, 0, 0, Descent::kAnything);
        const AbsoluteFit second = descent.along({}, 0, 1, 0, Descent::kAnything);
        best = first.error <= second.error ? first : second;
    }
    const float sum = best.first + best.second, allowed = std::clamp(sum, min_sum, max_sum);
    return sum == allowed ? best : descent.along({allowed, 0}, -1, 1, 0, allowed);
}

}  // namespace burnish
