#include <burnish/light/cube_resample.h>

#include <burnish/base/parallel.h>
#include <burnish/light/cube_faces.h>

#include <bit>

namespace burnish {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kLargestStep = 1.0 / 32.0;  // radians of longitude between two quadrature points, at most

/// Radiance times solid angle, and the solid angle, of what has been covered so far.
struct Coverage {
    double energy[3] = {0, 0, 0}, solid_angle = 0;
};

/// The lat-long as cells that are constant between meridians and between the heights s = sin(latitude) of its rows.
class LatLongCells {
public:
    explicit LatLongCells(const Image& picture) : m_picture(picture), m_heights(picture.height + 1) {
        for (int row = 0; row <= picture.height; ++row) m_heights[row] = std::cos(std::numbers::pi * row / picture.height);
    }

    /// Calls visit(column, longitude, width) for steps from u0 to u1 (edge-to-edge coordinate, may leave [0, 1]); no step
    /// crosses a meridian between two columns. `longitude` = 2 pi u at the step's middle, `width` in radians.
    template <class Visit>
    void for_each_step(double u0, double u1, Visit&& visit) const {
        const int columns = m_picture.width;
        const double first = u0 * columns, last = u1 * columns;
        for (double cell = std::floor(first); cell < last; cell += 1.0) {
            const double from = std::max(first, cell), to = std::min(last, cell + 1.0);
            const double width = (to - from) / columns * kTwoPi;
            if (!(width > 0.0)) continue;
            const int steps = static_cast<int>(std::ceil(width / kLargestStep));
            const int column = ((static_cast<int>(cell) % columns) + columns) % columns;
            for (int i = 0; i < steps; ++i)
                visit(column, kTwoPi * (from + (to - from) * (i + 0.5) / steps) / columns, width / steps);
        }
    }

    /// The row that holds height s.
    int row_at(double s) const {
        const int row = static_cast<int>(std::acos(s) / std::numbers::pi * m_picture.height);
        return std::clamp(row, 0, m_picture.height - 1);
    }

    /// Adds the part of a column between heights `upper` and `lower`, `width` wide. `row` holds `upper` (or lies just above)
    /// and is left where `lower` lies.
    void add(int column, int& row, double upper, double lower, double width, Coverage& sum) const {
        while (row + 1 < m_picture.height && m_heights[row + 1] >= upper) ++row;
        for (double from = upper; from > lower;) {
            const bool last = m_heights[row + 1] <= lower || row + 1 == m_picture.height;
            const double to = last ? lower : m_heights[row + 1], omega = (from - to) * width;
            const float* rgb = m_picture.at(column, row);
            for (int k = 0; k < 3; ++k) sum.energy[k] += omega * rgb[k];
            sum.solid_angle += omega;
            from = to;
            if (!last) ++row;
        }
    }

private:
    const Image& m_picture;
    std::vector<double> m_heights;
};

double edge(int i, int size) { return 2.0 * i / size - 1.0; }

void store(const Coverage& sum, float* rgb) {
    for (int k = 0; k < 3; ++k) rgb[k] = sum.solid_angle > 0.0 ? static_cast<float>(sum.energy[k] / sum.solid_angle) : 0.0f;
}

/// One column of a side face. Its sides are meridians; on each meridian the texels follow each other without a gap, so all
/// energy between top and bottom is counted exactly once.
void fill_side_column(const LatLongCells& cells, int face, int x, Image& out) {
    constexpr double middle_of_face[6] = {0.25, 0.75, 0, 0, 0.5, 0.0};
    const int n = out.width;
    const double middle = middle_of_face[face];
    std::vector<Coverage> column(n);
    const double u0 = middle + std::atan(edge(x, n)) / kTwoPi, u1 = middle + std::atan(edge(x + 1, n)) / kTwoPi;
    cells.for_each_step(u0, u1, [&](int cell, double longitude, double width) {
        const double c = std::cos(longitude - kTwoPi * middle);
        const auto height = [&](int y) {
            const double slope = -edge(y, n) * c;
            return slope / std::sqrt(1.0 + slope * slope);
        };
        double upper = height(0);
        int row = std::max(0, cells.row_at(upper) - 1);
        for (int y = 0; y < n; ++y) {
            const double lower = height(y + 1);
            cells.add(cell, row, upper, lower, width, column[y]);
            upper = lower;
        }
    });
    for (int y = 0; y < n; ++y) store(column[y], out.at(x, y));
}

/// A square on the top or bottom face: [x0, x1] x [z0, z1] of the plane |y| = 1, not around the pole.
struct PolarSquare {
    double x0, x1, z0, z1;

    /// The four corners' u, sorted, unwrapped around the square's middle; a corner on the pole has none.
    std::vector<double> corners() const {
        const auto u = [](double x, double z) { return 0.5 - std::atan2(x, z) / kTwoPi; };
        const double middle = u(0.5 * (x0 + x1), 0.5 * (z0 + z1));
        std::vector<double> found;
        for (const double x : {x0, x1}) {
            for (const double z : {z0, z1}) {
                if (x != 0.0 || z != 0.0) found.push_back(middle + std::remainder(u(x, z) - middle, 1.0));
            }
        }
        std::sort(found.begin(), found.end());
        return found;
    }

    /// Distances from the pole at which the meridian along (dx, dz) enters and leaves the square.
    std::pair<double, double> crossed(double dx, double dz) const {
        const double ax = x0 / dx, bx = x1 / dx, az = z0 / dz, bz = z1 / dz;
        return {std::max({0.0, std::min(ax, bx), std::min(az, bz)}), std::min(std::max(ax, bx), std::max(az, bz))};
    }
};

void fill_polar_texel(const LatLongCells& cells, bool top, const PolarSquare& square, float* rgb) {
    Coverage sum;
    const std::vector<double> corners = square.corners();
    for (size_t i = 0; i + 1 < corners.size(); ++i) {
        cells.for_each_step(corners[i], corners[i + 1], [&](int cell, double longitude, double width) {
            const auto [near, far] =
                square.crossed(std::sin(std::numbers::pi - longitude), std::cos(std::numbers::pi - longitude));
            if (!(far > near)) return;
            const double high = 1.0 / std::sqrt(1.0 + near * near), low = 1.0 / std::sqrt(1.0 + far * far);
            const double upper = top ? high : -low, lower = top ? low : -high;
            int row = std::max(0, cells.row_at(upper) - 1);
            cells.add(cell, row, upper, lower, width, sum);
        });
    }
    store(sum, rgb);
}

void fill_polar_row(const LatLongCells& cells, bool top, int y, Image& out) {
    const int n = out.width;
    const double z0 = top ? -edge(y + 1, n) : edge(y, n), z1 = top ? -edge(y, n) : edge(y + 1, n);
    for (int x = 0; x < n; ++x) fill_polar_texel(cells, top, {edge(x, n), edge(x + 1, n), z0, z1}, out.at(x, y));
}

/// Fine texels [first, last) that a coarse texel overlaps, and how much of one of them it covers.
struct Overlap {
    int first, last;
    double from, to;

    Overlap(int coarse, int coarse_size, int fine_size)
        : from(static_cast<double>(coarse) * fine_size / coarse_size),
          to(static_cast<double>(coarse + 1) * fine_size / coarse_size) {
        first = static_cast<int>(from);
        last = std::min(fine_size, static_cast<int>(std::ceil(to)));
    }
    double share(int fine) const { return std::min(to, fine + 1.0) - std::max(from, static_cast<double>(fine)); }
};

}  // namespace

std::array<Image, 6> latlong_to_cube(const Image& latlong, int face_size) {
    const LatLongCells cells(latlong);
    std::array<Image, 6> faces;
    faces.fill(Image(face_size, face_size, 3));
    for_each_index(6 * face_size, [&](int task) {
        const int face = task / face_size, line = task % face_size;
        if (face / 2 == 1)
            fill_polar_row(cells, face == 2, line, faces[face]);
        else
            fill_side_column(cells, face, line, faces[face]);
    });
    return faces;
}

std::array<Image, 6> resized_cube(const std::array<Image, 6>& faces, int face_size) {
    const int from = faces[0].width;
    if (from == face_size) return faces;
    std::array<Image, 6> out;
    out.fill(Image(face_size, face_size, 3));
    for_each_index(6 * face_size, [&](int task) {
        const int face = task / face_size, y = task % face_size;
        const Overlap rows(y, face_size, from);
        for (int x = 0; x < face_size; ++x) {
            const Overlap columns(x, face_size, from);
            Coverage sum;
            for (int fy = rows.first; fy < rows.last; ++fy) {
                for (int fx = columns.first; fx < columns.last; ++fx) {
                    const double omega =
                        rows.share(fy) * columns.share(fx) *
                        cube_solid_angle(edge(fx, from), edge(fx + 1, from), edge(fy, from), edge(fy + 1, from));
                    for (int k = 0; k < 3; ++k) sum.energy[k] += omega * faces[face].at(fx, fy)[k];
                    sum.solid_angle += omega;
                }
            }
            store(sum, out[face].at(x, y));
        }
    });
    return out;
}

int cube_size_for_latlong(int width) {
    const int wanted = static_cast<int>(std::bit_ceil(static_cast<unsigned>((width + 3) / 4)));
    return std::clamp(wanted, 16, width >= 8192 ? 2048 : 1024);
}

int cube_size_for_cube(int size) { return std::clamp(static_cast<int>(std::bit_ceil(static_cast<unsigned>(size))), 16, 2048); }

}  // namespace burnish
