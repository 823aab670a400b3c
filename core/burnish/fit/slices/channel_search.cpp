#include <burnish/fit/slices/channel_search.h>

#include <algorithm>
#include <cmath>

namespace burnish {

namespace {

constexpr size_t kStarts = 4;  // valleys of a scan that are followed to the bottom

/// All combinations of the scan's values, the last number fastest.
struct Scan {
    std::vector<std::vector<double>> shapes{{}};
    std::vector<size_t> counts;

    Scan(const ShapeFamily& family, std::span<const SearchRange> ranges) {
        for (size_t i = 0; i < ranges.size(); ++i) {
            const int count = ranges[i].is_fixed() ? 1 : family.parameters[i].scan;
            counts.push_back(static_cast<size_t>(count));
            std::vector<std::vector<double>> longer;
            for (const auto& shape : shapes)
                for (int k = 0; k < count; ++k) {
                    longer.push_back(shape);
                    longer.back().push_back(ranges[i].is_fixed() ? ranges[i].min : ranges[i].at((k + 0.5) / count));
                }
            shapes = std::move(longer);
        }
    }

    /// Whether no neighbour along one of the numbers costs less: shapes lie in long valleys, across which diagonals lead.
    bool is_valley(std::span<const double> costs, size_t at) const {
        size_t stride = 1;
        for (size_t i = counts.size(); i-- > 0; stride *= counts[i]) {
            const size_t k = at / stride % counts[i];
            if ((k > 0 && costs[at - stride] < costs[at]) || (k + 1 < counts[i] && costs[at + stride] < costs[at]))
                return false;
        }
        return true;
    }
};

SearchRange range_of(const FamilyNumber& parameter) { return {parameter.min, parameter.max, parameter.logarithmic}; }

/// A shape of sgd with the numbers of the fitted G1 that come nearest to Smith's, within the ranges that fits may use.
std::vector<double> with_smith_masking(const std::vector<double>& shape) {
    constexpr int kAngles = 40;
    const ShapeFamily &smith = *shape_family("sgd"), &free = sgd_with_free_masking();
    std::vector<double> theta, start = shape;
    for (int k = 0; k < kAngles; ++k) theta.push_back((k + 0.5) * std::numbers::pi / 2 / kAngles);
    const std::vector<double> wanted = smith.G1(shape, theta);
    std::vector<SearchRange> ranges;
    for (const double number : shape) ranges.push_back({number, number});
    for (size_t i = shape.size(); i < free.parameters.size(); ++i) ranges.push_back(range_of(free.parameters[i]));
    start.insert(start.end(), {2, 1.4, 10});
    return least_squares(ranges, start, [&](std::span<const double> numbers, std::vector<double>& residuals) {
        residuals = free.G1(numbers, theta);
        for (size_t k = 0; k < wanted.size(); ++k) residuals[k] -= wanted[k];
    });
}

}  // namespace

FitGrids::FitGrids(const BrdfGrid& grid)
    : all(grid),
      cells(grid.subset([](const BrdfGrid::Cell& c) { return c.d % 5 == 2 && c.p % 3 == 1; })),
      coarse(grid.subset([](const BrdfGrid::Cell& c) { return c.d % 10 == 7 && c.p % 9 == 4; })),
      slice_h(grid.subset([](const BrdfGrid::Cell& c) { return c.d == 0; })),
      slice_d(grid.subset([](const BrdfGrid::Cell& c) { return c.h == 0; })) {}

ChannelSearch::ChannelSearch(const FitGrids& grids, int channel, const ShapeFamily& family, const LobeBounds& bounds)
    : m_family(family),
      m_bounds(bounds),
      m_all(grids.all, channel, Weighing::error, FresnelTerms::bent),
      m_cells(grids.cells, channel, Weighing::error, FresnelTerms::bent),
      m_coarse(grids.coarse, channel, Weighing::error, FresnelTerms::bent),
      m_slice_h(grids.slice_h, channel, Weighing::ratio, FresnelTerms::constant),
      m_slice_d(grids.slice_d, channel, Weighing::ratio, FresnelTerms::bent) {}

ChannelFit ChannelSearch::two_slices() const {
    ChannelFit best;
    for (const Shapes& start : best_starts(m_slice_h, {})) {
        const ChannelFit fit = descend(m_slice_h, m_family, m_bounds.shape, start);
        if (best.lobes.empty() || fit.cost < best.cost) best = fit;
    }
    LinearBounds bounds = m_bounds.linear;
    bounds.kd = {best.kd, best.kd};
    return m_slice_d.fit(m_family, Shapes{best.lobes[0].shape}, bounds);
}

ChannelFit ChannelSearch::polished(const ChannelFit& start) const {
    std::vector<Shapes> starts = best_starts(m_coarse, {});
    starts.push_back({start.lobes[0].shape});
    const ChannelFit fit = best_of(m_family, m_bounds.shape, starts);
    return fit.cost < m_cells.cost(m_family, start) ? fit : start;
}

ChannelFit ChannelSearch::with_free_masking(const ChannelFit& start) const {
    const ShapeFamily& family = sgd_with_free_masking();
    std::vector<SearchRange> ranges = m_bounds.shape;
    for (size_t i = ranges.size(); i < family.parameters.size(); ++i) ranges.push_back(range_of(family.parameters[i]));
    std::vector<Shapes> starts = best_starts(m_coarse, {});
    starts.push_back({start.lobes[0].shape});
    for (Shapes& shapes : starts) shapes[0] = with_smith_masking(shapes[0]);
    return best_of(family, ranges, starts);
}

ChannelFit ChannelSearch::with_another_lobe(const ChannelFit& fit) const {
    Shapes fixed;
    for (const LobeFit& lobe : fit.lobes)
        fixed.emplace_back(lobe.shape.begin(), lobe.shape.begin() + static_cast<std::ptrdiff_t>(m_bounds.shape.size()));
    return best_of(m_family, m_bounds.shape, best_starts(m_coarse, fixed));
}

ChannelFit ChannelSearch::best_of(const ShapeFamily& family, std::span<const SearchRange> each,
                                  std::span<const Shapes> starts) const {
    constexpr size_t kFinalists = 2;
    std::vector<std::pair<double, Shapes>> reached;
    for (const Shapes& start : starts) {
        Shapes shapes;
        for (const LobeFit& lobe : descend(m_coarse, family, each, start).lobes) shapes.push_back(lobe.shape);
        const double cost = m_cells.fit(family, shapes, m_bounds.linear).cost;
        reached.emplace_back(cost, std::move(shapes));
    }
    std::stable_sort(reached.begin(), reached.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    ChannelFit best;
    for (size_t i = 0; i < std::min(kFinalists, reached.size()); ++i) {
        const ChannelFit fit = descend(m_cells, family, each, reached[i].second);
        if (best.lobes.empty() || fit.cost < best.cost) best = fit;
    }
    return best;
}

double ChannelSearch::error(const ShapeFamily& family, const ChannelFit& fit) const {
    return std::sqrt(m_all.cost(family, fit));
}

double ChannelSearch::error(const ChannelFit& fit) const { return error(m_family, fit); }

ChannelFit ChannelSearch::descend(const ChannelProblem& problem, const ShapeFamily& family, std::span<const SearchRange> each,
                                  const Shapes& start) const {
    std::vector<SearchRange> ranges;
    std::vector<double> numbers;
    for (const auto& shape : start) {
        ranges.insert(ranges.end(), each.begin(), each.end());
        numbers.insert(numbers.end(), shape.begin(), shape.end());
    }
    const auto shapes_of = [&](std::span<const double> flat) {
        Shapes shapes;
        for (size_t i = 0; i < flat.size(); i += each.size()) {
            const auto shape = flat.subspan(i, each.size());
            shapes.emplace_back(shape.begin(), shape.end());
        }
        return shapes;
    };
    const std::vector<double> found =
        least_squares(ranges, numbers, [&](std::span<const double> at, std::vector<double>& residuals) {
            problem.fit(family, shapes_of(at), m_bounds.linear, &residuals);
        });
    return problem.fit(family, shapes_of(found), m_bounds.linear);
}

std::vector<ChannelSearch::Shapes> ChannelSearch::best_starts(const ChannelProblem& problem, const Shapes& fixed) const {
    const Scan scan(m_family, m_bounds.shape);
    const auto with = [&](const std::vector<double>& shape) {
        Shapes shapes = fixed;
        shapes.push_back(shape);
        return shapes;
    };
    std::vector<double> costs;
    for (const auto& shape : scan.shapes) costs.push_back(problem.fit(m_family, with(shape), m_bounds.linear).cost);
    std::vector<size_t> valleys;
    for (size_t j = 0; j < costs.size(); ++j)
        if (scan.is_valley(costs, j)) valleys.push_back(j);
    std::stable_sort(valleys.begin(), valleys.end(), [&](size_t a, size_t b) { return costs[a] < costs[b]; });
    std::vector<Shapes> best;
    for (size_t i = 0; i < std::min(kStarts, valleys.size()); ++i) best.push_back(with(scan.shapes[valleys[i]]));
    return best;
}

}  // namespace burnish
