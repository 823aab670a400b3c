#include <burnish/base/parallel.h>
#include <burnish/input/median.h>
#include <burnish/input/role_checks.h>
#include <burnish/input/sightings.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <vector>

namespace burnish {
namespace {

Vec3f vector_at(const Image& image, size_t i) {
    const float* v = image.at(i);
    return {v[0], v[1], v[2]};
}

/// Every n-th pixel, so that statistics of large frames cost little and never vary.
size_t sample_step(const Image& image) {
    constexpr size_t kSamples = 1 << 18;
    return std::max<size_t>(image.pixel_count() / kSamples, 1);
}

bool is_near_one(float length) { return std::abs(length - 1.0f) < 0.05f; }

}  // namespace

VectorCheck check_vectors(const Image& vectors) {
    std::vector<double> lengths;
    size_t unit = 0, encoded = 0;
    bool is_in_unit_cube = true;
    const size_t step = sample_step(vectors);
    for (size_t i = 0; i < vectors.pixel_count(); i += step) {
        const Vec3f n = vector_at(vectors, i);
        if (!is_finite(n) || n == Vec3f(0.0f)) continue;
        const float length = n.length();
        lengths.push_back(length);
        unit += is_near_one(length);
        encoded += is_near_one((2.0f * n - Vec3f(1.0f)).length());
        is_in_unit_cube &= std::min({n.x, n.y, n.z}) >= 0.0f && std::max({n.x, n.y, n.z}) <= 1.001f;
    }
    const size_t half = (lengths.size() + 1) / 2;
    VectorCheck check;
    check.median_length = median(lengths);
    if (lengths.empty())
        check.kind = VectorKind::empty;
    else if (is_in_unit_cube && encoded >= half && encoded > unit)
        check.kind = VectorKind::encoded;
    else
        check.kind = unit >= half ? VectorKind::unit : VectorKind::neither;
    return check;
}

void decode_vectors(Image& vectors) {
    for (size_t i = 0; i < vectors.pixel_count(); ++i) {
        if (vector_at(vectors, i) == Vec3f(0.0f)) continue;
        float* n = vectors.at(i);
        for (int c = 0; c < 3; ++c) n[c] = 2.0f * n[c] - 1.0f;
    }
}

PositionCheck check_positions(const Image& position) {
    std::vector<double> sizes;
    const size_t step = sample_step(position);
    for (size_t i = 0; i < position.pixel_count(); i += step) {
        const float* p = position.at(i);
        if (is_hit(p)) sizes.push_back(std::max({std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])}));
    }
    if (sizes.empty()) return {};
    return {sizes.size() * step, static_cast<float>(median(sizes))};
}

float half_step(float value) {
    constexpr int kMantissaBits = 10, kSmallestExponent = -14;
    return std::ldexp(1.0f, std::max(std::ilogb(std::max(value, 1e-6f)), kSmallestExponent) - kMantissaBits);
}

HalfError half_error(const Image& position, const Vec3f& centre) {
    HalfError error{half_step(check_positions(position).median_size), 0};
    const size_t step = sample_step(position);
    for (size_t i = 0; i < position.pixel_count(); i += step) {
        if (!is_hit(position.at(i))) continue;
        const Vec3f p = vector_at(position, i);
        const double lost = 0.5 * half_step(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}));
        error.turn_deg = std::max(error.turn_deg, std::atan2(lost, (p - centre).length()) * 180 / std::numbers::pi);
    }
    return error;
}

Facing facing_share(const Image& normal, const Image& position, const Vec3f& centre) {
    constexpr size_t kWanted = 20000;
    const Window window{0, 0, position.width, position.height};
    Facing facing;
    size_t towards = 0;
    for (const Sighting& sighting : sample_sightings(position, nullptr, window, window, kWanted)) {
        const Vec3f n = vector_at(normal, sighting.pixel);
        if (!is_finite(n) || n == Vec3f(0.0f)) continue;
        ++facing.pixels;
        towards += n.dot(centre - vector_at(position, sighting.pixel)) > 0.0f;
    }
    if (facing.pixels > 0) facing.share = static_cast<double>(towards) / static_cast<double>(facing.pixels);
    return facing;
}

Image surface_mask(const Image& position, const Image* normal) {
    constexpr float kAveragedLength = 0.9f;
    Image mask(position.width, position.height, 1);
    const size_t width = static_cast<size_t>(position.width);
    for_each_index(position.height, [&](int y) {
        for (size_t i = y * width; i < (y + 1) * width; ++i) {
            const bool is_whole = !normal || vector_at(*normal, i).length() > kAveragedLength;
            mask.data[i] = is_hit(position.at(i)) && is_whole ? 1.0f : 0.0f;
        }
    });
    return mask;
}

size_t scrub(Image& image, int above, int below) {
    std::atomic<size_t> pixels = 0;
    for_each_index(image.height, [&](int y) {
        size_t bad = 0;
        for (int x = 0; x < image.width; ++x) {
            bool is_bad = false;
            for (float* value = image.at(x, y); value != image.at(x, y) + image.channels; ++value)
                if (!std::isfinite(*value)) *value = 0.0f, is_bad = true;
            bad += is_bad;
        }
        if (y >= above && y < image.height - below) pixels += bad;
    });
    return pixels;
}

}  // namespace burnish
