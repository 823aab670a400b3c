// The `reference` of a whole frame in stages: every stage carries each pixel's sequences on until they have so many lookups or meet
// the tolerance. What was summed up stays, so nothing is done twice and a stage that was cancelled may be begun again.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/shading/dense.h>
#include <burnish/shading/running_reference.h>

#include <vector>

namespace burnish {

class ReferenceRun {
public:
    /// Shades pixels of rule i with shaders[i], all of the estimator `reference`. The surfaces must outlive the run.
    ReferenceRun(const Surfaces& surfaces, const Assignment& assignment, std::vector<MaterialShader> shaders,
                 const EstimatorSettings& settings);

    /// Until every pixel has this many lookups a lobe (settings.max_samples at most), or settings.tolerance and lookups enough to
    /// believe it. Same bits for any thread count, however often it was cancelled. Throws Error(cancelled).
    void carry_on(int lookups, const Progress& progress);

    /// Whether no pixel would change any more.
    bool is_done() const;

    /// What is known by now, with standard errors and lookups.
    ShadedFrame frame() const;

private:
    /// The pixels of one rule, tile by tile, and what each has summed up.
    struct Part {
        std::vector<uint32_t> pixels;
        std::vector<RunningReference> running;
    };
    bool is_finished(const RunningReference& pixel, int points) const;
    void carry_on(size_t rule, size_t begin, size_t end, int points);
    int most_points(int lookups) const;

    const Surfaces& m_surfaces;
    int m_width, m_height;
    std::vector<MaterialShader> m_shaders;
    EstimatorSettings m_settings;
    std::vector<Part> m_parts;  // of each rule
};

}  // namespace burnish
