#include <burnish/base/parallel.h>
#include <burnish/material/measured/merl_holes.h>
#include <burnish/material/measured/merl_table.h>

#include <algorithm>

namespace burnish {
namespace {

bool is_hole(const Color3f& f) { return f == kHole; }

/// Steps from each place of the circle to the nearest value at or before it.
template <class At>
std::vector<int> steps_to_value(int count, At at) {
    std::vector<int> steps(static_cast<size_t>(count), 0);
    int since = 0;
    for (int i = 0; i < 2 * count; ++i) {  // the second round knows what lies before the first place
        since = is_hole(at(i % count)) ? since + 1 : 0;
        steps[static_cast<size_t>(i % count)] = since;
    }
    return steps;
}

/// False where there is nothing to fill it with.
bool fill_row(Color3f* row, int count) {
    if (std::all_of(row, row + count, is_hole)) return false;
    const std::vector<int> back = steps_to_value(count, [&](int i) { return row[i]; });
    const std::vector<int> ahead = steps_to_value(count, [&](int i) { return row[count - 1 - i]; });
    const std::vector<Color3f> measured(row, row + count);
    for (int i = 0; i < count; ++i) {
        const int b = back[static_cast<size_t>(i)], a = ahead[static_cast<size_t>(count - 1 - i)];
        if (b == 0) continue;
        const Color3f before = measured[static_cast<size_t>((i - b + count) % count)];
        const Color3f after = measured[static_cast<size_t>((i + a) % count)];
        row[i] = (before * static_cast<float>(a) + after * static_cast<float>(b)) / static_cast<float>(a + b);
    }
    return true;
}

/// Fills what `filled` says is empty from the neighbour before it, the leading ones from the first that is not.
void copy_into_empty(Color3f* blocks, size_t size, const std::vector<char>& filled) {
    const auto first = std::find(filled.begin(), filled.end(), 1) - filled.begin();
    const auto block = [&](auto i) { return blocks + static_cast<size_t>(i) * size; };
    if (first == static_cast<std::ptrdiff_t>(filled.size())) return;
    for (std::ptrdiff_t i = 0; i < first; ++i) std::copy_n(block(first), size, block(i));
    for (size_t i = static_cast<size_t>(first) + 1; i < filled.size(); ++i)
        if (!filled[i]) std::copy_n(block(i - 1), size, block(i));
}

}  // namespace

void fill_holes(std::vector<Color3f>& cells) {
    constexpr size_t kRow = MerlTable::kPhiD, kRows = MerlTable::kThetaD, kPlane = kRow * kRows;
    std::vector<char> plane_filled(MerlTable::kThetaH);
    for_each_index(MerlTable::kThetaH, [&](int h) {
        Color3f* plane = cells.data() + static_cast<size_t>(h) * kPlane;
        std::vector<char> row_filled(kRows);
        for (size_t d = 0; d < kRows; ++d) row_filled[d] = fill_row(plane + d * kRow, MerlTable::kPhiD);
        copy_into_empty(plane, kRow, row_filled);
        plane_filled[static_cast<size_t>(h)] = !is_hole(*plane);
    });
    copy_into_empty(cells.data(), kPlane, plane_filled);
    if (is_hole(cells.front())) cells.assign(cells.size(), Color3f(0));
}

}  // namespace burnish
