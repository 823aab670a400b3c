#include <burnish/shading/lobe_taps.h>

#include <burnish/base/parallel.h>
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

LobeTaps::LobeTaps(const LobeParameters& lobe, const EstimatorSettings& settings, bool with_tail) : m_lobe(lobe) {
    const EstimatorSettings own = settled_here(lobe, settings);
    prepare(own);
    const bool is_short = own.kind == EstimatorKind::fitted || own.kind == EstimatorKind::regular;
    if (!with_tail || !is_short || settings.kind == EstimatorKind::split_sum) return;
    m_tail = TailTaps(lobe);
    if (table() && m_tail.count() > 0) m_table = joined_by_tail(m_table);
}

void LobeTaps::prepare(const EstimatorSettings& own) {
    const auto log_sigma = [](float sigma) { return std::log(sigma); };
    if (own.kind == EstimatorKind::fitted) {
        m_table = fitted_table(m_lobe, own.samples, log_sigma);
        return;
    }
    const float bias = own.level_bias * std::numbers::ln2_v<float>;
    if (own.kind == EstimatorKind::preconvolved)
        m_rule.emplace(m_lobe, own, log_sigma);
    else
        m_rule.emplace(m_lobe, own, [bias](float omega) { return log_sigma_of(omega) + bias; });
    const int taps = m_rule->tap_count(m_lobe.mx, m_lobe.my);
    if (TapTable::covers(m_lobe, taps)) m_table = TapTable(m_lobe, taps, *m_rule);
}

TapTable LobeTaps::joined_by_tail(const TapTable& own) const {
    const int count = own.tap_count() + m_tail.count();
    if (!TapTable::covers(m_lobe, count)) return own;
    TapTable joined(m_lobe, count);
    for_each_index(joined.node_count(), [&](int node) {
        const ShadingPoint point = joined.node_point(node);
        std::vector<Tap> taps(static_cast<size_t>(own.tap_count()));
        own.at(point, taps);
        add_tail(point, taps);
        joined.set(node, taps);
    });
    return joined;
}

/// The tail's energy is taken from the other taps.
void LobeTaps::add_tail(const ShadingPoint& point, std::vector<Tap>& taps) const {
    const size_t count = taps.size();
    taps.resize(count + static_cast<size_t>(m_tail.count()));
    const std::span<Tap> all(taps), own = all.first(count), tail = all.subspan(count);
    m_tail.at(point, tail);
    Color3f whole(0, 0, 0), far(0, 0, 0);
    for (const Tap& tap : own) whole += tap.weight;
    for (const Tap& tap : tail) far += tap.weight;
    for (Tap& tap : own)
        for (int k = 0; k < 3; ++k) tap.weight[k] *= std::max(1 - far[k] / std::max(whole[k], 1e-20f), 0.0f);
}

void LobeTaps::at(const ShadingPoint& point, std::vector<Tap>& taps) const {
    if (table()) {
        taps.resize(static_cast<size_t>(m_table.tap_count()));
        m_table.at(point, taps);
        return;
    }
    taps.resize(static_cast<size_t>(m_rule->tap_count(point.mx, point.my)));
    (*m_rule)(point, taps);
    if (m_tail.count() > 0) add_tail(point, taps);
}

}  // namespace burnish
