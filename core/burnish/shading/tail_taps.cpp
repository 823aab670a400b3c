#include <burnish/shading/tail_taps.h>

#include <burnish/material/lobe.h>
#include <burnish/sampling/tuned_patterns.h>

#include <numbers>

namespace burnish {
namespace {

constexpr float kBegin = 6, kReach = 3;  // normalised slope; of a ring, outer over inner radius
constexpr float kWidest = 0.5f;          // tangent of the half angle at which no further ring begins
constexpr int kCells = 5;                // a ring
constexpr float kNarrower = 0.7f;        // than its cell a tap is, as the energy is near the inner edge

/// Energy beyond a normalised slope: the inverse of a lobe's border.
float energy_beyond(float radius, const RadiusOf& radius_of) {
    float low = 0, high = 1;
    for (int i = 0; i < 40; ++i) {
        const float xi = 0.5f * (low + high);
        (radius_of(xi) > radius ? low : high) = xi;
    }
    return 0.5f * (low + high);
}

}  // namespace

TailTaps::TailTaps(const LobeParameters& lobe) : m_lobe(lobe) {
    visit_lobe(lobe, [&](const auto& own) {
        const RadiusOf radius_of = [&](float xi) { return own.border(xi); };
        if (lobe_tail(radius_of) == LobeTail::gaussian) return;
        const float width = std::sqrt(lobe.mx * lobe.my);
        for (float inner = kBegin; inner * width < kWidest; inner *= kReach) {
            const float outer = inner * kReach, beyond = outer * width < kWidest ? energy_beyond(outer, radius_of) : 0.0f;
            const float within = energy_beyond(inner, radius_of), median = radius_of(0.5f * (within + beyond));
            const float turn = m_cells.size() / kCells % 2 ? 0.5f : 0.0f;
            for (int k = 0; k < kCells; ++k) {
                const float phi = 2 * kPi * (static_cast<float>(k) + turn) / kCells;
                m_cells.push_back({median * std::cos(phi), median * std::sin(phi), inner, outer, (within - beyond) / kCells});
            }
        }
    });
}

void TailTaps::at(const ShadingPoint& point, std::span<Tap> taps) const {
    const float width = std::sqrt(point.mx * point.my);
    const auto cos_wi = [width](float radius) {  // of the direction that this half vector reflects along the normal
        const float t2 = radius * radius * width * width;
        return std::max((1 - t2) / (1 + t2), 0.0f);
    };
    visit_lobe(m_lobe, [&](const auto& prototype) {
        const auto lobe = prototype.with_widths(point.mx, point.my);
        for (size_t i = 0; i < m_cells.size(); ++i) {
            const Cell& cell = m_cells[i];
            const Vec3f h = Vec3f(cell.u * point.mx, cell.v * point.my, 1).normalized();
            const float wo_h = std::max(point.wo.dot(h), point.wo.z / (2 * h.z));
            const Vec3f wi = lobe.mirrored(h * (2 * point.wo.dot(h)) - point.wo);
            const float omega = (cos_wi(cell.inner) - cos_wi(cell.outer)) * wo_h / kCells;  // over 2 pi
            taps[i] = {wi, 0.5f * std::log(std::max(kNarrower * kNarrower * omega, 1e-12f)), Color3f(0, 0, 0)};
            const float cos_i = wi.z * lobe.side_sign, pdf = lobe.D(h) * h.z / (4 * point.wo.dot(h));
            if (cos_i > 0 && pdf > 0) taps[i].weight = lobe.eval(point.wo, wi) * (cos_i * cell.share / pdf);
        }
    });
}

}  // namespace burnish
