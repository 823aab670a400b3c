#include <burnish/composite/sample_grid.h>

#include <burnish/base/error.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kLargestFactor = 16;

std::string size_text(const Window& window) { return std::to_string(window.width) + "x" + std::to_string(window.height); }

std::string window_text(const Window& w) { return size_text(w) + " at " + std::to_string(w.x) + "," + std::to_string(w.y); }

int common_factor(const AovFrame& frame, const AovFrame& fine) {
    const Window &coarse = frame.display_window, &large = fine.display_window;
    const int factor = large.width / std::max(coarse.width, 1);
    if (factor >= 1 && factor <= kLargestFactor && large.width == factor * coarse.width &&
        large.height == factor * coarse.height)
        return factor;
    throw Error(ErrorCode::size_mismatch, "fine_aovs: " + fine.label() + " is " + size_text(large) + ", " + frame.label() +
                                              " is " + size_text(coarse) + ": expected a whole multiple of it, up to " +
                                              std::to_string(kLargestFactor) + "; render the AOVs at " +
                                              size_text({0, 0, 2 * coarse.width, 2 * coarse.height}) + " or " +
                                              size_text({0, 0, 4 * coarse.width, 4 * coarse.height}));
}

bool overlap(const Window& a, const Window& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

}  // namespace

Window SampleGrid::samples_of(const Window& pixels) const {
    return {x + factor * pixels.x, y + factor * pixels.y, factor * pixels.width, factor * pixels.height};
}

SampleGrid sample_grid(const AovFrame& frame, const AovFrame& fine) {
    SampleGrid grid{common_factor(frame, fine), 0, 0};
    grid.x = fine.display_window.x - grid.factor * frame.display_window.x;
    grid.y = fine.display_window.y - grid.factor * frame.display_window.y;
    return grid;
}

void check_samples(const SampleGrid& grid, const AovFrame& frame, const AovFrame& fine) {
    const Window wanted = grid.samples_of(frame.data_window);
    if (!overlap(wanted, fine.data_window))
        throw Error(ErrorCode::size_mismatch, "fine_aovs: " + fine.label() + " has pixels in " + window_text(fine.data_window) +
                                                  " only, those of " + frame.label() + " are " + window_text(wanted) +
                                                  " there; render both with the same crop");
}

}  // namespace burnish
