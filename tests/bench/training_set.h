// What patterns are tuned on: points under lights, with the radiance they should get.
#pragma once

#include <burnish/light/environment.h>
#include <burnish/sampling/tuned_patterns.h>
#include <burnish/shading/shading_point.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace burnish {

struct TrainingPoint {
    ShadingPoint point;
    float truth, albedo;  // reflected radiance without the suns', which are no lookups' work; and that under constant light
    double importance;    // squared: the share of the picture the point stands for, relative to an equal choice
};

/// Points of one lobe under one light.
struct TrainingGroup {
    const Environment* light;
    float m;
    LobeParameters lobe;
    std::vector<TrainingPoint> points;
    double scale;      // of errors: makes their squares sum to the mean square error relative to that of the light's reflection
    size_t first = 0;  // of its errors among all
};

using MakeLight = std::function<Image(uint32_t seed)>;
/// `count` lights made in code, seeds counted from `seed`.
std::vector<Environment> made_lights(int count, uint32_t seed, const MakeLight& make);
std::vector<Environment> lights_from(const std::vector<std::string>& files);

/// The pattern for lobes with m = sqrt(mx my).
using PatternOf = std::function<LobePattern(float m)>;

class TrainingSet {
public:
    /// `points` on a sphere for every one of the lights, which must outlive the set, and every width m = sqrt(mx my).
    TrainingSet(LobeTail tail, float aspect, const std::vector<float>& widths, std::span<const Environment> lights, int points,
                uint32_t seed);

    size_t size() const { return m_points; }
    /// sqrt(mx my) at every point.
    std::vector<float> point_widths() const;
    /// Relative errors of a pattern at every point, as `regular` with the default level bias and an exact albedo correction makes them.
    std::vector<double> errors(const PatternOf& pattern_of) const;
    /// Divides every group's errors by those of the rule that is best at its width, so that no roughness outweighs another.
    void relate_to(const std::vector<LobePattern>& rules);
    /// Of `errors`, the root mean square at width m.
    double width_error(float m, const std::vector<double>& errors) const;

private:
    void fill(TrainingGroup& group, int points, uint32_t seed) const;
    void group_errors(const TrainingGroup& group, const LobePattern& pattern, double* errors) const;

    size_t m_lights;
    std::vector<TrainingGroup> m_groups;
    size_t m_points = 0;
};

}  // namespace burnish
