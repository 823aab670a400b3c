// Sums over the texels under a Gaussian. Caps weigh their texels once for the six faces and for the four mirror images
// of a place on each; what lies beyond an edge of a small one is unfolded around the face.
#include <burnish/base/parallel.h>
#include <burnish/light/filter/gaussian_blur.h>
#include <burnish/light/filter/gaussian_cap.h>
#include <burnish/light/filter/six_face_sum.h>
#include <burnish/light/filter/sphere_sum.h>

#include <numeric>

namespace burnish {
namespace {

/// Where the texels beyond the edges of a face are: as unfolded_texel, but in floats from the first texel of the cube.
class Unfolding {
public:
    explicit Unfolding(const CubeLevel& level) : m_size(level.size()) {
        const int n = m_size;
        const std::array<CubeTexel, 4> within = {{{0, -2, 0}, {0, n, 0}, {0, 0, -2}, {0, 0, n}}};
        for (int face = 0; face < 6 && n > 1; ++face) {
            for (int side = 0; side < 4; ++side) {
                const int x = within[side].x, y = within[side].y;
                const auto offset = [&](int dx, int dy) {
                    const CubeTexel t = unfolded_texel(face, x + dx, y + dy, n);
                    return level.at(t.face, t.x, t.y) - level.at(0, 0, 0);
                };
                const std::ptrdiff_t right = offset(1, 0) - offset(0, 0), down = offset(0, 1) - offset(0, 0);
                m_grids[side][face] = {offset(0, 0) - right * x - down * y, right, down};
            }
        }
    }

    struct Grid {
        std::ptrdiff_t origin, x, y;
    };
    /// The grids, for the six faces, that hold the texel (x, y) beyond an edge.
    const std::array<Grid, 6>& grids(int x, int y) const { return m_grids[x < 0 ? 0 : (x >= m_size ? 1 : (y < 0 ? 2 : 3))]; }

private:
    int m_size;
    std::array<std::array<Grid, 6>, 4> m_grids{};  // left, right, above, below
};

/// The texels of a small cap around a place on a face, whichever of the six.
class Footprint {
public:
    Footprint(const CubeLevel& source, const Unfolding& unfolding, std::span<const float> cosines)
        : m_source(source), m_unfolding(unfolding), m_size(source.size()), m_cosines(cosines) {}

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

    /// The weighted sums for the six faces at once.
    void sum(Mirror mirror, SixTexels& total) const {
        add_runs(m_source, m_runs, mirror, m_weights.data(), total);
        if (!m_beyond.empty()) add_beyond(mirror, total);
    }

private:
    struct Beyond {
        int x, y;
        float weight;
    };

    void add_beyond(Mirror mirror, SixTexels& total) const {
        const float* cube = m_source.at(0, 0, 0);
        SixTexels sum = {};
        for (const Beyond& texel : m_beyond) {
            const int x = mirrored(texel.x, mirror.x), y = mirrored(texel.y, mirror.y);
            const auto& grids = m_unfolding.grids(x, y);
            for (int face = 0; face < 6; ++face) {
                const float* rgba = cube + grids[face].origin + x * grids[face].x + y * grids[face].y;
                for (int k = 0; k < 4; ++k) sum[face][k] += texel.weight * rgba[k];
            }
        }
        for (int face = 0; face < 6; ++face)
            for (int k = 0; k < 4; ++k) total[face][k] += sum[face][k];
    }

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

    const CubeLevel& m_source;
    const Unfolding& m_unfolding;
    int m_size;
    std::span<const float> m_cosines;
    std::vector<TexelRun> m_runs;
    std::vector<float> m_weights, m_row;
    std::vector<Beyond> m_beyond;
};

/// A place on each face and its mirror images.
constexpr Mirror kMirrors[] = {{false, false}, {true, false}, {false, true}, {true, true}};

void blur_place(const Footprint& footprint, int x, int y, CubeLevel& target) {
    const int last = target.size() - 1;
    for (const Mirror mirror : kMirrors) {
        SixTexels total = {};
        footprint.sum(mirror, total);
        for (int face = 0; face < 6; ++face)
            std::copy_n(total[face], 4, target.at(face, mirror.x ? last - x : x, mirror.y ? last - y : y));
    }
}

std::vector<CubeImage> all_images(const CubeLevel& source) {
    std::vector<CubeImage> images;
    for (const Mirror mirror : kMirrors)
        for (int face = 0; face < 6; ++face) images.emplace_back(source, face, mirror.x, mirror.y);
    return images;
}

/// By all texels of the cube. `images`: all_images of the source.
void blur_place(const SphereSum& weights, std::span<const CubeImage> images, int x, int y, CubeLevel& target) {
    const int last = target.size() - 1;
    for (const Mirror mirror : kMirrors)
        for (int face = 0; face < 6; ++face, images = images.subspan(1))
            weights.mean(images[0], target.at(face, mirror.x ? last - x : x, mirror.y ? last - y : y));
}

}  // namespace

void blur_by_sum(const CubeLevel& source, const GaussianBlur& blur, CubeLevel& target) {
    const int n = target.size(), half = (n + 1) / 2;
    const std::vector<float> cosines = texel_cosines(source.size());
    const Unfolding unfolding(source);
    const std::vector<CubeImage> images = all_images(source);
    for_each_index(half, [&](int y) {
        Footprint footprint(source, unfolding, cosines);
        SphereSum sphere(source, cosines);
        for (int x = 0; x < half; ++x) {
            const Vec3f place = face_place(x, y, n), d = place.normalized();
            const GaussianCap cap(blur.kernel_versine(1.0 / place.length2(), n), source.size());
            if (cap.small()) {
                footprint.fill(cap, d);
                blur_place(footprint, x, y, target);
            } else {
                sphere.fill(cap, d);
                blur_place(sphere, images, x, y, target);
            }
        }
    });
    target.fill_borders();
}

}  // namespace burnish
