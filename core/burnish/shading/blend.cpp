#include <burnish/shading/blend.h>

#include <burnish/base/parallel.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kReach = 3;         // pixels around that tell the error
constexpr float kFloor = 0.1f;    // of the mean square of the light around: so dark a pixel says nothing relative to itself
constexpr float kBlack = 1e-20f;  // squared radiance, against division by 0

float luminance_at(const Image& rgb, size_t pixel) {
    const float* c = rgb.at(pixel);
    return luminance(Color3f(c[0], c[1], c[2]));
}

class Blender {
public:
    Blender(const ShadedFrame& filtered, const ShadedFrame& reference, const Surfaces& surfaces, const Assignment& assignment)
        : m_filtered(filtered.overlay),
          m_reference(reference.overlay),
          m_error(reference.standard_error),
          m_surfaces(surfaces),
          m_assignment(assignment) {}

    /// Squared error of the filtered picture at a valid pixel.
    float squared_bias(int x, int y) const {
        const float floor =
            kFloor * mean_around(x, y, [this](size_t i) { return square(luminance_at(m_filtered, i)); }) + kBlack;
        const float excess = mean_around(x, y, [&](size_t i) {
            const float shown = luminance_at(m_filtered, i), d = luminance_at(m_reference, i) - shown;
            return (square(d) - square(*m_error.at(i))) / (square(shown) + floor);
        });
        const size_t pixel = index(x, y);
        return std::max(excess, 0.0f) * (square(luminance_at(m_filtered, pixel)) + floor);
    }

private:
    static float square(float x) { return x * x; }
    size_t index(int x, int y) const { return static_cast<size_t>(y) * m_assignment.width + x; }

    /// Over the valid pixels of the same rule.
    template <class Value>
    float mean_around(int x, int y, const Value& value) const {
        const int16_t rule = m_assignment.rule[index(x, y)];
        float sum = 0;
        int count = 0;
        for (int v = std::max(y - kReach, 0); v <= std::min(y + kReach, m_assignment.height - 1); ++v)
            for (int u = std::max(x - kReach, 0); u <= std::min(x + kReach, m_assignment.width - 1); ++u) {
                const size_t pixel = index(u, v);
                if (m_assignment.rule[pixel] != rule || m_surfaces.validity(pixel) != Validity::valid) continue;
                sum += value(pixel), ++count;
            }
        return sum / static_cast<float>(count);
    }

    const Image &m_filtered, &m_reference, &m_error;
    const Surfaces& m_surfaces;
    const Assignment& m_assignment;
};

}  // namespace

ShadedFrame blend(const ShadedFrame& filtered, const ShadedFrame& reference, const Surfaces& surfaces,
                  const Assignment& assignment) {
    const Blender blender(filtered, reference, surfaces, assignment);
    ShadedFrame result = reference;
    for_each_index(assignment.height, [&](int y) {
        for (int x = 0; x < assignment.width; ++x) {
            const size_t pixel = static_cast<size_t>(y) * assignment.width + x;
            if (surfaces.validity(pixel) != Validity::valid) continue;
            float& error = *result.standard_error.at(pixel);
            const float bias = blender.squared_bias(x, y), noise = error * error;
            const float share = bias + noise > 0 ? bias / (bias + noise) : 1.0f;
            for (int c = 0; c < 3; ++c) {
                const float shown = filtered.overlay.at(pixel)[c];
                result.overlay.at(pixel)[c] = shown + share * (reference.overlay.at(pixel)[c] - shown);
            }
            error *= std::sqrt(share);
        }
    });
    return result;
}

}  // namespace burnish
