// Internal. Vectors of pixels out of a batch, and the geometry that kernels do with them. Lanes are pixels. Compiled once per
// instruction set.
#include <burnish/light/filter/stack_lookup_simd.h>
#include <burnish/surface/surface_batch.h>

// Included anew for each instruction set.
#if defined(BURNISH_BATCH_LANES_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef BURNISH_BATCH_LANES_SIMD
#undef BURNISH_BATCH_LANES_SIMD
#else
#define BURNISH_BATCH_LANES_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {

HWY_INLINE V3 operator+(const V3& a, const V3& b) { return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)}; }
HWY_INLINE V3 operator-(const V3& a, const V3& b) { return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)}; }
HWY_INLINE V3 operator*(const V3& a, VF s) { return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)}; }
HWY_INLINE V3 cross(const V3& a, const V3& b) {
    return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
            hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}
HWY_INLINE VF constant(float value) { return hn::Set(Lanes(), value); }
HWY_INLINE VF sign_of(VF v) { return hn::CopySign(constant(1), v); }

/// Values i and on of a plane, zeros beyond its end.
HWY_INLINE VF load(const std::vector<float>& plane, size_t i) {
    const Lanes d;
    if (i + hn::Lanes(d) <= plane.size()) return hn::LoadU(d, &plane[i]);
    HWY_ALIGN float tail[8] = {};
    std::copy(plane.begin() + static_cast<std::ptrdiff_t>(i), plane.end(), tail);
    return hn::Load(d, tail);
}
HWY_INLINE V3 load(const Vec3Planes& planes, size_t i) { return {load(planes.x, i), load(planes.y, i), load(planes.z, i)}; }

/// v * m, row vector times matrix.
HWY_INLINE V3 turned(const V3& v, const Matrix33f& m) {
    const auto column = [&](int k) { return dot(v, {constant(m[0][k]), constant(m[1][k]), constant(m[2][k])}); };
    return {column(0), column(1), column(2)};
}

/// The tangent of Frame::along(n, hint).
HWY_INLINE V3 tangent_along(const V3& n, const V3& hint) {
    const V3 t = hint - n * dot(n, hint);
    const VF length2 = dot(t, t), inverse = hn::Div(constant(1), hn::Sqrt(length2));
    const VF sign = sign_of(n.z), x_a = hn::Div(hn::Neg(n.x), hn::Add(sign, n.z));
    const auto defined = hn::Gt(length2, constant(1e-12f));
    return {hn::IfThenElse(defined, hn::Mul(t.x, inverse), hn::MulAdd(hn::Mul(sign, n.x), x_a, constant(1))),
            hn::IfThenElse(defined, hn::Mul(t.y, inverse), hn::Mul(hn::Mul(sign, n.y), x_a)),
            hn::IfThenElse(defined, hn::Mul(t.z, inverse), hn::Neg(hn::Mul(sign, n.x)))};
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();
#endif
