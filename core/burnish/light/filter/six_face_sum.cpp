#include <burnish/light/filter/six_face_sum.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "burnish/light/filter/six_face_sum.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_MAX_BYTES >= 32
using Texel = hn::FixedTag<float, 4>;
using Texels = hn::FixedTag<float, 8>;  // two side by side

/// The sums as they grow, for even and odd texels of a run apart.
class Sums {
public:
    HWY_INLINE Sums() {
        for (auto& sum : m_sums) sum = hn::Zero(Texels());
    }
    /// Two texels, in the order of memory.
    HWY_INLINE void add(const float* const (&faces)[6], std::ptrdiff_t at, float left, float right) {
        const auto weight = hn::Combine(Texels(), hn::Set(Texel(), right), hn::Set(Texel(), left));
        for (int face = 0; face < 6; ++face)
            m_sums[face] = hn::MulAdd(weight, hn::LoadU(Texels(), faces[face] + at), m_sums[face]);
    }
    HWY_INLINE void add(const float* const (&faces)[6], std::ptrdiff_t at, float weight) {
        const auto texel = [&](int face) { return hn::ZeroExtendVector(Texels(), hn::LoadU(Texel(), faces[face] + at)); };
        for (int face = 0; face < 6; ++face) m_sums[face] = hn::MulAdd(hn::Set(Texels(), weight), texel(face), m_sums[face]);
    }
    HWY_INLINE void add_to(SixTexels& total) const {
        for (int face = 0; face < 6; ++face) {
            const auto sum = hn::Add(hn::LowerHalf(Texel(), m_sums[face]), hn::UpperHalf(Texel(), m_sums[face]));
            hn::StoreU(hn::Add(sum, hn::LoadU(Texel(), total[face])), Texel(), total[face]);
        }
    }

private:
    hn::Vec<Texels> m_sums[6];
};
#else
class Sums {
public:
    void add(const float* const (&faces)[6], std::ptrdiff_t at, float left, float right) {
        add(faces, at, left), add(faces, at + 4, right);
    }
    void add(const float* const (&faces)[6], std::ptrdiff_t at, float weight) {
        for (int face = 0; face < 6; ++face)
            for (int k = 0; k < 4; ++k) m_sums[face][k] += weight * faces[face][at + k];
    }
    void add_to(SixTexels& total) const {
        for (int face = 0; face < 6; ++face)
            for (int k = 0; k < 4; ++k) total[face][k] += m_sums[face][k];
    }

private:
    SixTexels m_sums = {};
};
#endif

void add_mirrored(const CubeLevel& level, std::span<const TexelRun> runs, Mirror mirror, const float* weights,
                  SixTexels& total) {
    const int last = level.size() - 1;
    const std::ptrdiff_t step = mirror.x ? -4 : 4;
    const float* faces[6];
    for (int face = 0; face < 6; ++face) faces[face] = level.at(face, 0, 0);
    Sums sums;
    for (const TexelRun& run : runs) {
        std::ptrdiff_t at = level.at(0, mirror.x ? last - run.x : run.x, mirror.y ? last - run.y : run.y) - faces[0];
        int i = 0;
        for (; i + 2 <= run.count; i += 2, weights += 2, at += 2 * step)
            sums.add(faces, mirror.x ? at - 4 : at, weights[mirror.x], weights[!mirror.x]);
        if (i < run.count) sums.add(faces, at, *weights++);
    }
    sums.add_to(total);
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
