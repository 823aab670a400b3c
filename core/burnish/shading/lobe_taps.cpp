#include <burnish/shading/lobe_taps.h>

#include <burnish/shading/fitted.h>

#include <numbers>

namespace burnish {
namespace {

/// ln of the width of a Gaussian that weighs as much as a cap of this solid angle: 2 pi sigma^2 = omega.
float log_sigma_of(float omega) { return 0.5f * std::log(omega / (2 * kPi)); }

EstimatorSettings settled_here(const LobeParameters& lobe, EstimatorSettings settings) {
    settings.adaptive = false;
    if (settings.kind == EstimatorKind::split_sum) settings.kind = EstimatorKind::fitted, settings.samples = 1;
    return settled(lobe, settings);
}

}  // namespace

LobeTaps::LobeTaps(const LobeParameters& lobe, const EstimatorSettings& settings) : m_lobe(lobe) {
    const EstimatorSettings own = settled_here(lobe, settings);
    if (own.kind == EstimatorKind::fitted || own.kind == EstimatorKind::regular) prepare_tail();
    const auto log_sigma = [](float sigma) { return std::log(sigma); };
    if (own.kind == EstimatorKind::fitted) {
        m_table = fitted_table(lobe, own.samples, log_sigma);
        return;
    }
    const float bias = own.level_bias * std::numbers::ln2_v<float>;
    if (own.kind == EstimatorKind::preconvolved)
        m_rule.emplace(lobe, own, log_sigma);
    else
        m_rule.emplace(lobe, own, [bias](float omega) { return log_sigma_of(omega) + bias; });
    const int taps = m_rule->tap_count(lobe.mx, lobe.my);
    if (TapTable::covers(lobe, taps)) m_table = TapTable(lobe, taps, *m_rule);
}

/// Other estimators draw their taps from all of the lobe.
void LobeTaps::prepare_tail() {
    m_tail = TailTaps(m_lobe);
    const int count = m_tail.count();
    if (count == 0 || !TapTable::covers(m_lobe, count)) return;
    m_tail_table = TapTable(m_lobe, count, [this](const ShadingPoint& point, std::span<Tap> taps) { m_tail.at(point, taps); });
}

void LobeTaps::at(const ShadingPoint& point, std::vector<Tap>& taps) const {
    const bool tabulated = m_table.tap_count() > 0;
    taps.resize(static_cast<size_t>(tabulated ? m_table.tap_count() : m_rule->tap_count(point.mx, point.my)));
    if (tabulated)
        m_table.at(point, taps);
    else
        (*m_rule)(point, taps);
    if (m_tail.count() > 0) add_tail(point, taps);
}

/// The tail's energy is taken from the other taps.
void LobeTaps::add_tail(const ShadingPoint& point, std::vector<Tap>& taps) const {
    const size_t count = taps.size();
    taps.resize(count + static_cast<size_t>(m_tail.count()));
    const std::span<Tap> all(taps), own = all.first(count), tail = all.subspan(count);
    if (m_tail_table.tap_count() > 0)
        m_tail_table.at(point, tail);
    else
        m_tail.at(point, tail);
    Color3f whole(0, 0, 0), far(0, 0, 0);
    for (const Tap& tap : own) whole += tap.weight;
    for (const Tap& tap : tail) far += tap.weight;
    for (Tap& tap : own)
        for (int k = 0; k < 3; ++k) tap.weight[k] *= std::max(1 - far[k] / std::max(whole[k], 1e-20f), 0.0f);
}

}  // namespace burnish
