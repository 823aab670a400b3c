// The `filtered_importance` estimator (Colbert & Krivanek 2007): few importance samples, each lookup filtered over the solid
// angle 1 / (n pdf) it stands for. All pixels share one Hammersley set, so the image is free of noise.
#pragma once

#include <burnish/material/lobe.h>
#include <burnish/sampling/sequence.h>
#include <burnish/shading/shading_point.h>

namespace burnish {

/// `look(wi, Omega)` gives filtered radiance.
template <class LobeType, class Look>
Color3f filtered_importance_estimate(const LobeType& lobe, int samples, const ShadingPoint& point, const Look& look) {
    Color3f sum(0, 0, 0);
    for (int i = 0; i < samples; ++i) {
        const Vec3f wi = lobe.sample(point.wo, hammersley(i, samples));
        const float cos_i = wi.z * lobe.side_sign, pdf = lobe.pdf(point.wo, wi);
        if (cos_i <= 0 || pdf <= 0 || !point.sees(wi, lobe.side_sign)) continue;
        const float share = 1 / (samples * pdf);
        sum += lobe.eval(point.wo, wi) * (cos_i * share) * look(wi, share);
    }
    return sum;
}

}  // namespace burnish
