#include <burnish/light/picture_cells.h>

#include <burnish/base/parallel.h>
#include <burnish/light/filter/cube_faces.h>

#include <algorithm>
#include <numbers>
#include <numeric>

namespace burnish {
namespace {

constexpr double kPiD = std::numbers::pi;

double luminance_of(const float* rgb) { return luminance({rgb[0], rgb[1], rgb[2]}); }

double angle_between(const Imath::V3d& a, const Imath::V3d& b) { return std::atan2(a.cross(b).length(), a.dot(b)); }

Imath::V3d face_direction(int face, double x, double y) {
    const CubeFaceAxes& axes = kCubeFaces[face];
    Imath::V3d d;
    d[face / 2] = face % 2 ? -1 : 1;
    d[axes.right] = axes.right_sign * (2 * x - 1);
    d[axes.up] = axes.up_sign * (1 - 2 * y);
    return d;
}

PictureCell latlong_cell(Image& picture, int x, int y) {
    const double row = kPiD / picture.height, column = 2 * kPiD / picture.width, theta = row * (y + 0.5),
                 phi = kPiD - column * (x + 0.5), sine = std::sin(theta);
    return {picture.at(x, y),
            {std::sin(phi) * sine, std::cos(theta), std::cos(phi) * sine},
            column * (std::cos(row * y) - std::cos(row * (y + 1))),
            (row * row + column * column * sine * sine) / 12};
}

PictureCell cube_cell(Image& picture, int face, int x, int y) {
    const int n = picture.width;
    const auto edge = [&](int i) { return 2.0 * i / n - 1.0; };
    const double omega = cube_solid_angle(edge(x), edge(x + 1), edge(y), edge(y + 1));
    return {picture.at(x, y), face_direction(face, (x + 0.5) / n, (y + 0.5) / n).normalized(), omega, omega / 6};
}

}  // namespace

PictureCell PictureCells::cell(int picture, int x, int y) const {
    return is_cube() ? cube_cell(*m_pictures[picture], picture, x, y) : latlong_cell(*m_pictures[0], x, y);
}

/// Luminance times solid angle; a cube's texels by their centres' solid angle 4 / (n^2 s^3), s the centre's distance.
double PictureCells::row_luminance(int picture, int y) const {
    const Image& image = *m_pictures[picture];
    double sum = 0;
    if (!is_cube()) {
        for (int x = 0; x < image.width; ++x) sum += luminance_of(image.at(x, y));
        return sum * cell(0, 0, y).solid_angle;
    }
    const double n = image.width;
    for (int x = 0; x < image.width; ++x) {
        const double s2 = face_direction(picture, (x + 0.5) / n, (y + 0.5) / n).length2();
        sum += luminance_of(image.at(x, y)) * 4 / (n * n * s2 * std::sqrt(s2));
    }
    return sum;
}

double PictureCells::mean_luminance() const {
    const int height = m_pictures[0]->height, rows = height * static_cast<int>(m_pictures.size());
    std::vector<double> sums(rows);
    for_each_index(rows, [&](int i) { sums[i] = row_luminance(i / height, i % height); });
    return std::accumulate(sums.begin(), sums.end(), 0.0) / (4 * kPiD);
}

std::vector<PictureCell> PictureCells::brighter_than(double least) const {
    const int height = m_pictures[0]->height, rows = height * static_cast<int>(m_pictures.size());
    std::vector<std::vector<PictureCell>> found(rows);
    for_each_index(rows, [&](int i) {
        const Image& image = *m_pictures[i / height];
        for (int x = 0; x < image.width; ++x)
            if (luminance_of(image.at(x, i % height)) > least) found[i].push_back(cell(i / height, x, i % height));
    });
    std::vector<PictureCell> cells;
    for (const auto& row : found) cells.insert(cells.end(), row.begin(), row.end());
    std::stable_sort(cells.begin(), cells.end(),
                     [](const auto& a, const auto& b) { return luminance_of(a.rgb) > luminance_of(b.rgb); });
    return cells;
}

void PictureCells::visit_within(const Imath::V3d& d, double angle, const Visit& visit) const {
    if (!is_cube()) return visit_rows(d, angle, visit);
    const int n = m_pictures[0]->width;
    for (int face = 0; face < 6; ++face) visit_block({face, 0, n, 0, n}, d, angle, visit);
}

void PictureCells::visit_rows(const Imath::V3d& d, double angle, const Visit& visit) const {
    const int width = m_pictures[0]->width, height = m_pictures[0]->height;
    const double theta = std::acos(std::clamp(d.y, -1.0, 1.0));
    const int first = std::max(0, static_cast<int>((theta - angle) / kPiD * height)),
              last = std::min(height - 1, static_cast<int>((theta + angle) / kPiD * height));
    const bool over_a_pole = theta <= angle || kPiD - theta <= angle;
    const double reach = over_a_pole ? kPiD : std::asin(std::sin(angle) / std::sin(theta));
    const int middle = static_cast<int>((0.5 - std::atan2(d.x, d.z) / (2 * kPiD)) * width),
              half = std::min(width / 2, static_cast<int>(reach / (2 * kPiD) * width) + 1);
    const int from = middle - half, to = std::min(middle + half, from + width - 1);
    for (int y = first; y <= last; ++y) {
        for (int x = from; x <= to; ++x) {
            const PictureCell there = cell(0, (x + width) % width, y);
            if (angle_between(there.direction, d) <= angle) visit(there);
        }
    }
}

/// Halves blocks until they miss the cap or are single texels.
void PictureCells::visit_block(const Block& b, const Imath::V3d& d, double angle, const Visit& visit) const {
    if (b.x0 == b.x1 || b.y0 == b.y1) return;
    if (b.x1 - b.x0 == 1 && b.y1 - b.y0 == 1) {
        const PictureCell there = cell(b.face, b.x0, b.y0);
        if (angle_between(there.direction, d) <= angle) visit(there);
        return;
    }
    const double n = m_pictures[0]->width;
    const Imath::V3d centre = face_direction(b.face, (b.x0 + b.x1) / (2 * n), (b.y0 + b.y1) / (2 * n)).normalized();
    const double extent = std::numbers::sqrt2 * std::max(b.x1 - b.x0, b.y1 - b.y0) / n;  // no angle exceeds its length
    if (angle_between(centre, d) > angle + extent) return;
    const int x = (b.x0 + b.x1) / 2, y = (b.y0 + b.y1) / 2;
    for (const Block& part : {Block{b.face, b.x0, x, b.y0, y}, Block{b.face, x, b.x1, b.y0, y}, Block{b.face, b.x0, x, y, b.y1},
                              Block{b.face, x, b.x1, y, b.y1}})
        visit_block(part, d, angle, visit);
}

}  // namespace burnish
