#include <burnish/material/measured/gonio_table.h>
#include <burnish/material/measured/scattered_colors.h>
#include <burnish/material/lobes/microfacet.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace burnish {
namespace {

/// Incident directions nearer than this are one: what rounding in files leaves apart.
constexpr float kSameDirection = 1e-4f;

/// A pair as the tables see it: an incident direction's projection, and the half vector's.
struct TableKey {
    Vec2f incident, half;
};

/// For isotropic tables turned to phi_i = 0 and folded: incident.y = 0, half.y >= 0. Transmitted light is mirrored at the surface.
TableKey table_key(const Vec3f& wo, const Vec3f& wi, bool isotropic) {
    const bool through = wi.z < 0;
    const Vec3f incident = through ? wo : wi;
    const HalfVector h(wo, {wi.x, wi.y, std::abs(wi.z)});
    const Vec2f across(incident.x, incident.y), half(h.wm.x, h.wm.y);
    if (!isotropic) return {across, half};
    const float sin_i = across.length();
    const Vec2f along = sin_i > 0 ? across / sin_i : Vec2f(1, 0);
    return {{sin_i, 0}, {half.dot(along), std::abs(half.cross(along))}};
}

}  // namespace

/// One side of the surface: the incident directions in the plane, and for each its values over the half vector.
class GonioTable::Side {
public:
    Side(const std::vector<BrdfSample>& samples, bool isotropic) : m_isotropic(isotropic) {
        std::map<std::pair<long, long>, std::pair<Vec2f, Slice>> slices;  // a map, for the same order in every run
        for (const BrdfSample& sample : samples) {
            const TableKey key = table_key(sample.wo, sample.wi, isotropic);
            const auto step = [](float x) { return std::lround(x / kSameDirection); };
            auto& [incident, slice] = slices[{step(key.incident.x), step(key.incident.y)}];
            incident = key.incident;
            slice.points.push_back(key.half), slice.colors.push_back(sample.f);
        }
        for (const auto& [place, entry] : slices) {
            m_incident.push_back(entry.first);
            m_values.emplace_back(entry.second.points, entry.second.colors);
        }
        m_directions = std::make_unique<ScatteredColors>(m_incident, std::vector<Color3f>(m_incident.size()));
    }

    Color3f eval(const Vec3f& wo, const Vec3f& wi) const {
        const TableKey key = table_key(wo, wi, m_isotropic);
        return m_isotropic ? between_angles(key) : between_directions(key);
    }

private:
    struct Slice {
        std::vector<Vec2f> points;
        std::vector<Color3f> colors;
    };

    /// Linear in theta_i, which the sines are sorted by as well; kept beyond the first and the last.
    Color3f between_angles(const TableKey& key) const {
        const auto by_sine = [](const Vec2f& a, const Vec2f& b) { return a.x < b.x; };
        const auto above = std::upper_bound(m_incident.begin(), m_incident.end(), key.incident, by_sine);
        if (above == m_incident.begin()) return m_values.front().at(key.half);
        if (above == m_incident.end()) return m_values.back().at(key.half);
        const size_t next = static_cast<size_t>(above - m_incident.begin());
        const auto theta = [](const Vec2f& incident) { return std::asin(std::min(incident.x, 1.0f)); };
        const float first = theta(m_incident[next - 1]), second = theta(m_incident[next]);
        const float share = (theta(key.incident) - first) / (second - first);
        return m_values[next - 1].at(key.half) * (1 - share) + m_values[next].at(key.half) * share;
    }

    Color3f between_directions(const TableKey& key) const {
        Color3f sum(0);
        for (const auto& n : m_directions->neighbours(key.incident)) sum += m_values[n.index].at(key.half) * n.weight;
        return sum;
    }

    bool m_isotropic;
    std::vector<Vec2f> m_incident;
    std::vector<ScatteredColors> m_values;
    std::unique_ptr<ScatteredColors> m_directions;
};

GonioTable::GonioTable(std::vector<BrdfSample> samples, bool isotropic)
    : m_isotropic(isotropic), m_samples(std::move(samples)) {
    std::vector<BrdfSample> reflected, through;
    for (const BrdfSample& sample : m_samples) (sample.wi.z < 0 ? through : reflected).push_back(sample);
    if (!reflected.empty()) m_reflected = std::make_shared<Side>(reflected, isotropic);
    if (!through.empty()) m_through = std::make_shared<Side>(through, isotropic);
}

Color3f GonioTable::eval(const Vec3f& wo, const Vec3f& wi) const {
    const Side* side = wi.z < 0 ? m_through.get() : m_reflected.get();
    return side && above_surface(wo, {wi.x, wi.y, std::abs(wi.z)}) ? side->eval(wo, wi) : Color3f(0);
}

}  // namespace burnish
