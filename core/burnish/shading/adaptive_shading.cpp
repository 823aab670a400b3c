#include <burnish/shading/adaptive_shading.h>

namespace burnish {
namespace {

/// The pixels of a batch at `places`.
SurfaceBatch picked(const SurfaceBatch& batch, const std::vector<uint32_t>& places) {
    SurfaceBatch part;
    part.band_start = batch.band_start;
    const auto pick = [&](const auto& from, auto& to) {
        if (from.empty()) return;
        to.reserve(places.size());
        for (const uint32_t i : places) to.push_back(from[i]);
    };
    pick(batch.pixel, part.pixel);
    for (const auto planes :
         {&SurfaceBatch::p, &SurfaceBatch::n, &SurfaceBatch::ng, &SurfaceBatch::t, &SurfaceBatch::wo, &SurfaceBatch::tint})
        for (const auto axis : {&Vec3Planes::x, &Vec3Planes::y, &Vec3Planes::z}) pick(batch.*planes.*axis, part.*planes.*axis);
    for (const auto plane :
         {&SurfaceBatch::roughness, &SurfaceBatch::anisotropy, &SurfaceBatch::rotation, &SurfaceBatch::weight})
        pick(batch.*plane, part.*plane);
    return part;
}

struct Shaded {
    std::vector<Color3f> overlay;
    std::vector<float> samples, square, weight;

    explicit Shaded(size_t pixels) : overlay(pixels, Color3f(0)), samples(pixels), square(pixels), weight(pixels) {}

    float deviation(size_t i) const { return std::sqrt(relative_variance(luminance(overlay[i]), square[i], weight[i])); }
};

}  // namespace

void add_adaptive_shading(const TableShading& shading, const TableLadder& ladder, const TableShading* prediction,
                          const SurfaceBatch& batch, std::span<Color3f> overlay, std::span<float> samples) {
    const auto with = [&](size_t rung) {
        return TableShading{
            {shading.lobe, ladder.tables[rung], shading.world_to_light}, shading.stack, shading.distortion, shading.gain};
    };
    Shaded few(batch.size());
    add_table_shading(prediction ? *prediction : with(0), batch, {few.overlay, few.samples, few.square, few.weight});
    std::vector<std::vector<uint32_t>> places(ladder.counts.size());
    for (uint32_t i = 0; i < batch.size(); ++i) {
        const size_t rung = ladder_rung(ladder.counts, few.deviation(i), ladder.full_deviation);
        places[rung].push_back(i);
        if (rung == 0 && !prediction) overlay[i] += few.overlay[i];
        samples[i] += few.samples[i];
    }
    for (size_t rung = prediction ? 0 : 1; rung < places.size(); ++rung) {
        if (places[rung].empty()) continue;
        Shaded more(places[rung].size());
        add_table_shading(with(rung), picked(batch, places[rung]), {more.overlay, more.samples, {}, {}});
        for (size_t k = 0; k < places[rung].size(); ++k) {
            overlay[places[rung][k]] += more.overlay[k];
            samples[places[rung][k]] += more.samples[k];
        }
    }
}

}  // namespace burnish
