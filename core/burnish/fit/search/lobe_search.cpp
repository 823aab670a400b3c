#include <burnish/base/parallel.h>
#include <burnish/fit/search/absolute_fit.h>
#include <burnish/fit/search/lobe_basis.h>
#include <burnish/fit/search/lobe_search.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr int kCoarse = 10, kFine = 5;  // points an axis
constexpr int kLevels = 4;              // fine ones
constexpr double kMaxPoints = 4096;     // of a grid; models of many numbers get coarser ones
constexpr int kBatch = 64;              // points between two reports
constexpr float kVisible = 0.1f;        // share of what was measured

/// A grid over the free numbers of a shape: `count` points an axis, `step` apart, from `low`; in units of the ranges.
struct Grid {
    std::vector<double> low, step;
    std::vector<int> count;

    int points() const {
        int product = 1;
        for (const int n : count) product *= n;
        return product;
    }
    std::vector<double> at(int point) const {
        std::vector<double> units(low.size());
        for (size_t i = 0; i < low.size(); point /= count[i++]) units[i] = low[i] + step[i] * (point % count[i]);
        return units;
    }
};

class Search {
public:
    Search(const LobeSpace& space, const TransferSamples& samples, const std::vector<float>& target, const Progress& progress)
        : m_space(space), m_samples(samples), m_measured(grey(samples.p)), m_target(target), m_progress(progress) {}

    std::vector<FoundLobe> run(int valleys) const {
        const Grid coarse = whole_space();
        const std::vector<FoundLobe> points = all(coarse, part_of(m_progress, 0, kCoarseShare));
        std::vector<FoundLobe> found;
        for (const int start : valley_floors(coarse, points, valleys)) found.push_back(refined(coarse, start, points));
        std::ranges::stable_sort(found, {}, &FoundLobe::error);
        return found;
    }

private:
    static constexpr float kCoarseShare = 0.6f;  // of the time; the finer grids are reported as its end

    Grid whole_space() const {
        int free = 0;
        for (const ShapeParameter& parameter : m_space.shape) free += parameter.range.max > parameter.range.min;
        const int n = std::clamp(static_cast<int>(std::pow(kMaxPoints, 1.0 / std::max(free, 1))), 3, kCoarse);
        Grid grid;
        for (const ShapeParameter& parameter : m_space.shape) {
            const bool fixed = parameter.range.max == parameter.range.min;
            grid.low.push_back(0);
            grid.count.push_back(fixed ? 1 : n);
            grid.step.push_back(fixed ? 0 : 1.0 / (n - 1));
        }
        return grid;
    }

    FoundLobe best_of_shape(const std::vector<double>& units) const {
        thread_local LobeBasis basis;
        thread_local AbsoluteScratch scratch;
        FoundLobe found{m_space.at(units)};
        lobe_basis(found.lobe, m_space.r0, m_samples, 0, m_samples.size(), basis);
        const AbsoluteFit fit =
            fit_absolute({m_target, basis.low, basis.high, m_samples.weight}, static_cast<float>(m_space.strength.min),
                         static_cast<float>(m_space.strength.max), scratch);
        set_weights(fit.first, fit.second, m_space, found.lobe);
        for (size_t j = 0; j < m_target.size(); ++j) basis.low[j] = fit.first * basis.low[j] + fit.second * basis.high[j];
        const bool borne_out = is_borne_out(basis.low, m_measured, m_space.parameters());
        found.error = borne_out ? fit.error : std::numeric_limits<double>::infinity();
        return found;
    }

    std::vector<FoundLobe> all(const Grid& grid, const Progress& progress) const {
        std::vector<FoundLobe> points(static_cast<size_t>(grid.points()));
        for (int begin = 0; begin < grid.points(); begin += kBatch) {
            for_each_index(std::min(kBatch, grid.points() - begin),
                           [&](int i) { points[static_cast<size_t>(begin + i)] = best_of_shape(grid.at(begin + i)); });
            progress.report("search", static_cast<float>(begin) / static_cast<float>(grid.points()));
        }
        return points;
    }

    /// Points no worse than their neighbours along the axes, best first.
    static std::vector<int> valley_floors(const Grid& grid, const std::vector<FoundLobe>& points, int wanted) {
        std::vector<int> floors;
        for (int point = 0; point < grid.points(); ++point) {
            bool lowest = true;
            int stride = 1;
            for (const int n : grid.count) {
                const int here = point / stride % n;
                for (const int side : {-1, 1})
                    if (here + side >= 0 && here + side < n)
                        lowest &= points[static_cast<size_t>(point)].error <=
                                  points[static_cast<size_t>(point + side * stride)].error;
                stride *= n;
            }
            if (lowest && std::isfinite(points[static_cast<size_t>(point)].error)) floors.push_back(point);
        }
        std::ranges::stable_sort(floors, {}, [&](int point) { return points[static_cast<size_t>(point)].error; });
        floors.resize(std::min(floors.size(), static_cast<size_t>(wanted)));
        return floors;
    }

    /// Finer and finer grids, each over the cells next to the best point of the last.
    FoundLobe refined(Grid grid, int start, const std::vector<FoundLobe>& points) const {
        FoundLobe best = points[static_cast<size_t>(start)];
        std::vector<double> centre = grid.at(start);
        for (int level = 0; level < kLevels; ++level) {
            for (size_t i = 0; i < centre.size(); ++i) {
                if (grid.count[i] == 1) continue;
                grid.low[i] = std::clamp(centre[i] - grid.step[i], 0.0, std::max(0.0, 1 - 2 * grid.step[i]));
                grid.step[i] *= 2.0 / (kFine - 1);
                grid.count[i] = kFine;
            }
            const std::vector<FoundLobe> finer = all(grid, part_of(m_progress, kCoarseShare, kCoarseShare));
            const auto lowest = std::ranges::min_element(finer, {}, &FoundLobe::error);
            centre = grid.at(static_cast<int>(lowest - finer.begin()));
            if (lowest->error < best.error) best = *lowest;
        }
        return best;
    }

    const LobeSpace& m_space;
    const TransferSamples& m_samples;
    const std::vector<float> m_measured;
    const std::vector<float>& m_target;
    const Progress& m_progress;
};

}  // namespace

bool is_borne_out(std::span<const float> lobe, std::span<const float> measured, int numbers) {
    int seen = 0;
    for (size_t j = 0; j < lobe.size(); ++j) seen += lobe[j] > kVisible * measured[j];
    return seen >= numbers;
}

std::vector<FoundLobe> search_lobe(const LobeSpace& space, const TransferSamples& samples, const std::vector<float>& target,
                                   int valleys, const Progress& progress) {
    if (space.strength.max <= 0 || samples.size() == 0) return {};
    return Search(space, samples, target, progress).run(valleys);
}

}  // namespace burnish
