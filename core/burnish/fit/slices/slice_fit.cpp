#include <burnish/fit/slices/slice_fit.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/fit/slices/channel_search.h>
#include <burnish/fit/slices/slice_material.h>
#include <burnish/material/measured/measured_brdf.h>
#include <burnish/material/model.h>

#include <chrono>
#include <cmath>
#include <memory>

namespace burnish {

namespace {

constexpr GridSize kTableGrid{90, 90, 36, 2};
constexpr double kExact = 1e-4;  // errors below this are nobody's to lower

/// A fit of all channels at one stage, with its errors.
struct Stage {
    std::array<FittedChannel, 3> channels;
    Channels error{};

    int numbers(const LobeBounds& bounds) const;
    double total() const { return std::sqrt(error[0] * error[0] + error[1] * error[1] + error[2] * error[2]); }
};

/// Of a lobe whose shape has `numbers` numbers; the ones beyond those of the bounds are free.
int free_numbers(const LobeBounds& bounds, size_t numbers) {
    int count = 0;
    for (size_t i = 0; i < numbers; ++i) count += i >= bounds.shape.size() || !bounds.shape[i].is_fixed();
    for (const NumberRange& range : {bounds.linear.ks, bounds.linear.f0, bounds.linear.f1}) count += range.max > range.min;
    return count;
}

int Stage::numbers(const LobeBounds& bounds) const {
    int count = 0;
    for (const auto& [family, fit] : channels)
        count += (bounds.linear.kd.max > bounds.linear.kd.min) +
                 static_cast<int>(fit.lobes.size()) * free_numbers(bounds, family->parameters.size());
    return count;
}

/// Whether a second lobe in all channels is worth its numbers: error times numbers falls, those of masking not counted.
bool second_lobe_pays(const Stage& one, const Stage& two, const LobeBounds& bounds) {
    const int lobe = free_numbers(bounds, bounds.shape.size()), diffuse = bounds.linear.kd.max > bounds.linear.kd.min;
    return two.total() * (diffuse + 2 * lobe) < one.total() * (diffuse + lobe);
}

NumberRange bounded(const ParameterBounds& bounds, const std::string& name, NumberRange range) {
    const auto found = bounds.find(name);
    if (found == bounds.end()) return range;
    if (found->second.min < range.min || found->second.max > range.max || found->second.min > found->second.max)
        throw Error(ErrorCode::bad_argument, "bounds of " + name + ": expected a range within [" + std::to_string(range.min) +
                                                 ", " + std::to_string(range.max) + "]");
    return found->second;
}

LobeBounds lobe_bounds(const ShapeFamily& family, const ParameterBounds& bounds) {
    LobeBounds result;
    std::string known = "kd, ks, r0, f1";
    size_t used = bounds.count("kd") + bounds.count("ks") + bounds.count("r0") + bounds.count("f1");
    for (const FamilyNumber& number : family.parameters) {
        const std::string name(number.name);
        const NumberRange range = bounded(bounds, name, {number.min, number.max});
        result.shape.push_back({range.min, range.max, number.logarithmic});
        used += bounds.count(name);
        known += ", " + name;
    }
    if (used != bounds.size())
        throw Error(ErrorCode::bad_argument, "bounds: a fit of " + std::string(family.model) + " by slices knows " + known);
    result.linear.kd = bounded(bounds, "kd", result.linear.kd);
    result.linear.f0 = bounded(bounds, "r0", result.linear.f0);
    result.linear.f1 = bounded(bounds, "f1", result.linear.f1);
    result.linear.ks = bounded(bounds, "ks", result.linear.ks);
    if (bounds.count("ks")) result.linear.ks_unit = [&family](Shape shape) { return ks_unit(family, shape); };
    return result;
}

const ShapeFamily& family_of(const FitSettings& settings) {
    const std::string model(settings.model ? model_info(*settings.model).name : "sgd");
    if (const ShapeFamily* family = shape_family(model)) return *family;
    throw Error(ErrorCode::bad_argument, "a fit of " + model + " by slices: it knows sgd, beckmann, ggx and abc");
}

class SliceFitter {
public:
    SliceFitter(const BrdfGrid& grid, const ShapeFamily& family, const LobeBounds& bounds)
        : m_grids(grid), m_family(family), m_bounds(bounds) {
        for_each_channel([&](int c) { m_search[c] = std::make_unique<ChannelSearch>(m_grids, c, m_family, m_bounds); });
    }

    Stage slices() const {
        return stage([&](int c) { return m_search[c]->two_slices(); });
    }
    Stage polished(const Stage& start) const {
        Stage better = stage([&](int c) { return m_search[c]->polished(start.channels[c].fit); });
        for (size_t c = 0; c < 3; ++c)
            if (start.error[c] < better.error[c]) better.channels[c] = start.channels[c], better.error[c] = start.error[c];
        return better;
    }
    /// Channels decide for themselves: published fits have numbers of masking in any case.
    Stage with_masking(const Stage& start) const {
        constexpr double kLower = 0.98;
        Stage result = start;
        const ShapeFamily& free = sgd_with_free_masking();
        for_each_channel([&](int c) {
            if (start.error[c] < kExact * m_grids.all.max_albedo(c)) return;
            const ChannelFit fit = m_search[c]->with_free_masking(start.channels[c].fit);
            const double error = m_search[c]->error(free, fit);
            if (error < kLower * start.error[c]) result.channels[c] = {&free, fit}, result.error[c] = error;
        });
        return result;
    }
    /// `start`, or two lobes with Smith's masking in all channels.
    Stage with_lobes_that_pay(const Stage& start, bool anyway, std::vector<std::string>& notes) const {
        const BrdfError error = brdf_error(m_grids.all, start.error);
        if (!anyway && error.overall() < kExact) return start;
        const Stage two = stage([&](int c) { return m_search[c]->with_another_lobe(start.channels[c].fit); });
        if (anyway || second_lobe_pays(start, two, m_bounds)) return two;
        const int left = static_cast<int>(std::lround(100 * two.total() / start.total()));
        notes.push_back("a second lobe does not pay: it leaves " + std::to_string(left) + " % of the error");
        return start;
    }

private:
    static void for_each_channel(const std::function<void(int)>& work) { for_each_index(3, work); }

    Stage stage(const std::function<ChannelFit(int)>& fit) const {
        Stage result;
        for_each_channel([&](int c) {
            result.channels[c] = {&m_family, fit(c)};
            result.error[c] = m_search[c]->error(result.channels[c].fit);
        });
        return result;
    }

    FitGrids m_grids;
    const ShapeFamily& m_family;
    const LobeBounds& m_bounds;
    std::array<std::unique_ptr<ChannelSearch>, 3> m_search;
};

/// Share of what a channel shows, in the measure of the error, that the fit leaves: 1 for a black fit.
double share_left(const BrdfGrid& grid, int channel, double error) {
    double squares = 0;
    for (size_t j = 0; j < grid.cells().size(); ++j)
        squares += grid.cells()[j].weight * grid.f(channel)[j] * grid.f(channel)[j];
    return squares > 0 ? error / std::sqrt(squares) : 0;
}

void add_notes(const BrdfGrid& grid, const Stage& best, std::vector<std::string>& notes) {
    constexpr int kOutside = 20;  // percent that a fit may leave without a word
    constexpr const char* kNames[] = {"red", "green", "blue"};
    int worst = 0, most = 0;
    std::string masked;
    for (int c = 0; c < 3; ++c) {
        const int left = static_cast<int>(std::lround(100 * share_left(grid, c, best.error[c])));
        if (left > most) worst = c, most = left;
        if (best.channels[c].family == &sgd_with_free_masking())
            masked += (masked.empty() ? "" : ", ") + std::string(kNames[c]);
    }
    if (most > kOutside)
        notes.push_back(std::string(best.channels[0].family->model) + " leaves " + std::to_string(most) + " % of the " +
                        kNames[worst] + " channel unexplained: part of what it shows is outside the model");
    if (!masked.empty()) notes.push_back("masked by numbers of their own (lambda, c, k), not by Smith's: " + masked);
}

}  // namespace

SliceFit fit_slices(const BrdfGrid& grid, const FitSettings& settings, const Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    if (grid.cells().empty()) throw Error(ErrorCode::bad_argument, "the measurement has no value where directions are trusted");
    const ShapeFamily& family = family_of(settings);
    const LobeBounds bounds = lobe_bounds(family, settings.bounds);
    progress.report("reading slices", 0);
    const SliceFitter fitter(grid, family, bounds);
    const Stage slices = fitter.slices();
    progress.report("fitting the table", 0.1f);
    Stage best = fitter.polished(slices);
    SliceFit fit;
    if (family.model == "sgd") {
        progress.report("fitting masking", 0.3f);
        best = fitter.with_masking(best);
    }
    fit.one_lobe = brdf_error(grid, best.error);
    if (settings.max_lobes > 1) {
        progress.report("fitting a second lobe", 0.4f);
        best = fitter.with_lobes_that_pay(best, settings.fixed_lobes, fit.result.notes);
    }
    fit.error = brdf_error(grid, best.error);
    fit.slices = brdf_error(grid, slices.error);
    fit.result.material = slice_material(best.channels);
    fit.result.parameters = best.numbers(bounds);
    fit.result.normalised_l2 = fit.error.worst_channel();
    add_notes(grid, best, fit.result.notes);
    fit.result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    progress.report("fitting", 1);
    return fit;
}

SliceFit fit_slices(const MeasuredBrdf& measured, const FitSettings& settings, const Progress& progress) {
    if (!measured.is_isotropic() || measured.transmits())
        throw Error(ErrorCode::bad_argument,
                    measured.file() + ": a fit by slices is for isotropic reflection; use the grid search for this table");
    return fit_slices(BrdfGrid(kTableGrid, measured), settings, progress);
}

}  // namespace burnish
