#include <burnish/frequency/lobe_bandwidth.h>

#include <burnish/base/parallel.h>
#include <burnish/frequency/daubechies.h>
#include <burnish/frequency/local_bandwidth.h>
#include <burnish/material/lobe.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kFine = 2 * LobeBandwidth::kSlice;  // samples a side of a window
constexpr int kBands = 4, kBorder = surround_width(kBands), kWhole = kFine + 2 * kBorder;
constexpr int kSpectrumBands = 5;
constexpr float kQuantile = 0.95f;
constexpr float kThetaStep = 0.5f * kPi / LobeBandwidth::kViews, kPhiStep = 2.0f * kPi / LobeBandwidth::kViews;

int azimuth_count(LobeSymmetry symmetry) {
    switch (symmetry) {
        case LobeSymmetry::isotropic: return 1;
        case LobeSymmetry::orthotropic: return LobeBandwidth::kViews / 4 + 1;
        case LobeSymmetry::none: break;
    }
    return LobeBandwidth::kViews;
}

/// Position of sample i of a window.
float place(int i) { return (2.0f * static_cast<float>(i) + 1.0f) / kFine - 1.0f; }

Image lobe_picture(const std::function<float(const Vec3f&)>& value, const LobeWindow& window) {
    Image picture(kWhole, kWhole, 1);
    for (int y = 0; y < kWhole; ++y) {
        for (int x = 0; x < kWhole; ++x) *picture.at(x, y) = value(window.direction(place(x - kBorder), place(y - kBorder)));
    }
    return picture;
}

/// Of the picture as a whole, cycles per sample. The lobe is a filter: what it does to a constant is part of its spectrum.
float spectrum_limit(const Image& picture) {
    const Image coefficients = daubechies(picture, kSpectrumBands);
    std::vector<float> energies(kSpectrumBands + 1, 0.0f);
    for (int y = 0; y < kWhole; ++y) {
        for (int x = 0; x < kWhole; ++x) {
            int band = 0;
            while (band < kSpectrumBands && x < kWhole >> (band + 1) && y < kWhole >> (band + 1)) ++band;
            energies[band] += *coefficients.at(x, y) * *coefficients.at(x, y);
        }
    }
    return energy_band_limit(energies, 0.0f, kQuantile, kSpectrumBands);
}

LobeBandwidth::View analysed(const std::function<float(const Vec3f&)>& value, const LobeWindow& window) {
    constexpr int step = kFine / LobeBandwidth::kSlice;
    const Image picture = lobe_picture(value, window);
    const Image local = surrounded_bandwidth(picture, kFine, kFine, kBands, {});
    LobeBandwidth::View view{window, spectrum_limit(picture) * 0.5f * kFine * window.stretch(0.0f, 0.0f), {}};
    view.nu.assign(LobeBandwidth::kSlice * LobeBandwidth::kSlice, 0.0f);
    for (int y = 0; y < kFine; ++y) {
        for (int x = 0; x < kFine; ++x) {
            float& largest = view.nu[y / step * LobeBandwidth::kSlice + x / step];
            largest = std::max(largest, *local.at(x, y) * 0.5f * kFine * window.stretch(place(x), place(y)));
        }
    }
    return view;
}

/// Where to look for the lobe: the mirror direction, straight on through the surface, or the brightest of some that are spread
/// over the sphere.
Vec3f brightest(const std::function<float(const Vec3f&)>& value, const Vec3f& wo) {
    constexpr int count = 512;
    Vec3f best(-wo.x, -wo.y, wo.z);
    float most = value(best);
    const auto consider = [&](const Vec3f& wi) {
        if (const float found = value(wi); found > most) best = wi, most = found;
    };
    consider(-wo);
    for (int i = 0; i < count; ++i) {
        const float z = (2.0f * static_cast<float>(i) + 1.0f) / count - 1.0f, turn = 2.399963f * static_cast<float>(i);
        const float side = std::sqrt(1.0f - z * z);
        consider({side * std::cos(turn), side * std::sin(turn), z});
    }
    return best;
}

/// Turns with the view: n along the mirror direction of wo, b level.
Frame mirror_frame(const Vec3f& wo) {
    const float phi = std::atan2(wo.y, wo.x);
    const Vec3f level(-std::sin(phi), std::cos(phi), 0.0f), mirror(-wo.x, -wo.y, wo.z);
    return {level.cross(mirror), level, mirror};
}

LobeFunction luminance_of(const LobeParameters& parameters) {
    return visit_lobe(parameters, [](const auto& lobe) -> LobeFunction {
        return [lobe](const Vec3f& wo, const Vec3f& wi) { return luminance(lobe.eval(wo, wi)); };
    });
}

}  // namespace

LobeBandwidth::LobeBandwidth(const LobeParameters& lobe)
    : LobeBandwidth(luminance_of(lobe), lobe.mx == lobe.my ? LobeSymmetry::isotropic : LobeSymmetry::orthotropic) {}

LobeBandwidth::LobeBandwidth(const LobeFunction& f, LobeSymmetry symmetry)
    : m_symmetry(symmetry),
      m_azimuths(azimuth_count(symmetry)),
      m_views(static_cast<size_t>(kViews) * m_azimuths),
      m_nu_rho(kViews) {
    for_each_index(static_cast<int>(m_views.size()), [&](int view) {
        const Vec3f wo = view_direction(view);
        const auto value = [&](const Vec3f& wi) { return f(wo, wi) * std::fabs(wi.z); };
        m_views[view] = analysed(value, lobe_window(value, brightest(value, wo)));
    });
    for (size_t view = 0; view < m_views.size(); ++view) {
        float& largest = m_nu_rho[view / m_azimuths];
        largest = std::max(largest, m_views[view].nu_rho);
    }
}

Vec3f LobeBandwidth::view_direction(int view) const {
    const float theta = (static_cast<float>(view / m_azimuths) + 0.5f) * kThetaStep;
    const float phi = static_cast<float>(view % m_azimuths) * kPhiStep;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

float LobeBandwidth::nu_rho(float cos_o) const {
    const float row = std::acos(std::clamp(cos_o, 0.0f, 1.0f)) / kThetaStep - 0.5f;
    const float clamped = std::clamp(row, 0.0f, static_cast<float>(kViews - 1));
    const int below = std::min(static_cast<int>(clamped), kViews - 2);
    return m_nu_rho[below] + (clamped - static_cast<float>(below)) * (m_nu_rho[below + 1] - m_nu_rho[below]);
}

int LobeBandwidth::nearest_view(const Vec3f& wo) const {
    const float theta = std::acos(std::clamp(wo.z, 0.0f, 1.0f)), phi = std::atan2(wo.y, wo.x);
    const int row = std::clamp(static_cast<int>(theta / kThetaStep), 0, kViews - 1);
    if (m_symmetry == LobeSymmetry::isotropic) return row;
    return row * m_azimuths + static_cast<int>(std::lround(phi / kPhiStep) + kViews) % kViews;
}

// A sharp lobe moves by more than its width from one view to the next: its window is carried along, on either side of the surface.
float LobeBandwidth::at(const Vec3f& wo, const Vec3f& wi) const {
    const bool fold = m_symmetry == LobeSymmetry::orthotropic;
    const Vec3f quarter(fold ? std::copysign(1.0f, wo.x) : 1.0f, fold ? std::copysign(1.0f, wo.y) : 1.0f, 1.0f);
    const Vec3f side(1.0f, 1.0f, std::copysign(1.0f, wi.z));
    const int nearest = nearest_view(quarter * wo);
    const View& view = m_views[nearest];
    const Vec3f local = mirror_frame(quarter * wo).to_local(quarter * side * wi);
    const Vec3f carried = side * mirror_frame(view_direction(nearest)).to_world(local);
    const Vec2f p = view.window.place(carried);
    const auto cell = [](float x) {
        return std::clamp(static_cast<int>(std::floor((x + 1.0f) * 0.5f * kSlice)), 0, kSlice - 1);
    };
    return view.nu[cell(p.y) * kSlice + cell(p.x)];
}

}  // namespace burnish
