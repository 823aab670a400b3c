#include <burnish/shading/material_shader.h>

#include <burnish/light/filter/stack_lookup.h>
#include <burnish/material/lobe.h>
#include <burnish/sampling/tuned_patterns.h>
#include <burnish/shading/adaptive_shading.h>
#include <burnish/shading/disc_light.h>
#include <burnish/shading/factored.h>
#include <burnish/shading/fitted.h>
#include <burnish/shading/local_shading.h>
#include <burnish/shading/reference.h>
#include <burnish/shading/running_reference.h>
#include <burnish/shading/split_sum.h>
#include <burnish/shading/table_shading.h>
#include <burnish/shading/tap_rule.h>

#include <algorithm>
#include <optional>

namespace burnish {

struct MaterialShader::LobeShader {
    LobeShader(const LobeParameters& parameters, const Environment& environment, const EstimatorSettings& estimator)
        : lobe(parameters), settings(settled(parameters, estimator)), light(environment) {
        switch (settings.kind) {
            case EstimatorKind::reference:
                if (settings.adaptive) prepare_prediction();
                break;
            case EstimatorKind::fitted: prepare_fitted(); break;
            case EstimatorKind::split_sum: prepare_split_sum(); break;
            default: prepare_rule();
        }
    }

    void prepare_fitted() {
        table = fitted_table(lobe, settings.samples, light.gaussian_stack());
        stack = light.gaussian_stack().stack(table.level_ranges());
    }

    void prepare_split_sum() {
        SplitSum split = split_sum(lobe, light.gaussian_stack());
        table = std::move(split.table), stack = std::move(split.filtered);
    }

    TapRule::LevelOf level_of() const {
        if (settings.kind == EstimatorKind::preconvolved)
            return [this](float sigma) { return light.gaussian_stack().level(sigma); };
        return [this](float omega) { return light.pyramid().level(omega) + settings.level_bias; };
    }

    void prepare_rule() {
        rule.emplace(lobe, settings, level_of());
        const int taps = rule->tap_count(lobe.mx, lobe.my);
        if (TapTable::covers(lobe, taps)) {
            if (settings.adaptive)
                prepare_ladder(taps);
            else
                table = TapTable(lobe, taps, *rule);
        }
        if (settings.kind == EstimatorKind::preconvolved)
            stack = preconvolved_stack();
        else
            stack = light.pyramid().stack(), distortion = CubePyramid::kDistortion;
    }

    /// As far as the tables read it; whole where pixels make their own taps.
    CubeStack preconvolved_stack() const {
        const GaussianStack& whole = light.gaussian_stack();
        std::vector<LevelRange> ranges = table.level_ranges();
        for (const TapTable& rung : ladder.tables) std::ranges::copy(rung.level_ranges(), std::back_inserter(ranges));
        return ranges.empty() ? whole.stack() : whole.stack(ranges);
    }

    /// For an adaptive `reference` or `preconvolved`: a few lookups of `regular` in the pyramid, whose fourth channel holds squares.
    void prepare_prediction() {
        EstimatorSettings fewest;
        fewest.kind = EstimatorKind::regular, fewest.samples = kFewestLookups;
        const TapRule few_taps(lobe, fewest, [this](float omega) { return light.pyramid().level(omega); });
        const int taps = few_taps.tap_count(lobe.mx, lobe.my);
        if (TapTable::covers(lobe, taps)) few = TapTable(lobe, taps, few_taps);
    }

    TableShading prediction() const {
        return {{lobe, few, light.world_to_light()}, light.pyramid().stack(), CubePyramid::kDistortion, light.gain()};
    }

    /// Passes until `reference` first looks at the error of each pixel. Where there are suns, of which the prediction knows
    /// nothing, never early.
    std::vector<int> first_passes(const SurfaceBatch& batch, ShadedBatch& out) const {
        std::vector<int> passes(batch.size(), kMinPasses);
        if (few.tap_count() == 0) return passes;
        std::vector<Color3f> overlay(batch.size(), Color3f(0));
        std::vector<float> square(batch.size()), weight(batch.size());
        add_table_shading(prediction(), batch, {overlay, out.samples, square, weight});
        const int fewest = light.discs().empty() ? 1 : kMinPasses;
        for (size_t i = 0; i < batch.size(); ++i) {
            const float deviation = std::sqrt(relative_variance(luminance(overlay[i]), square[i], weight[i]));
            passes[i] = std::max(fewest, predicted_passes(deviation, settings.tolerance));
        }
        return passes;
    }

    /// `regular` may have one pattern for two of the counts.
    void prepare_ladder(int most) {
        ladder.full_deviation = full_deviation(settings.kind);
        if (settings.kind == EstimatorKind::preconvolved) prepare_prediction();
        for (const int count : sample_ladder(most)) {
            EstimatorSettings fewer = settings;
            fewer.samples = count;
            const TapRule rung(lobe, fewer, level_of());
            const int taps = rung.tap_count(lobe.mx, lobe.my);
            if (!ladder.counts.empty() && taps <= ladder.counts.back()) continue;
            ladder.counts.push_back(taps), ladder.tables.emplace_back(lobe, taps, rung);
        }
    }

    TableShading with(const TapTable& own) const {
        return {{lobe, own, light.world_to_light()}, stack, distortion, light.gain()};
    }

    void add_filtered(const SurfaceBatch& batch, ShadedBatch& out) const {
        if (!ladder.tables.empty())
            add_by_ladder(batch, out);
        else if (table.tap_count() > 0)
            add_table_shading(with(table), batch, {out.overlay, out.samples, {}, {}});
        else
            add_tap_by_tap(batch, out);
    }

    void add_by_ladder(const SurfaceBatch& batch, ShadedBatch& out) const {
        const TableShading shading = with(ladder.tables.back());
        if (few.tap_count() == 0) return add_adaptive_shading(shading, ladder, nullptr, batch, out.overlay, out.samples);
        const TableShading predicting = prediction();
        add_adaptive_shading(shading, ladder, &predicting, batch, out.overlay, out.samples);
    }

    /// Where each pixel has to make its own taps.
    void add_tap_by_tap(const SurfaceBatch& batch, ShadedBatch& out) const {
        const float side_sign = lobe.side == Side::transmission ? -1.0f : 1.0f;
        std::vector<Tap> taps;
        std::vector<StackTap> lookups;
        for (size_t i = 0; i < batch.size(); ++i) {
            const ShadingPoint point = shading_point(batch, i, lobe, light.world_to_light());
            taps.resize(rule->tap_count(point.mx, point.my));
            (*rule)(point, taps);
            lookups.clear();
            for (const Tap& tap : taps)
                if (point.sees(tap.wi, side_sign) && tap.weight != Color3f(0, 0, 0))
                    lookups.push_back({point.frame.to_world(tap.wi), tap.level, tap.weight});
            out.overlay[i] += sum_of(lookups) * point.scale * light.gain();
            out.samples[i] += static_cast<float>(lookups.size());
        }
    }

    Color3f sum_of(std::span<const StackTap> lookups) const {
        Color3f sum(0, 0, 0), part;
        for (; !lookups.empty(); sum += part) {
            const size_t count = std::min(lookups.size(), kMostTapsPerSum);
            add_up_lookups(stack, distortion, lookups.first(count), count, {&part, 1});
            lookups = lookups.subspan(count);
        }
        return sum;
    }

    template <class LobeType>
    void add_reference(const LobeType& prototype, const SurfaceBatch& batch, ShadedBatch& out, uint32_t lobe_index) const {
        const std::vector<int> passes = first_passes(batch, out);
        for (size_t i = 0; i < batch.size(); ++i) {
            const ShadingPoint point = shading_point(batch, i, lobe, light.world_to_light());
            const uint32_t seed = reference_seed(batch, i, lobe_index);
            const ReferenceEstimate estimate = reference_estimate(prototype.with_widths(point.mx, point.my),
                                                                  DistantArrival{light}, settings, point, seed, passes[i]);
            const Color3f scale = point.scale * light.gain();
            out.overlay[i] += estimate.mean * scale;
            out.standard_error[i] = std::hypot(out.standard_error[i], estimate.standard_error * luminance(scale));
            out.samples[i] += static_cast<float>(estimate.lookups);
        }
    }

    template <class LobeType>
    void add_pass(const LobeType& prototype, const SurfaceBatch& batch, uint32_t lobe_index,
                  std::span<RunningReference> running) const {
        for (size_t i = 0; i < batch.size(); ++i) {
            const ShadingPoint point = shading_point(batch, i, lobe, light.world_to_light());
            add_reference_pass(prototype.with_widths(point.mx, point.my), DistantArrival{light}, point,
                               reference_seed(batch, i, lobe_index), point.scale * light.gain(), running[i]);
        }
    }

    LobeParameters lobe;
    EstimatorSettings settings;
    const Environment& light;
    std::optional<TapRule> rule;
    TapTable table;        // empty where anisotropy comes from a layer, and where there is a ladder
    TableLadder ladder;    // adaptive only
    TapTable few;          // what predicts for an adaptive reference or preconvolved
    CubeStack stack;       // what taps read, a handle
    float distortion = 0;  // levels a tap gains where the cube's texels are small
};

MaterialShader::MaterialShader(const Material& material, const Environment& light, const EstimatorSettings& settings) {
    if (settings.kind == EstimatorKind::factored) {
        m_factored = std::make_shared<const FactoredShader>(material, light, factored_light(material, light, settings));
        return;
    }
    for (const LobeParameters& lobe : material.lobes) m_lobes.push_back(std::make_shared<LobeShader>(lobe, light, settings));
}

MaterialShader::MaterialShader(std::shared_ptr<const MaterialTaps> taps, LightChain lights)
    : m_taps(std::move(taps)), m_lights(std::move(lights)) {}

BatchNeeds MaterialShader::needs() const {
    const auto turns = [](const auto& shader) { return shader->lobe.is_anisotropic(); };
    if (m_taps) return {.position = true, .tangent = std::ranges::any_of(m_taps->lobes, &LobeParameters::is_anisotropic)};
    return {.position = false, .tangent = std::any_of(m_lobes.begin(), m_lobes.end(), turns)};
}

bool MaterialShader::estimates_error() const {
    if (m_taps) return m_taps->settings.kind == EstimatorKind::reference;
    return !m_lobes.empty() && m_lobes[0]->settings.kind == EstimatorKind::reference;
}

int MaterialShader::lobe_count() const { return static_cast<int>(m_taps ? m_taps->lobes.size() : m_lobes.size()); }

void MaterialShader::shade(const SurfaceBatch& batch, ShadedBatch& out) const {
    out.overlay.assign(batch.size(), Color3f(0, 0, 0));
    out.samples.assign(batch.size(), 0.0f);
    out.standard_error.assign(estimates_error() ? batch.size() : 0, 0.0f);
    if (m_factored)
        m_factored->shade(batch, out);
    else if (m_taps)
        shade_local(batch, out);
    else
        shade_distant(batch, out);
}

void MaterialShader::shade_without_suns(const SurfaceBatch& batch, ShadedBatch& out) const {
    out.overlay.assign(batch.size(), Color3f(0, 0, 0));
    out.samples.assign(batch.size(), 0.0f);
    out.standard_error.clear();
    for (const auto& lobe : m_lobes) lobe->add_filtered(batch, out);
}

void MaterialShader::add_pass(const SurfaceBatch& batch, std::span<RunningReference> running) const {
    for (uint32_t index = 0; m_taps && index < m_taps->lobes.size(); ++index)
        add_local_pass(m_taps->lobes[index], index, m_lights, batch, running);
    for (uint32_t index = 0; index < m_lobes.size(); ++index)
        visit_lobe(m_lobes[index]->lobe, [&](const auto& lobe) { m_lobes[index]->add_pass(lobe, batch, index, running); });
    for (RunningReference& pixel : running) pixel.points += kPassPoints;
}

void MaterialShader::shade_local(const SurfaceBatch& batch, ShadedBatch& out) const {
    const LocalSums sums{out.overlay, out.samples, out.standard_error};
    for (uint32_t index = 0; index < m_taps->lobes.size(); ++index) {
        const LobeParameters& lobe = m_taps->lobes[index];
        if (estimates_error()) {
            add_local_reference(lobe, index, m_taps->settings, m_lights, batch, sums);
            continue;
        }
        add_local_lobe(m_taps->taps[index], m_lights, batch, sums);
        add_local_discs(lobe, m_lights, batch, sums);
    }
}

void MaterialShader::shade_distant(const SurfaceBatch& batch, ShadedBatch& out) const {
    const bool reference = estimates_error();
    for (uint32_t index = 0; index < m_lobes.size(); ++index) {
        const LobeShader& shader = *m_lobes[index];
        if (!reference) shader.add_filtered(batch, out);
        visit_lobe(shader.lobe, [&](const auto& lobe) {
            if (reference)
                shader.add_reference(lobe, batch, out, index);
            else
                add_disc_light(lobe, shader.lobe, shader.light, batch, out.overlay);
        });
    }
}

}  // namespace burnish
