#include <burnish/base/parallel.h>
#include <burnish/material/measured/half_vector_sampler.h>
#include <burnish/material/lobes/microfacet.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kByCosine = 0.01f;  // share of the draws
constexpr double kSimpson[] = {1, 4, 1};
constexpr float kSteepest = 60;     // slope of the last ring: 89 degrees
constexpr float kLastView = 0.01f;  // square root of its cosine

/// Slopes turned from the view's azimuth to the frame's, or back.
Vec2f turned(const Vec2f& slopes, const Vec3f& wo, bool back) {
    const float sine = std::sqrt(wo.x * wo.x + wo.y * wo.y);
    if (!(sine > 0)) return slopes;
    const float c = wo.x / sine, s = back ? -wo.y / sine : wo.y / sine;
    return {c * slopes.x - s * slopes.y, s * slopes.x + c * slopes.y};
}

Vec3f cosine_direction(const Vec2f& u) {
    const float r = std::sqrt(u.x), phi = 2 * kPi * u.y;
    return {r * std::cos(phi), r * std::sin(phi), std::sqrt(std::max(1 - u.x, 0.0f))};
}

/// The last of `count` places whose share is not beyond `x`: `before` rises.
template <class Before>
int place_of(double x, int count, Before before) {
    int low = 0;
    for (int high = count; high - low > 1;) {
        const int middle = (low + high) / 2;
        (before(middle) <= x ? low : high) = middle;
    }
    return low;
}

/// How far on its way from one share to the next x is.
float part_of(double x, double from, double to) {
    return to > from ? static_cast<float>(std::clamp((x - from) / (to - from), 0.0, 1.0)) : 0.5f;
}

}  // namespace

double HalfVectorSampler::Mixture::before_ring(int ring) const {
    double sum = 0;
    for (int k = 0; k < count; ++k) sum += weight[k] * view[k]->before_ring[ring];
    return sum;
}

double HalfVectorSampler::Mixture::before_azimuth(int ring, int azimuth) const {
    double sum = 0;
    for (int k = 0; k < count; ++k) sum += weight[k] * view[k]->before_azimuth[azimuth][ring];
    return sum;
}

HalfVectorSampler::HalfVectorSampler(const Lobe& lobe, const Vec2f& own, bool isotropic)
    : m_isotropic(isotropic),
      m_thetas(isotropic ? 48 : 16),
      m_phis(isotropic ? 1 : 16),
      m_azimuths(isotropic ? 24 : 32),
      m_own(own),
      m_step(2 * std::log(kSteepest / std::min(own.x, own.y)) / kRings),
      m_views(static_cast<size_t>(m_thetas * m_phis)) {
    for_each_index(m_thetas * m_phis,
                   [&](int i) { m_views[static_cast<size_t>(i)] = tabulated(lobe, view_direction(i / m_phis, i % m_phis)); });
}

Vec3f HalfVectorSampler::view_direction(int theta, int phi) const {
    const float root = 1 - (1 - kLastView) * static_cast<float>(theta) / static_cast<float>(m_thetas - 1);
    const float cosine = root * root, sine = std::sqrt(1 - cosine * cosine);
    const float p = 2 * kPi * static_cast<float>(phi) / static_cast<float>(m_phis);
    return {sine * std::cos(p), sine * std::sin(p), cosine};
}

/// Every cell by three by three points, Simpson's rule, with those on its borders: cells that the horizon cuts are not empty.
HalfVectorSampler::View HalfVectorSampler::tabulated(const Lobe& lobe, const Vec3f& wo) const {
    View view;
    view.before_azimuth.resize(static_cast<size_t>(m_azimuths) + 1);
    const std::vector<double> points = lattice(lobe, wo);
    const size_t row = 2 * kRings + 1;
    std::vector<std::array<double, kRings>> cells(static_cast<size_t>(m_azimuths));
    double whole = 0;
    for (size_t j = 0; j < cells.size(); ++j)
        for (size_t i = 0; i < kRings; ++i) {
            for (size_t b = 0; b < 3; ++b)
                for (size_t a = 0; a < 3; ++a) cells[j][i] += kSimpson[a] * kSimpson[b] * points[(2 * j + b) * row + 2 * i + a];
            whole += cells[j][i];
        }
    const double scale = whole > 0 ? (1 - kByCosine) / whole : 0.0;
    std::array<double, kRings> ring{};
    view.before_azimuth[0].fill(0), view.before_ring[0] = 0;
    for (size_t j = 0; j < cells.size(); ++j)
        for (size_t i = 0; i < kRings; ++i) {
            ring[i] += cells[j][i] * scale;
            view.before_azimuth[j + 1][i] = static_cast<float>(ring[i]);
        }
    double before = 0;
    for (size_t i = 0; i < kRings; ++i) view.before_ring[i + 1] = static_cast<float>(before += ring[i]);
    return view;
}

/// f cos(theta_i) by s and azimuth, at the corners, edges and middles of all cells, rings first.
std::vector<double> HalfVectorSampler::lattice(const Lobe& lobe, const Vec3f& wo) const {
    const float turn = (m_isotropic ? kPi : 2 * kPi) / static_cast<float>(m_azimuths);
    std::vector<double> points;
    for (int j = 0; j <= 2 * m_azimuths; ++j)
        for (int i = 0; i <= 2 * kRings; ++i) {
            const float rho2 = std::expm1(0.5f * static_cast<float>(i) * m_step), rho = std::sqrt(rho2);
            const float phi = 0.5f * static_cast<float>(j) * turn;
            const Vec2f local(rho * std::cos(phi) * m_own.x, rho * std::sin(phi) * m_own.y);
            const Vec2f slopes = m_isotropic ? turned(local, wo, false) : local;
            const Vec3f h = Vec3f(slopes.x, slopes.y, 1).normalized(), wi = reflect(wo, h);
            points.push_back(above_surface(wo, wi) ? lobe(wo, wi) * 4 * wo.dot(h) * std::pow(h.z, 3.0) * (1 + rho2) : 0.0);
        }
    return points;
}

HalfVectorSampler::Mixture HalfVectorSampler::mixture(const Vec3f& wo) const {
    const auto split = [](float place, int last) {
        const int low = std::clamp(static_cast<int>(place), 0, last);
        return std::pair(low, std::clamp(place - static_cast<float>(low), 0.0f, 1.0f));
    };
    const float towards_horizon = (1 - std::sqrt(std::clamp(wo.z, 0.0f, 1.0f))) / (1 - kLastView);
    const auto [theta, part] = split(towards_horizon * static_cast<float>(m_thetas - 1), m_thetas - 2);
    const float turns = m_isotropic ? 0.0f : std::atan2(wo.y, wo.x) / (2 * kPi);
    const auto [phi, part_phi] = split((turns < 0 ? turns + 1 : turns) * static_cast<float>(m_phis), m_phis - 1);
    Mixture mix;
    for (int corner = 0; corner < 4; ++corner) {
        const bool next = corner & 1, next_phi = corner & 2;
        const double weight = static_cast<double>(next ? part : 1 - part) * (next_phi ? part_phi : 1 - part_phi);
        if (!(weight > 0)) continue;
        const int index = (theta + next) * m_phis + (phi + next_phi) % m_phis;
        mix.view[static_cast<size_t>(mix.count)] = &m_views[static_cast<size_t>(index)];
        mix.weight[static_cast<size_t>(mix.count++)] = weight;
    }
    return mix;
}

Vec3f HalfVectorSampler::sample(const Vec3f& wo, const Vec2f& u, const Vec2f& widths) const {
    const Mixture mix = mixture(wo);
    const double by_lobe = mix.before_ring(kRings);
    if (!(u.x < by_lobe)) return cosine_direction({static_cast<float>((u.x - by_lobe) / (1 - by_lobe)), u.y});
    const int ring = place_of(u.x, kRings, [&](int i) { return mix.before_ring(i); });
    const float s = m_step * (static_cast<float>(ring) + part_of(u.x, mix.before_ring(ring), mix.before_ring(ring + 1)));
    const float side = m_isotropic && u.y < 0.5f ? -1.0f : 1.0f;
    const double y = (m_isotropic ? std::abs(2 * u.y - 1) : u.y) * mix.before_azimuth(ring, m_azimuths);
    const int azimuth = place_of(y, m_azimuths, [&](int j) { return mix.before_azimuth(ring, j); });
    const float at = part_of(y, mix.before_azimuth(ring, azimuth), mix.before_azimuth(ring, azimuth + 1));
    const float phi =
        side * (static_cast<float>(azimuth) + at) * (m_isotropic ? kPi : 2 * kPi) / static_cast<float>(m_azimuths);
    const float rho = std::sqrt(std::expm1(s));
    const Vec2f local(rho * std::cos(phi), rho * std::sin(phi)), across = m_isotropic ? turned(local, wo, false) : local;
    return reflect(wo, Vec3f(across.x * widths.x, across.y * widths.y, 1).normalized());
}

float HalfVectorSampler::pdf(const Vec3f& wo, const Vec3f& wi, const Vec2f& widths) const {
    const Mixture mix = mixture(wo);
    const HalfVector h(wo, wi);
    const Vec2f across(h.wm.x / (h.wm.z * widths.x), h.wm.y / (h.wm.z * widths.y));
    const Vec2f local = m_isotropic ? turned(across, wo, true) : across;
    const float rho2 = local.length2(), s = std::log1p(rho2);
    const float by_cosine = static_cast<float>(1 - mix.before_ring(kRings)) * wi.z / kPi;
    if (!(s < m_step * kRings)) return by_cosine;
    const float turn = m_isotropic ? kPi : 2 * kPi, phi = std::atan2(m_isotropic ? std::abs(local.y) : local.y, local.x);
    const int ring = std::min(static_cast<int>(s / m_step), kRings - 1);
    const float turns = (phi < 0 ? phi + 2 * kPi : phi) / turn;
    const int azimuth = std::min(static_cast<int>(turns * static_cast<float>(m_azimuths)), m_azimuths - 1);
    const double share = mix.before_azimuth(ring, azimuth + 1) - mix.before_azimuth(ring, azimuth);
    const double density = share * m_azimuths / (2 * kPi * m_step);  // of (s, phi), both sides of an isotropic lobe together
    const double slopes = 2 * density / ((1 + rho2) * widths.x * widths.y);
    return static_cast<float>(slopes / (4 * h.cos_theta_d * std::pow(h.wm.z, 3))) + by_cosine;
}

}  // namespace burnish
