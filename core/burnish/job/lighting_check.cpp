#include <burnish/job/lighting_check.h>

#include <burnish/base/parallel.h>
#include <burnish/output/compare.h>
#include <burnish/shading/lighting_samples.h>
#include <burnish/shading/material_shader.h>

#include <algorithm>
#include <mutex>

namespace burnish {
namespace {

EstimatorSettings reference() {
    EstimatorSettings settings;
    settings.kind = EstimatorKind::reference;
    settings.tolerance = 0.01f, settings.max_samples = 4096;
    return settings;
}

}  // namespace

double lighting_psnr_db(const StoredFactors& stored, const Material& material, const Environment& light, int pairs,
                        const Progress& progress) {
    constexpr int kAtOnce = 8;
    constexpr uint32_t kSeed = 11;
    const MaterialShader shader(material, light, reference());
    Image is(pairs, 1, 3), should_be(pairs, 1, 3);
    std::mutex reporting;
    int done = 0;
    for_each_index((pairs + kAtOnce - 1) / kAtOnce, [&](int block) {
        const int begin = block * kAtOnce, end = std::min(begin + kAtOnce, pairs);
        SurfaceBatch batch;
        for (int i = begin; i < end; ++i) {
            const DirectionPair pair = seen_pair(static_cast<uint32_t>(i), kSeed);
            batch.pixel.push_back(static_cast<uint32_t>(i)), batch.n.push_back(pair.a), batch.wo.push_back(pair.b);
            const Color3f told = stored(pair);
            std::copy_n(&told.x, 3, is.at(i));
        }
        ShadedBatch shaded;
        shader.shade(batch, shaded);
        for (int i = begin; i < end; ++i) std::copy_n(&shaded.overlay[i - begin].x, 3, should_be.at(i));
        const std::lock_guard lock(reporting);
        done += end - begin;
        progress.report("check", static_cast<float>(done) / static_cast<float>(pairs));
    });
    return compare_images(is, should_be, nullptr).display_psnr_db;
}

}  // namespace burnish
