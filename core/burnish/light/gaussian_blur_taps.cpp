// A Gaussian kernel over light that is a Gaussian's width smooth already needs few samples: the centre and two rings of six.
//
// Radii and weights minimise the largest difference to the exact convolution (2e-3 of a point light's peak) while the mean
// versine is exact. The rings' turn matters at a face's centre, where the grids of both levels are aligned: 15 degrees keep the
// energy best there. Six faces share the taps of a texel unless some reach over an edge.
#include <burnish/base/parallel.h>
#include <burnish/light/gaussian_blur.h>
#include <burnish/light/six_face_sum.h>

namespace burnish {
namespace {

struct Ring {
    float radius;  // in sigmas, on the disc of equal area: 1 - cos = (radius sigma)^2 / 2
    float weight;  // of each of its six taps
    float turn;    // in sixths
};
constexpr Ring kInnerRing = {1.53297766f, 0.10681267f, 0.25f};
constexpr float kOuterRadius = 2.99535335f;
constexpr float kOuterWeight =
    (1.0f / 3.0f - kInnerRing.weight * kInnerRing.radius * kInnerRing.radius) / (kOuterRadius * kOuterRadius);
constexpr Ring kRings[2] = {kInnerRing, {kOuterRadius, kOuterWeight, 0.75f}};
constexpr int kTaps = 13;

/// Bilinear lookups of a face, whichever of the six: two texels of a row and two of the next for each.
struct FaceTaps {
    TexelRun runs[2 * kTaps];
    float weights[4 * kTaps];
};

/// The stencil around one texel: directions as (forward, right, up) of its face.
struct Stencil {
    Vec3f directions[kTaps];
    float weights[kTaps];
};

struct RingTap {
    float x, y, weight;
};

std::array<RingTap, kTaps> unit_taps() {
    std::array<RingTap, kTaps> taps;
    float rest = 1.0f;
    for (int i = 0; i < 12; ++i) {
        const Ring& ring = kRings[i / 6];
        const float phi = kPi / 3.0f * (static_cast<float>(i % 6) + ring.turn);
        taps[i + 1] = {ring.radius * std::cos(phi), ring.radius * std::sin(phi), ring.weight};
        rest -= ring.weight;
    }
    taps[0] = {0, 0, rest};
    return taps;
}

/// Around the place D = (1, right, up), with a kernel of this versine.
Stencil stencil_around(const Vec3f& place, double versine) {
    static const std::array<RingTap, kTaps> unit = unit_taps();
    const auto sigma = static_cast<float>(std::sqrt(versine));
    const Vec3f d = place.normalized(), t = Vec3f(-place.y, place.x, 0.0f).normalized(), b = d.cross(t);
    Stencil stencil;
    for (int i = 0; i < kTaps; ++i) {
        const float radius = i == 0 ? 0.0f : kRings[(i - 1) / 6].radius * sigma;
        const float drop = 0.5f * radius * radius, side = sigma * std::sqrt(1.0f - 0.5f * drop);
        stencil.directions[i] = d * (1.0f - drop) + t * (unit[i].x * side) + b * (unit[i].y * side);
        stencil.weights[i] = unit[i].weight;
    }
    return stencil;
}

bool on_the_face(const Stencil& stencil) {
    bool inside = true;
    for (const Vec3f& d : stencil.directions) inside &= std::max(std::fabs(d.y), std::fabs(d.z)) <= d.x;
    return inside;
}

FaceTaps face_taps(const Stencil& stencil, int size) {
    FaceTaps taps;
    const float half = 0.5f * static_cast<float>(size);
    for (int i = 0; i < kTaps; ++i) {
        const Vec3f& d = stencil.directions[i];
        const float scale = half / d.x, px = half + 0.5f + d.y * scale, py = half + 0.5f - d.z * scale;
        const int ix = static_cast<int>(px), iy = static_cast<int>(py);
        const float fx = px - static_cast<float>(ix), fy = py - static_cast<float>(iy), w = stencil.weights[i];
        const float lower = w * fy, upper = w - lower,
                    corners[4] = {upper - upper * fx, upper * fx, lower - lower * fx, lower * fx};
        taps.runs[2 * i] = {ix - 1, iy - 1, 2}, taps.runs[2 * i + 1] = {ix - 1, iy, 2};
        std::copy_n(corners, 4, taps.weights + 4 * i);
    }
    return taps;
}

void add_anywhere(const CubeLevel& source, int face, const Stencil& stencil, float* out) {
    float sum[4] = {0, 0, 0, 0};
    for (int i = 0; i < kTaps; ++i)
        source.add_bilinear(cube_coord(face_to_cube(face, stencil.directions[i])), stencil.weights[i], sum);
    std::copy_n(sum, 4, out);
}

}  // namespace

void blur_by_taps(const CubeLevel& source, const GaussianBlur& blur, CubeLevel& target) {
    const int n = target.size();
    for_each_index(n, [&](int y) {
        for (int x = 0; x < n; ++x) {
            const Vec3f place = face_place(x, y, n);
            const Stencil stencil = stencil_around(place, blur.kernel_versine(1.0 / place.length2(), n));
            if (on_the_face(stencil)) {
                const FaceTaps taps = face_taps(stencil, source.size());
                SixTexels total = {};
                add_runs(source, taps.runs, {false, false}, taps.weights, total);
                for (int face = 0; face < 6; ++face) std::copy_n(total[face], 4, target.at(face, x, y));
            } else {
                for (int face = 0; face < 6; ++face) add_anywhere(source, face, stencil, target.at(face, x, y));
            }
        }
    });
    target.fill_borders();
}

}  // namespace burnish
