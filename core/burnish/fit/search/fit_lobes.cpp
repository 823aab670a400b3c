#include <burnish/base/error.h>
#include <burnish/fit/brdf_error.h>
#include <burnish/fit/search/fit_lobes.h>
#include <burnish/fit/search/fit_notes.h>
#include <burnish/fit/search/lobe_colors.h>
#include <burnish/fit/search/lobe_mixture_fit.h>

#include <chrono>

namespace burnish {
namespace {

constexpr ModelId kCandidates[] = {ModelId::kurt, ModelId::beckmann, ModelId::ggx};
constexpr size_t kColored = 32768;  // samples that stand for all while tints are fitted

/// Both sides of a table.
struct Table {
    TransferSamples upper, lower;
    bool round;

    Table(std::span<const BrdfSample> samples, bool isotropic)
        : upper(transfer_samples(samples, Side::reflection)),
          lower(transfer_samples(samples, Side::transmission)),
          round(isotropic) {}

    const TransferSamples& on(Side side) const { return side == Side::reflection ? upper : lower; }
};

void add_side(FitResult& result, const Table& table, Side side, const SideFit& fit) {
    const LobeMixture& best = fit.best();
    const size_t first = result.material.lobes.size();
    result.material.lobes.insert(result.material.lobes.end(), best.lobes.begin(), best.lobes.end());
    if (side == Side::reflection) result.material.kd = Color3f(best.kd);
    fit_colors(result.material, thinned(table.on(side), kColored), side, best.kd_range);
    result.parameters += best.parameters();
    for (std::string& note : side_notes(table.on(side), side, fit, first)) result.notes.push_back(std::move(note));
}

/// The error of both sides together, mean of the channels.
double whole_error(const Material& material, const Table& table) {
    double error = 0, share = 0;
    for (const Side side : {Side::reflection, Side::transmission}) {
        const TransferSamples& samples = table.on(side);
        const Color3f l1 = l1_error(model_transfer(material, samples, side), samples);
        error += samples.share * (l1.x + l1.y + l1.z) / 3;
        share += samples.share;
    }
    return share > 0 ? error / share : 0;
}

FitResult fit_model(const Table& table, ModelId model, const FitSettings& settings, const Progress& progress) {
    FitResult result;
    const float upper = table.lower.size() == 0 ? 1.0f : table.upper.size() == 0 ? 0.0f : 0.5f;  // share of the time
    for (const Side side : {Side::reflection, Side::transmission}) {
        if (table.on(side).size() == 0) continue;
        const Progress part = side == Side::reflection ? part_of(progress, 0, upper) : part_of(progress, upper, 1);
        add_side(result, table, side, fit_side(table.on(side), side, model, table.round, settings, part));
    }
    result.l1 = whole_error(result.material, table);
    return result;
}

/// The model of least error, where each number has to be worth kGainPerNumber of it.
FitResult fit_best_model(const Table& table, const FitSettings& settings, const Progress& progress) {
    const auto price = [](const FitResult& result) { return result.l1 * (1 + kGainPerNumber * result.parameters); };
    FitResult best;
    constexpr auto kModels = static_cast<float>(std::size(kCandidates));
    for (size_t i = 0; i < std::size(kCandidates); ++i) {
        const auto done = static_cast<float>(i);
        FitResult other = fit_model(table, kCandidates[i], settings, part_of(progress, done / kModels, (done + 1) / kModels));
        if (i == 0 || price(other) < price(best)) best = std::move(other);
    }
    return best;
}

}  // namespace

FitResult fit_lobes(std::span<const BrdfSample> samples, bool isotropic, const FitSettings& settings,
                    const Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    const Table table(samples, isotropic);
    if (table.upper.size() + table.lower.size() == 0)
        throw Error(ErrorCode::bad_argument,
                    "a fit needs measured pairs above 0, found none among " + std::to_string(samples.size()));
    FitResult result =
        settings.model ? fit_model(table, *settings.model, settings, progress) : fit_best_model(table, settings, progress);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

FitResult fit_lobes(const MeasuredBrdf& measured, const FitSettings& settings, const Progress& progress) {
    FitResult result = fit_lobes(measured.samples(), measured.is_isotropic(), settings, progress);
    if (measured.is_isotropic() && measured.is_dense())
        result.normalised_l2 = brdf_error(BrdfGrid({}, measured), result.material).worst_channel();
    return result;
}

double l1_error(const MeasuredBrdf& measured, const Material& material) {
    return whole_error(material, Table(measured.samples(), measured.is_isotropic()));
}

}  // namespace burnish
