#include <burnish/light/sample_table.h>

#include <burnish/base/parallel.h>

#include <algorithm>
#include <numeric>

namespace burnish {
namespace {

constexpr float kBelowOne = 0x1.fffffep-1f;

/// Index of the interval of running sums that holds share u of their total, and the fraction inside it.
int find_interval(const double* sums, int count, float u, float& fraction) {
    const double target = static_cast<double>(u) * sums[count - 1];
    const int index = std::min(static_cast<int>(std::upper_bound(sums, sums + count, target) - sums), count - 1);
    const double below = index > 0 ? sums[index - 1] : 0.0;
    const double width = sums[index] - below;
    fraction = width > 0.0 ? std::clamp(static_cast<float>((target - below) / width), 0.0f, kBelowOne) : 0.5f;
    return index;
}

}  // namespace

SampleTable::SampleTable(int width, int height, std::vector<double> weights)
    : m_width(width), m_columns(std::move(weights)), m_rows(height) {
    const auto accumulate = [&] {
        for_each_index(height, [&](int y) {
            double* row = &m_columns[static_cast<size_t>(y) * width];
            std::partial_sum(row, row + width, row);
            m_rows[y] = row[width - 1];
        });
        std::partial_sum(m_rows.begin(), m_rows.end(), m_rows.begin());
    };
    accumulate();
    if (m_rows.back() > 0.0) return;
    std::fill(m_columns.begin(), m_columns.end(), 1.0);
    accumulate();
}

SampleTable::Place SampleTable::sample(const Vec2f& u) const {
    Place place;
    place.row = find_interval(m_rows.data(), height(), u.y, place.y);
    place.column = find_interval(&m_columns[static_cast<size_t>(place.row) * m_width], m_width, u.x, place.x);
    return place;
}

double SampleTable::probability(int column, int row) const {
    const double* sums = &m_columns[static_cast<size_t>(row) * m_width];
    return (sums[column] - (column > 0 ? sums[column - 1] : 0.0)) / m_rows.back();
}

}  // namespace burnish
