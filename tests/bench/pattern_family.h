// One arrangement of orbits at a few widths, and its least-squares fit to lights.
//
// Residuals are the errors at the points of the training sets. Unknowns are places, shares and levels of all orbits at all widths;
// lobes in between take the interpolated pattern, so what lies between two widths is fitted as well.
#pragma once

#include "training_set.h"

namespace burnish {

/// Orbits at increasing widths, and between them.
class Family {
public:
    Family(std::vector<float> widths, std::vector<std::vector<Orbit>> orbits)
        : m_widths(std::move(widths)), m_orbits(std::move(orbits)) {}

    const std::vector<float>& widths() const { return m_widths; }
    std::vector<std::vector<Orbit>>& orbits() { return m_orbits; }
    const std::vector<std::vector<Orbit>>& orbits() const { return m_orbits; }

    /// The lower of the two widths that m lies between, and how far it lies from there to the other, in log m.
    std::pair<size_t, float> place(float m) const {
        size_t i = 0;
        while (i + 2 < m_widths.size() && m_widths[i + 1] <= m) ++i;
        if (m_widths.size() == 1) return {0, 0.0f};
        return {i, std::clamp(std::log(m / m_widths[i]) / std::log(m_widths[i + 1] / m_widths[i]), 0.0f, 1.0f)};
    }

    std::vector<Orbit> at(float m) const {
        const auto [i, part] = place(m);
        return between(m_orbits[i], m_orbits[std::min(i + 1, m_orbits.size() - 1)], part);
    }

private:
    std::vector<float> m_widths;
    std::vector<std::vector<Orbit>> m_orbits;
};

/// Mean square error relative to the best equally spaced pattern's, and the family that has it.
struct Fit {
    double cost;
    Family family;
};

using TrainingSets = std::vector<TrainingSet>;

/// From `start`, in at most so many iterations.
Fit fitted(const Family& start, LobeTail tail, const TrainingSets& sets, int iterations);

}  // namespace burnish
