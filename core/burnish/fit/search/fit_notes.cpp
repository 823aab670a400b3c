#include <burnish/fit/search/fit_notes.h>
#include <burnish/fit/search/l1_polish.h>
#include <burnish/fit/search/retro_reflection.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace burnish {
namespace {

constexpr double kMuchUnexplained = 0.1;  // of the light in the table
constexpr double kVague = 0.1;            // a number's standard error, of its range or, for numbers of any size, of itself

std::string percent(double share) {
    std::ostringstream text;
    text.precision(2);
    text << 100 * share << " %";
    return text.str();
}

std::string side_name(Side side) { return side == Side::reflection ? "reflection" : "transmission"; }

/// How many lobes, and what one more would have gained.
std::string choice_note(Side side, const SideFit& fit) {
    const auto lobes = [](size_t count) { return std::to_string(count) + (count == 1 ? " lobe" : " lobes"); };
    const LobeMixture& best = fit.best();
    std::string note = side_name(side) + ": " + lobes(best.lobes.size()) + ", error " + percent(best.error);
    if (fit.chosen + 1 < fit.by_lobes.size())
        note += "; " + lobes(fit.chosen + 1) + " would lower it by " +
                percent(1 - fit.by_lobes[fit.chosen + 1].error / best.error) + " of that, which does not pay";
    return note;
}

void add_residual_note(const TransferSamples& samples, Side side, const SideFit& fit, std::vector<std::string>& notes) {
    const std::vector<float> p = grey(samples.p);
    double light = 0;
    for (size_t j = 0; j < p.size(); ++j) light += static_cast<double>(samples.weight[j]) * p[j];
    const double unexplained = std::max(0.0, fit.best().error - fit.noise) / light;
    if (unexplained > kMuchUnexplained)
        notes.push_back(side_name(side) + ": the model misses the measurement by " + percent(unexplained) +
                        " of its light, noise apart; compare the slices before using it");
}

void add_retro_note(const TransferSamples& samples, std::vector<std::string>& notes) {
    const RetroReflection retro = retro_reflection(samples);
    if (!retro.seen()) return;
    std::ostringstream text;
    text.precision(2);
    text << "reflects back towards the light; no model here does that (f is " << retro.back << " there, " << retro.around
         << " around it, " << retro.mirror << " at the mirror direction)";
    notes.push_back(text.str());
}

/// Numbers of lobe `n` that the table hardly tells, with what they are known to; "" if it tells all of them.
std::string vague_numbers(const LobeMixture& mixture, const std::vector<double>& errors, size_t n) {
    const std::vector<Unknown> list = unknowns(mixture);
    std::ostringstream text;
    text.precision(2);
    for (size_t u = 0; u < list.size(); ++u) {
        const bool of_lobe = list[u].kind == Unknown::Kind::r0 || list[u].kind == Unknown::Kind::shape;
        if (!of_lobe || list[u].lobe != n) continue;
        const bool ratio = list[u].kind == Unknown::Kind::shape && mixture.spaces[n].shape[list[u].shape].logarithmic;
        const double scale = ratio ? 1 : list[u].range.max - list[u].range.min;
        if (!(errors[u] > kVague * scale)) continue;
        text << (text.tellp() > 0 ? ", " : "") << list[u].name(mixture);
        if (!ratio && errors[u] < scale) text << " (" << errors[u] << ")";
        if (ratio && errors[u] < 1) text << " (" << percent(errors[u]) << ")";
    }
    return text.str();
}

void add_vague_notes(const TransferSamples& samples, const LobeMixture& mixture, size_t first,
                     std::vector<std::string>& notes) {
    const std::vector<double> errors = standard_errors(mixture, samples, grey(samples.p));
    for (size_t n = 0; n < mixture.lobes.size(); ++n)
        if (const std::string vague = vague_numbers(mixture, errors, n); !vague.empty())
            notes.push_back("lobe " + std::to_string(first + n + 1) +
                            ": the table hardly tells these numbers (standard error): " + vague +
                            (vague.find("r0") != std::string::npos ? "; ks r0 is better known than ks and r0" : ""));
}

}  // namespace

std::vector<std::string> side_notes(const TransferSamples& samples, Side side, const SideFit& fit, size_t first) {
    std::vector<std::string> notes{choice_note(side, fit)};
    if (side == Side::reflection) add_retro_note(samples, notes);
    add_residual_note(samples, side, fit, notes);
    add_vague_notes(samples, fit.best(), first, notes);
    if (side == Side::transmission && !fit.best().lobes.empty())
        notes.push_back(
            "lobe " + std::to_string(first + 1) +
            " on: light through a sheet tells kt (1 - r0) alone, so r0 was taken as that of glass; light that comes "
            "through diffusely is outside the material and becomes a wide lobe");
    return notes;
}

}  // namespace burnish
