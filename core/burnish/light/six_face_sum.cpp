#include <burnish/light/six_face_sum.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "burnish/light/six_face_sum.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_MAX_BYTES >= 32
using Texels = hn::FixedTag<float, 8>;  // two side by side

/// The weights of two texels in the order of memory, four times each.
HWY_INLINE hn::Vec<Texels> spread(float left, float right) {
    const hn::FixedTag<float, 4> texel;
    return hn::Combine(Texels(), hn::Set(texel, right), hn::Set(texel, left));
}

/// Sums of pairs of texels for six faces.
struct PairSums {
    hn::Vec<Texels> of[6];

    HWY_INLINE void add(const float* const (&faces)[6], std::ptrdiff_t left, hn::Vec<Texels> weight) {
        for (int face = 0; face < 6; ++face) of[face] = hn::MulAdd(weight, hn::LoadU(Texels(), faces[face] + left), of[face]);
    }
    HWY_INLINE void add_to(SixTexels& total) const {
        HWY_ALIGN float lanes[8];
        for (int face = 0; face < 6; ++face) {
            hn::Store(of[face], Texels(), lanes);
            for (int k = 0; k < 4; ++k) total[face][k] += lanes[k] + lanes[k + 4];
        }
    }
};
#endif

void add_mirrored(const CubeLevel& level, std::span<const TexelRun> runs, Mirror mirror, const float* weights,
                  SixTexels& total) {
    const int last = level.size() - 1;
    const std::ptrdiff_t step = mirror.x ? -4 : 4;
    const float* faces[6];
    for (int face = 0; face < 6; ++face) faces[face] = level.at(face, 0, 0);
    SixTexels single = {};
#if HWY_MAX_BYTES >= 32
    const auto zero = hn::Zero(Texels());
    PairSums pairs{{zero, zero, zero, zero, zero, zero}};
#endif
    for (const TexelRun& run : runs) {
        std::ptrdiff_t at = level.at(0, mirror.x ? last - run.x : run.x, mirror.y ? last - run.y : run.y) - faces[0];
        int i = 0;
#if HWY_MAX_BYTES >= 32
        for (; i + 2 <= run.count; i += 2, weights += 2, at += 2 * step)
            pairs.add(faces, mirror.x ? at - 4 : at, spread(weights[mirror.x], weights[!mirror.x]));
#endif
        for (; i < run.count; ++i, ++weights, at += step)
            for (int face = 0; face < 6; ++face)
                for (int k = 0; k < 4; ++k) single[face][k] += *weights * faces[face][at + k];
    }
#if HWY_MAX_BYTES >= 32
    pairs.add_to(single);
#endif
    for (int face = 0; face < 6; ++face)
        for (int k = 0; k < 4; ++k) total[face][k] += single[face][k];
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burnish {

HWY_EXPORT(add_mirrored);

void add_runs(const CubeLevel& level, std::span<const TexelRun> runs, Mirror mirror, const float* weights, SixTexels& total) {
    HWY_DYNAMIC_DISPATCH(add_mirrored)(level, runs, mirror, weights, total);
}

}  // namespace burnish
#endif
