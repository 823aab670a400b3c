// The taps of one lobe without any light: directions, widths and weights, to be made once and shaded under many lights.
//
// Under distant light alone a tap's width becomes a level of its map when the table is made (material_shader.h). Where lights are
// near, how wide a tap is in the map that it reads depends on the pixel, so here Tap::level is the natural logarithm of the
// Gaussian's width in radian. And where lights are near, lamps are no discs that are shaded apart: lobes with long tails get some
// more taps for those, tail_taps.h.
#pragma once

#include <burnish/sampling/estimator.h>
#include <burnish/shading/tail_taps.h>
#include <burnish/shading/tap_rule.h>
#include <burnish/shading/tap_table.h>

#include <optional>
#include <vector>

namespace burnish {

class LobeTaps {
public:
    /// Not for `reference`. `split_sum` is `fitted` with one tap here, and samples are not adaptive.
    /// `with_tail`: with taps for the far tail, if the lobe has one, and the estimator's own do not reach into it.
    LobeTaps(const LobeParameters& lobe, const EstimatorSettings& settings, bool with_tail = true);

    const LobeParameters& lobe() const { return m_lobe; }
    /// The taps by the view; null where anisotropy comes from a layer, and each point has its own.
    const TapTable* table() const { return m_table.tap_count() > 0 ? &m_table : nullptr; }
    /// Writes the taps at a point, as many as it needs.
    void at(const ShadingPoint& point, std::vector<Tap>& taps) const;

private:
    void prepare(const EstimatorSettings& settings);
    TapTable joined_by_tail(const TapTable& own) const;
    void add_tail(const ShadingPoint& point, std::vector<Tap>& taps) const;

    LobeParameters m_lobe;
    std::optional<TapRule> m_rule;
    TapTable m_table;  // empty where anisotropy comes from a layer
    TailTaps m_tail;   // in the table, if there is one
};

}  // namespace burnish
