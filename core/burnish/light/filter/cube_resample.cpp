#include <burnish/light/filter/cube_resample.h>

#include <burnish/base/parallel.h>
#include <burnish/light/filter/cube_faces.h>
#include <burnish/light/filter/gaussian_cap.h>
#include <burnish/light/latlong_cells.h>

#include <bit>
#include <vector>

namespace burnish {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr int kFineSteps = 8;  // quadrature points per column where a sun is cut; keeps its energy to 4e-4

double edge(int i, int size) { return 2.0 * i / size - 1.0; }

/// One column of a side face. Its sides are meridians; on each meridian the texels follow each other without a gap, so all
/// energy between top and bottom is counted exactly once.
void fill_side_column(const LatLongCells& cells, int face, int x, Image& out) {
    constexpr double middle_of_face[6] = {0.25, 0.75, 0, 0, 0.5, 0.0};
    const int n = out.width;
    const double middle = middle_of_face[face];
    std::vector<Coverage> column(n);
    const double u0 = middle + std::atan(edge(x, n)) / kTwoPi, u1 = middle + std::atan(edge(x + 1, n)) / kTwoPi;
    const int steps = cells.may_have_sun(u0, u1) ? kFineSteps : 1;
    cells.for_each_step(u0, u1, steps, [&](int cell, double longitude, double width) {
        const double c = std::cos(longitude - kTwoPi * middle);
        const auto height = [&](int y) {
            const double slope = -edge(y, n) * c;
            return slope / std::sqrt(1.0 + slope * slope);
        };
        double upper = height(0);
        int row = cells.row_at(upper);
        for (int y = 0; y < n; ++y) {
            const double lower = height(y + 1);
            cells.add(cell, row, upper, lower, width, column[y]);
            upper = lower;
        }
    });
    for (int y = 0; y < n; ++y) column[y].store(out.at(x, y));
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

    /// Distances of the nearest and farthest corner from the pole; no point of the square lies outside them, because its sides
    /// do not cross the axes.
    double nearest() const {
        return std::hypot(std::min(std::fabs(x0), std::fabs(x1)), std::min(std::fabs(z0), std::fabs(z1)));
    }
    double farthest() const {
        return std::hypot(std::max(std::fabs(x0), std::fabs(x1)), std::max(std::fabs(z0), std::fabs(z1)));
    }

    /// Distances from the pole at which the meridian along (dx, dz) enters and leaves the square.
    std::pair<double, double> crossed(double dx, double dz) const {
        const double ax = x0 / dx, bx = x1 / dx, az = z0 / dz, bz = z1 / dz;
        return {std::max({0.0, std::min(ax, bx), std::min(az, bz)}), std::min(std::max(ax, bx), std::max(az, bz))};
    }
};

/// The square's texel; `row` is a guess at the rows it lies in, and is left there.
void fill_polar_texel(const LatLongCells& cells, bool top, const PolarSquare& square, int& row, float* rgb) {
    const auto heights = [&](double near, double far) {
        const double high = 1.0 / std::sqrt(1.0 + near * near), low = 1.0 / std::sqrt(1.0 + far * far);
        return top ? std::pair(high, low) : std::pair(-low, -high);
    };
    const std::vector<double> corners = square.corners();
    const auto [highest, lowest] = heights(square.nearest(), square.farthest());
    const int steps = cells.may_have_sun(corners.front(), corners.back(), highest, lowest) ? kFineSteps : 1;
    Coverage sum;
    for (size_t i = 0; i + 1 < corners.size(); ++i) {
        cells.for_each_step(corners[i], corners[i + 1], steps, [&](int cell, double longitude, double width) {
            const double angle = std::numbers::pi - longitude;
            const auto [near, far] = square.crossed(std::sin(angle), std::cos(angle));
            if (!(far > near)) return;
            const auto [upper, lower] = heights(near, far);
            cells.add(cell, row, upper, lower, width, sum);
        });
    }
    sum.store(rgb);
}

void fill_polar_row(const LatLongCells& cells, bool top, int y, Image& out) {
    const int n = out.width;
    const double z0 = top ? -edge(y + 1, n) : edge(y, n), z1 = top ? -edge(y, n) : edge(y + 1, n);
    int row = cells.row_at(top ? 1.0 : -1.0);
    for (int x = 0; x < n; ++x) fill_polar_texel(cells, top, {edge(x, n), edge(x + 1, n), z0, z1}, row, out.at(x, y));
}

/// Fine texels [first, last) that a coarse texel overlaps along one axis, and the overlaps' ends on the face.
struct Overlap {
    int first, last, fine_size;
    double from, to;  // in fine texels

    Overlap(int coarse, int coarse_size, int fine)
        : fine_size(fine),
          from(static_cast<double>(coarse) * fine / coarse_size),
          to(static_cast<double>(coarse + 1) * fine / coarse_size) {
        first = static_cast<int>(from);
        last = std::min(fine_size, static_cast<int>(std::ceil(to)));
    }
    double lower(int texel) const { return 2.0 * std::max(from, static_cast<double>(texel)) / fine_size - 1.0; }
    double upper(int texel) const { return 2.0 * std::min(to, texel + 1.0) / fine_size - 1.0; }
};

/// The mean of a face over the solid angle of one texel of another size.
void resize_texel(const Image& face, const Overlap& columns, const Overlap& rows, float* rgb) {
    Coverage sum;
    for (int y = rows.first; y < rows.last; ++y) {
        for (int x = columns.first; x < columns.last; ++x) {
            const double omega = cube_solid_angle(columns.lower(x), columns.upper(x), rows.lower(y), rows.upper(y));
            for (int k = 0; k < 3; ++k) sum.energy[k] += omega * face.at(x, y)[k];
            sum.solid_angle += omega;
        }
    }
    sum.store(rgb);
}

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
        for (int x = 0; x < face_size; ++x) resize_texel(faces[face], Overlap(x, face_size, from), rows, out[face].at(x, y));
    });
    return out;
}

std::array<Image, 6> halved_cube(const std::array<Image, 6>& faces) {
    const int from = faces[0].width, size = from / 2;
    const std::vector<float> cosines = texel_cosines(from);
    std::array<Image, 6> out;
    out.fill(Image(size, size, 3));
    for_each_index(6 * size, [&](int task) {
        const int face = task / size, y = task % size;
        for (int x = 0; x < size; ++x) {
            Color3f sum(0, 0, 0);
            float total = 0;
            for (const auto& [dx, dy] : {std::array{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
                const float *rgb = faces[face].at(2 * x + dx, 2 * y + dy),
                            c = cosines[static_cast<size_t>(2 * y + dy) * from + 2 * x + dx], weight = c * c * c;
                sum += Color3f(rgb[0], rgb[1], rgb[2]) * weight, total += weight;
            }
            sum /= total;
            std::copy_n(&sum.x, 3, out[face].at(x, y));
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
