// A Gaussian kernel over light that is a Gaussian's width smooth already needs few samples: the centre and two rings of six.
//
// Radii and weights minimise the largest difference to the exact convolution (2e-3 of a point light's peak) while the mean
// versine is exact. The rings' turn matters at a face's centre, where the grids of both levels are aligned: 15 degrees keep the
// energy best there. Six faces and the four mirror images of a place on each share the taps of a texel that
// do not reach over an edge.
#include <burnish/base/parallel.h>
#include <burnish/light/filter/gaussian_blur.h>
#include <burnish/light/filter/six_face_sum.h>

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
    size_t count = 0;
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

bool is_on_the_face(const Vec3f& d) { return std::max(std::fabs(d.y), std::fabs(d.z)) <= d.x; }

/// The taps of a stencil that lie on the face.
FaceTaps face_taps(const Stencil& stencil, int size) {
    FaceTaps taps;
    const float half = 0.5f * static_cast<float>(size);
    for (int i = 0; i < kTaps; ++i) {
        const Vec3f& d = stencil.directions[i];
        if (!is_on_the_face(d)) continue;
        const float scale = half / d.x, px = half + 0.5f + d.y * scale, py = half + 0.5f - d.z * scale;
        const int ix = static_cast<int>(px), iy = static_cast<int>(py);
        const float fx = px - static_cast<float>(ix), fy = py - static_cast<float>(iy), w = stencil.weights[i];
        const float lower = w * fy, upper = w - lower,
                    corners[4] = {upper - upper * fx, upper * fx, lower - lower * fx, lower * fx};
        taps.runs[2 * taps.count] = {ix - 1, iy - 1, 2}, taps.runs[2 * taps.count + 1] = {ix - 1, iy, 2};
        std::copy_n(corners, 4, taps.weights + 4 * taps.count++);
    }
    return taps;
}

/// The other taps, on whichever face they lie.
void add_beyond(const CubeLevel& source, const Stencil& stencil, Mirror mirror, SixTexels& total) {
    for (int i = 0; i < kTaps; ++i) {
        Vec3f d = stencil.directions[i];
        if (is_on_the_face(d)) continue;
        d.y = mirror.x ? -d.y : d.y, d.z = mirror.y ? -d.z : d.z;
        for (int face = 0; face < 6; ++face)
            source.add_bilinear(cube_coord(face_to_cube(face, d)), stencil.weights[i], total[face]);
    }
}

/// A place on each face and its mirror images, by the same stencil mirrored.
void blur_place(const CubeLevel& source, const Stencil& stencil, int x, int y, CubeLevel& target) {
    const FaceTaps taps = face_taps(stencil, source.size());
    const int last = target.size() - 1;
    for (const Mirror mirror : {Mirror{false, false}, Mirror{true, false}, Mirror{false, true}, Mirror{true, true}}) {
        SixTexels total = {};
        add_runs(source, std::span(taps.runs, 2 * taps.count), mirror, taps.weights, total);
        if (taps.count < kTaps) add_beyond(source, stencil, mirror, total);
        for (int face = 0; face < 6; ++face)
            std::copy_n(total[face], 4, target.at(face, mirror.x ? last - x : x, mirror.y ? last - y : y));
    }
}

}  // namespace

void blur_by_taps(const CubeLevel& source, const GaussianBlur& blur, CubeLevel& target) {
    const int n = target.size(), half = (n + 1) / 2;
    for_each_index(half, [&](int y) {
        for (int x = 0; x < half; ++x) {
            const Vec3f place = face_place(x, y, n);
            blur_place(source, stencil_around(place, blur.kernel_versine(1.0 / place.length2(), n)), x, y, target);
        }
    });
    target.fill_borders();
}

}  // namespace burnish
