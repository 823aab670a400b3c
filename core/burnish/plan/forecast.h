// What is expected of every configuration for one material under one light, from those that were measured there.
#pragma once

#include <burnish/plan/configuration.h>
#include <burnish/plan/error_model.h>
#include <burnish/plan/truth.h>

#include <map>

namespace burnish {

/// All in dB of display PSNR.
class Forecast {
public:
    explicit Forecast(const Material& material) : m_material(&material) {}

    /// What dense shading was found to reach; the first must be kProbe.
    void learn(const Configuration& configuration, double db) { m_measured[configuration] = db; }
    bool knows(const Configuration& configuration) const { return m_measured.contains(configuration); }
    /// What sparse shading at this safety, with a configuration that is known, was found to reach: moves the expectation at every
    /// safety.
    void learn_sparse(const Configuration& configuration, float safety, double db);

    /// What dense shading is expected to reach, or was found to. `caution`: deviations that are taken off.
    double dense(const Configuration& configuration, double caution) const;
    /// The same with sparse shading on top; safety 0 = dense.
    double total(const Configuration& configuration, float safety, double caution) const;

private:
    PredictedGain gain(const Configuration& configuration) const;
    const Configuration* nearest_of_family(const Configuration& configuration) const;

    const Material* m_material;
    std::map<Configuration, double> m_measured;
    double m_sparse_shift = 0;
};

/// Of a sum of independent errors.
double joint_db(double a, double b);

}  // namespace burnish
