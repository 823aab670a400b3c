#include <burnish/shading/adaptive_shading.h>

namespace burnish {
namespace {

/// The pixels of a batch at `places`.
SurfaceBatch picked(const SurfaceBatch& batch, const std::vector<uint32_t>& places) {
    SurfaceBatch part;
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
    std::vector<float> samples;
    std::vector<LobeMoments> moments;

    explicit Shaded(size_t pixels) : overlay(pixels, Color3f(0)), samples(pixels, 0.0f), moments(pixels) {}
};

}  // namespace

void add_adaptive_shading(const TableShading& shading, const TableLadder& ladder, const SurfaceBatch& batch,
                          std::span<Color3f> overlay, std::span<float> samples) {
    const auto with = [&](size_t rung) {
        return TableShading{shading.lobe,       ladder.tables[rung],    shading.stack,
                            shading.distortion, shading.world_to_light, shading.gain};
    };
    Shaded few(batch.size());
    add_table_shading(with(0), batch, few.overlay, few.samples, few.moments);
    std::vector<std::vector<uint32_t>> places(ladder.counts.size());
    for (uint32_t i = 0; i < batch.size(); ++i) {
        const float deviation = std::sqrt(few.moments[i].relative_variance());
        const size_t rung = ladder_rung(ladder.counts, deviation, ladder.full_deviation);
        places[rung].push_back(i);
        if (rung == 0) overlay[i] += few.overlay[i];
        samples[i] += few.samples[i];
    }
    for (size_t rung = 1; rung < places.size(); ++rung) {
        if (places[rung].empty()) continue;
        Shaded more(places[rung].size());
        add_table_shading(with(rung), picked(batch, places[rung]), more.overlay, more.samples);
        for (size_t k = 0; k < places[rung].size(); ++k) {
            overlay[places[rung][k]] += more.overlay[k];
            samples[places[rung][k]] += more.samples[k];
        }
    }
}

}  // namespace burnish
