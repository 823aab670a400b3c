// Sums over the texels under a Gaussian. Small caps weigh their texels once for the six faces and for the four mirror images
// of a place on each; what lies beyond an edge is unfolded around the face.
#include <burnish/base/parallel.h>
#include <burnish/light/gaussian_blur.h>
#include <burnish/light/gaussian_cap.h>

#include <numeric>

namespace burnish {
namespace {

using SixTexels = float[6][4];

struct Mirror {
    bool x, y;
};

/// The texels of a small cap around a place on a face, whichever of the six.
class Footprint {
public:
    Footprint(int size, std::span<const float> cosines) : m_size(size), m_cosines(cosines) {}

    void fill(const GaussianCap& cap, const Vec3f& d) {
        m_runs.clear(), m_weights.clear(), m_beyond.clear();
        add_own(cap, d);
        if (!cap.on_the_face(d)) {
            add_neighbour(cap, {d.y, -d.x, d.z}, m_size, 0);
            add_neighbour(cap, {-d.y, d.x, d.z}, -m_size, 0);
            add_neighbour(cap, {d.z, d.y, -d.x}, 0, -m_size);
            add_neighbour(cap, {-d.z, d.y, d.x}, 0, m_size);
        }
        normalise();
    }

    /// The weighted sums for the six faces at once: they are independent, which keeps the processor busy.
    void sum(const CubeLevel& source, Mirror mirror, SixTexels& total) const {
        const float* faces[6];
        for (int face = 0; face < 6; ++face) faces[face] = source.at(face, 0, 0);
        const float* weight = m_weights.data();
        const std::ptrdiff_t step = mirror.x ? -4 : 4;
        for (const Run& run : m_runs) {
            std::ptrdiff_t offset = source.at(0, mirrored(run.x, mirror.x), mirrored(run.y, mirror.y)) - faces[0];
            for (int i = 0; i < run.count; ++i, ++weight, offset += step) {
                for (int face = 0; face < 6; ++face) {
                    for (int k = 0; k < 4; ++k) total[face][k] += *weight * faces[face][offset + k];
                }
            }
        }
        for (const Beyond& texel : m_beyond) {
            for (int face = 0; face < 6; ++face) {
                const CubeTexel t = unfolded_texel(face, mirrored(texel.x, mirror.x), mirrored(texel.y, mirror.y), m_size);
                const float* rgba = source.at(t.face, t.x, t.y);
                for (int k = 0; k < 4; ++k) total[face][k] += texel.weight * rgba[k];
            }
        }
    }

private:
    struct Run {
        int x, y, count;
    };
    struct Beyond {
        int x, y;
        float weight;
    };

    int mirrored(int i, bool mirror) const { return mirror ? m_size - 1 - i : i; }

    void add_own(const GaussianCap& cap, const Vec3f& d) {
        const TexelRange rows = cap.rows(d);
        for (int y = rows.first; y <= rows.last; ++y) {
            const TexelRange range = cap.columns(d, y);
            if (range.last < range.first) continue;
            const size_t old = m_weights.size();
            m_weights.resize(old + range.last - range.first + 1);
            cap.weigh(d, y, range, m_cosines, &m_weights[old]);
            m_runs.push_back({range.first, y, range.last - range.first + 1});
        }
    }

    /// d along the neighbour's axes when it is turned to continue this face, (dx, dy) texels away.
    void add_neighbour(const GaussianCap& cap, const Vec3f& d, int dx, int dy) {
        const TexelRange rows = cap.rows(d);
        for (int y = rows.first; y <= rows.last; ++y) {
            const TexelRange range = cap.columns(d, y);
            if (range.last < range.first) continue;
            m_row.resize(range.last - range.first + 1);
            cap.weigh(d, y, range, m_cosines, m_row.data());
            for (int x = range.first; x <= range.last; ++x) m_beyond.push_back({x + dx, y + dy, m_row[x - range.first]});
        }
    }

    void normalise() {
        float total = std::accumulate(m_weights.begin(), m_weights.end(), 0.0f);
        for (const Beyond& texel : m_beyond) total += texel.weight;
        for (float& weight : m_weights) weight /= total;
        for (Beyond& texel : m_beyond) texel.weight /= total;
    }

    int m_size;
    std::span<const float> m_cosines;
    std::vector<Run> m_runs;
    std::vector<float> m_weights, m_row;
    std::vector<Beyond> m_beyond;
};

/// Any cap, over all texels of the cube.
void sum_everywhere(const CubeLevel& source, const GaussianCap& cap, const Vec3f& world, std::span<const float> cosines,
                    float* out) {
    const int n = source.size();
    std::vector<float> weights(n);
    float sum[4] = {0, 0, 0, 0}, total = 0;
    for (int face = 0; face < 6; ++face) {
        const Vec3f d = cube_to_face(face, world);
        for (int y = 0; y < n; ++y) {
            cap.weigh(d, y, {0, n - 1}, cosines, weights.data());
            const float* texel = source.at(face, 0, y);
            for (int x = 0; x < n; ++x, texel += 4) {
                for (int k = 0; k < 4; ++k) sum[k] += weights[x] * texel[k];
                total += weights[x];
            }
        }
    }
    for (int k = 0; k < 4; ++k) out[k] = sum[k] / total;
}

void blur_place(const CubeLevel& source, Footprint& footprint, int x, int y, CubeLevel& target) {
    const int last = target.size() - 1;
    for (const Mirror mirror : {Mirror{false, false}, Mirror{true, false}, Mirror{false, true}, Mirror{true, true}}) {
        SixTexels total = {};
        footprint.sum(source, mirror, total);
        for (int face = 0; face < 6; ++face)
            std::copy_n(total[face], 4, target.at(face, mirror.x ? last - x : x, mirror.y ? last - y : y));
    }
}

}  // namespace

void blur_by_sum(const CubeLevel& source, const GaussianBlur& blur, CubeLevel& target) {
    const int n = target.size(), half = (n + 1) / 2;
    const std::vector<float> cosines = texel_cosines(source.size());
    for_each_index(half, [&](int y) {
        Footprint footprint(source.size(), cosines);
        for (int x = 0; x < half; ++x) {
            const Vec3f place = face_place(x, y, n), d = place.normalized();
            const GaussianCap cap(blur.kernel_versine(1.0 / place.length2(), n), source.size());
            if (cap.small()) {
                footprint.fill(cap, d);
                blur_place(source, footprint, x, y, target);
                continue;
            }
            for (int face = 0; face < 6; ++face) {
                for (const Vec3f& m : {d, Vec3f(d.x, -d.y, d.z), Vec3f(d.x, d.y, -d.z), Vec3f(d.x, -d.y, -d.z)}) {
                    float* out = target.at(face, m.y == d.y ? x : n - 1 - x, m.z == d.z ? y : n - 1 - y);
                    sum_everywhere(source, cap, face_to_cube(face, m), cosines, out);
                }
            }
        }
    });
    target.fill_borders();
}

}  // namespace burnish
