// What patterns are tuned on: points under stress lights, with the radiance they should get.
#pragma once

#include <burnish/light/environment.h>
#include <burnish/sampling/tuned_patterns.h>
#include <burnish/shading/shading_point.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace burnish {

struct TrainingPoint {
    ShadingPoint point;
    float truth, albedo;  // reflected radiance; reflected radiance under constant light
    double importance;    // squared: the share of the picture the point stands for, relative to an equal choice
};

/// Points of one lobe under one light.
struct TrainingGroup {
    const Environment* light;
    LobeParameters lobe;
    std::vector<TrainingPoint> points;
    double scale;      // of errors: makes their squares sum to the mean square error relative to that of the light's reflection
    size_t first = 0;  // of its errors among all
};

/// `count` stress lights, seeds counted from `seed`; or the files, if any are named.
std::vector<Environment> training_lights(int count, uint32_t seed, const std::vector<std::string>& files);

class TrainingSet {
public:
    /// `points` on a sphere for every one of the lights, which must outlive the set, and every width m = sqrt(mx my).
    TrainingSet(LobeTail tail, float aspect, const std::vector<float>& widths, std::span<const Environment> lights, int points,
                uint32_t seed);

    size_t size() const { return m_points; }
    /// Relative errors of `pattern` at every point, as `regular` with the default level bias and an exact albedo correction makes them.
    std::vector<double> errors(const LobePattern& pattern) const;
    /// Divides every group's errors by those of the rule that is best at its width, so that no roughness outweighs another.
    void relate_to(const std::vector<LobePattern>& rules);
    /// Of `errors`, the root mean square at the width with this mx.
    double width_error(float mx, const std::vector<double>& errors) const;

private:
    void fill(TrainingGroup& group, int points, uint32_t seed) const;
    void group_errors(const TrainingGroup& group, const LobePattern& pattern, double* errors) const;

    size_t m_lights;
    std::vector<TrainingGroup> m_groups;
    size_t m_points = 0;
};

}  // namespace burnish
