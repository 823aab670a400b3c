#include <burnish/light/latlong_cells.h>

#include <burnish/base/parallel.h>

#include <numeric>

namespace burnish {

void LatLongCells::add(int column, int& row, double upper, double lower, double width, Coverage& sum) const {
    const int last_row = m_picture.height - 1;
    while (row > 0 && m_heights[row] < upper) --row;
    while (row < last_row && m_heights[row + 1] >= upper) ++row;
    for (double from = upper; from > lower;) {
        const bool last = m_heights[row + 1] <= lower || row == last_row;
        const double to = last ? lower : m_heights[row + 1], omega = (from - to) * width;
        const float* rgb = m_picture.at(column, row);
        for (int k = 0; k < 3; ++k) sum.energy[k] += omega * rgb[k];
        sum.solid_angle += omega;
        from = to;
        if (!last) ++row;
    }
}

void LatLongCells::find_suns() {
    const auto brightness = [&](int x, int y) {
        const float* rgb = m_picture.at(x, y);
        return (static_cast<double>(rgb[0]) + rgb[1] + rgb[2]) * (m_heights[y] - m_heights[y + 1]);
    };
    std::vector<double> row_sums(m_picture.height);
    for_each_index(m_picture.height, [&](int y) {
        for (int x = 0; x < m_picture.width; ++x) row_sums[y] += brightness(x, y);
    });
    const double sun = kSunShare * std::accumulate(row_sums.begin(), row_sums.end(), 0.0);
    for (int y = 0; y < m_picture.height; ++y) {
        if (row_sums[y] <= sun) continue;
        for (int x = 0; x < m_picture.width; ++x) {
            if (brightness(x, y) > sun) m_sun_rows[y] = m_sun_columns[x] = true;
        }
    }
}

}  // namespace burnish
