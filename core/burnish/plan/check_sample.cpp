#include <burnish/plan/check_sample.h>

#include <burnish/base/display.h>
#include <burnish/base/parallel.h>
#include <burnish/sampling/sequence.h>

#include <algorithm>
#include <numeric>

namespace burnish {
namespace {

constexpr size_t kLookedAt = 4096;  // pixels that are shaded twice to draw from
constexpr double kEvenShare = 0.5;  // of the draws, that go by no estimator
constexpr size_t kPixelsABatch = 16;

double display_distance(const Color3f& a, const Color3f& b, double exposure) {
    double square = 0;
    for (int c = 0; c < 3; ++c) square += std::pow(display_encoded(a[c] * exposure) - display_encoded(b[c] * exposure), 2) / 3;
    return square;
}

/// Draws entries of a list by their chance, which sum to 1, at even steps of their running sum.
std::vector<size_t> drawn(const std::vector<double>& chance, size_t count) {
    std::vector<size_t> chosen;
    double sum = 0;
    for (size_t i = 0; i < chance.size(); ++i) {
        sum += chance[i];
        for (; chosen.size() < count && (static_cast<double>(chosen.size()) + 0.5) / static_cast<double>(count) < sum;)
            chosen.push_back(i);
    }
    return chosen;
}

}  // namespace

double exposure_of(const std::vector<Color3f>& picture, const std::vector<double>& weights) {
    double sum = 0, whole = 0;
    for (size_t i = 0; i < picture.size(); ++i)
        sum += weights[i] * (picture[i].x + picture[i].y + picture[i].z) / 3, whole += weights[i];
    return sum > 0 ? kMiddleGrey * whole / sum : 1;
}

CheckSample spread_sample(const Surfaces& surfaces, const Assignment& assignment, int rule, size_t count) {
    std::vector<uint32_t> all;
    surfaces.list({0, 0, assignment.width, assignment.height}, rule, all);
    CheckSample sample;
    const size_t parts = std::min(count, all.size());
    for (size_t i = 0; i < parts; ++i) {
        const size_t begin = i * all.size() / parts, end = (i + 1) * all.size() / parts;
        sample.pixels.push_back(all[begin + hash_bits(static_cast<uint32_t>(i)) % (end - begin)]);
    }
    sample.weights.assign(parts, 1.0 / static_cast<double>(std::max<size_t>(1, parts)));
    return sample;
}

CheckSample check_sample(const Surfaces& surfaces, const Assignment& assignment, int rule, size_t count,
                         const Disagreement& by) {
    CheckSample looked_at = spread_sample(surfaces, assignment, rule, std::max(count, kLookedAt));
    const std::vector<SurfaceBatch> batches = small_batches(surfaces, looked_at.pixels, by.one);
    const std::vector<Color3f> one = shade_all(batches, by.one).overlay, other = shade_all(batches, by.other).overlay;
    looked_at.exposure = exposure_of(one, looked_at.weights);
    if (looked_at.pixels.size() <= count) return looked_at;
    CheckSample sample;
    sample.exposure = looked_at.exposure;
    std::vector<double> chance;
    for (size_t i = 0; i < one.size(); ++i) chance.push_back(display_distance(one[i], other[i], sample.exposure));
    const double sum = std::reduce(chance.begin(), chance.end()), even = 1.0 / static_cast<double>(chance.size());
    for (double& own : chance) own = sum > 0 ? kEvenShare * even + (1 - kEvenShare) * own / sum : even;
    for (const size_t i : drawn(chance, count)) {
        sample.pixels.push_back(looked_at.pixels[i]);
        sample.weights.push_back(even / (chance[i] * static_cast<double>(count)));
    }
    return sample;
}

std::vector<SurfaceBatch> small_batches(const Surfaces& surfaces, const std::vector<uint32_t>& pixels,
                                        const MaterialShader& shader) {
    std::vector<SurfaceBatch> batches((pixels.size() + kPixelsABatch - 1) / kPixelsABatch);
    for_each_index(static_cast<int>(batches.size()), [&](int index) {
        const size_t begin = static_cast<size_t>(index) * kPixelsABatch, end = std::min(begin + kPixelsABatch, pixels.size());
        SurfaceBatch& batch = batches[static_cast<size_t>(index)];
        batch.pixel.assign(pixels.begin() + static_cast<ptrdiff_t>(begin), pixels.begin() + static_cast<ptrdiff_t>(end));
        surfaces.fill(batch, shader.needs());
    });
    return batches;
}

ShadedBatch shade_all(const std::vector<SurfaceBatch>& batches, const MaterialShader& shader) {
    std::vector<ShadedBatch> parts(batches.size());
    for_each_index(static_cast<int>(parts.size()),
                   [&](int i) { shader.shade(batches[static_cast<size_t>(i)], parts[static_cast<size_t>(i)]); });
    ShadedBatch all;
    for (const ShadedBatch& part : parts) {
        all.overlay.insert(all.overlay.end(), part.overlay.begin(), part.overlay.end());
        all.samples.insert(all.samples.end(), part.samples.begin(), part.samples.end());
        all.standard_error.insert(all.standard_error.end(), part.standard_error.begin(), part.standard_error.end());
    }
    return all;
}

}  // namespace burnish
