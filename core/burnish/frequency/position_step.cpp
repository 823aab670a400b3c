#include <burnish/frequency/position_step.h>

#include <bit>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

constexpr float kStep = 0.5f;             // of |dP|
constexpr float kHalfError = 0x1.0p-10f;  // of two halves' difference, relative to either

Vec3f vec3(const float* v) { return {v[0], v[1], v[2]}; }

/// Whether these are halves, to all appearance.
bool are_halves(const Vec3f& v) {
    const auto tail = [](float x) { return std::bit_cast<uint32_t>(x) & 0x1fffu; };
    return (tail(v.x) | tail(v.y) | tail(v.z)) == 0;
}

/// How large n . dP may be because positions are halves.
float error_along(const Vec3f& n, const Vec3f& a, const Vec3f& b) {
    if (!are_halves(a) || !are_halves(b)) return 0;
    return kHalfError * (std::fabs(n.x * a.x) + std::fabs(n.y * a.y) + std::fabs(n.z * a.z));
}

/// From a to b; n: sum of the normals, w: to the eye, neither a unit vector.
bool is_step(const Vec3f& n, const Vec3f& w, const Vec3f& a, const Vec3f& b) {
    const Vec3f step = b - a;
    const float off = n.dot(step), facing = n.dot(w);
    if (!(off * off * w.length2() > kStep * kStep * facing * facing * step.length2())) return false;
    return std::fabs(off) > kHalfError * std::fabs(facing) && std::fabs(off) > error_along(n, a, b);
}

}  // namespace

PositionStep::PositionStep(const AovFrame& frame)
    : m_position(&frame.layer(Role::position)),
      m_normal(frame.has(Role::geometric_normal) ? frame.find(Role::geometric_normal) : &frame.layer(Role::normal)),
      m_eye(frame.camera->centre) {}

void PositionStep::add(int y, int first, int count, int dx, int dy, float* squares) const {
    if (!m_position || y + dy >= m_position->height) return;
    const int last = std::min(count, m_position->width - first - dx);
    const float *p = m_position->at(first, y), *n = m_normal->at(first, y);
    const size_t next = 3 * (static_cast<size_t>(dy) * static_cast<size_t>(m_position->width) + static_cast<size_t>(dx));
    for (int i = 0; i < last; ++i, p += 3, n += 3) {
        if (std::isinf(squares[i])) continue;
        const Vec3f a = vec3(p), b = vec3(p + next);
        if (is_step(vec3(n) + vec3(n + next), m_eye - (a + b) * 0.5f, a, b))
            squares[i] = std::numeric_limits<float>::infinity();
    }
}

}  // namespace burnish
