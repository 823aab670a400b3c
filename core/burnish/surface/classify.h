// The validity of every pixel of a frame, with the widest vectors the processor has: this runs over all pixels, however few of
// them are shaded.
#pragma once

#include <burnish/base/types.h>
#include <burnish/surface/validity.h>

#include <span>
#include <vector>

namespace burnish {

/// What pixels are judged by, from the first of them on.
struct PixelLayers {
    const float *position, *normal;  // three channels
    const float* depth;              // one channel; null where there is none
    const int16_t* rule;             // of the assignment
};

struct ClassifySettings {
    Vec3f eye;
    float min_normal_length;  // shorter normals are averaged ones
};

/// Pixels by validity, and valid ones by rule.
struct PixelCounts {
    ValidityCounts validity{};
    std::vector<size_t> rule;

    void operator+=(const PixelCounts& more) {
        for (size_t i = 0; i < validity.size(); ++i) validity[i] += more.validity[i];
        for (size_t i = 0; i < rule.size(); ++i) rule[i] += more.rule[i];
    }
};

/// Writes the validity of validity.size() pixels and adds to `counts`, whose `rule` has an entry for every rule. The same bits
/// on every processor.
void classify(const PixelLayers& layers, const ClassifySettings& settings, std::span<Validity> validity, PixelCounts& counts);

}  // namespace burnish
