#include <burnish/frequency/turning_rows.h>

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "burnish/frequency/turning_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, 8>;

void deinterleave(const float* xyz, size_t width, TurningRow& row) {
    const Lanes d;
    size_t i = 0;
    for (; i + hn::Lanes(d) <= width; i += hn::Lanes(d)) {
        hn::Vec<Lanes> x, y, z;
        hn::LoadInterleaved3(d, xyz + 3 * i, x, y, z);
        hn::StoreU(x, d, &row.x[i]), hn::StoreU(y, d, &row.y[i]), hn::StoreU(z, d, &row.z[i]);
    }
    for (; i < width; ++i) row.x[i] = xyz[3 * i], row.y[i] = xyz[3 * i + 1], row.z[i] = xyz[3 * i + 2];
}

void compare(const TurningRow& a, const TurningRow& b, size_t shift, size_t width, float* squares) {
    const Lanes d;
    const auto infinite = hn::Set(d, std::numeric_limits<float>::infinity());
    for (size_t i = 0; i < width; i += hn::Lanes(d)) {
        const auto x = hn::LoadU(d, &a.x[i]), y = hn::LoadU(d, &a.y[i]), z = hn::LoadU(d, &a.z[i]);
        const auto dx = hn::Sub(hn::LoadU(d, &b.x[i + shift]), x), dy = hn::Sub(hn::LoadU(d, &b.y[i + shift]), y),
                   dz = hn::Sub(hn::LoadU(d, &b.z[i + shift]), z);
        const auto change = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
        const auto length = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
        const auto same = hn::Eq(hn::LoadU(d, &a.key[i]), hn::LoadU(d, &b.key[i + shift]));
        hn::StoreU(hn::IfThenElse(same, hn::Div(change, length), infinite), d, squares + i);
    }
}

void add_sides(const float* above, const float* below, const float* left, size_t width, float* largest) {
    const Lanes d;
    const auto sides = [&](size_t i) {
        return hn::Max(hn::Max(hn::LoadU(d, above + i), hn::LoadU(d, below + i)),
                       hn::Max(hn::LoadU(d, left + i), hn::LoadU(d, left + i + 1)));
    };
    for (size_t i = 0; i < width; i += 2 * hn::Lanes(d)) {
        HWY_ALIGN float both[16];
        hn::Store(sides(i), d, both), hn::Store(sides(i + hn::Lanes(d)), d, both + hn::Lanes(d));
        hn::Vec<Lanes> even, odd;
        hn::LoadInterleaved2(d, both, even, odd);
        hn::StoreU(hn::Max(hn::Max(even, odd), hn::LoadU(d, largest + i / 2)), d, largest + i / 2);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burnish {

HWY_EXPORT(deinterleave);
HWY_EXPORT(compare);
HWY_EXPORT(add_sides);

void read_normals(const float* xyz, size_t width, TurningRow& row) { HWY_DYNAMIC_DISPATCH(deinterleave)(xyz, width, row); }

void compare_rows(const TurningRow& a, const TurningRow& b, size_t shift, size_t width, float* squares) {
    HWY_DYNAMIC_DISPATCH(compare)(a, b, shift, width, squares);
}

void add_largest_sides(const float* above, const float* below, const float* left, size_t width, float* largest) {
    HWY_DYNAMIC_DISPATCH(add_sides)(above, below, left, width, largest);
}

}  // namespace burnish
#endif
