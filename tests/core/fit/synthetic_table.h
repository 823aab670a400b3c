// Goniometer tables made from materials whose numbers are known: the source's grids of incident directions, with the faults of real
// measurements: noise in ratio, noise of the sensor, and a shadow of the sensor on the sample where nothing is recorded.
#pragma once

#include <burnish/material/lobe.h>
#include <burnish/material/measured/measured_brdf.h>

#include <random>
#include <string>
#include <vector>

namespace burnish::testing {

struct Faults {
    float ratio = 0;       // standard deviation of noise in ratio to f
    float floor = 0;       // standard deviation of the sensor's noise, in f
    float shadow_deg = 0;  // nothing is recorded this close to the incident direction
};

/// The angles a table is measured at.
struct GonioGrid {
    std::vector<float> theta_i_deg, phi_i_deg;
    float step_deg = 5;  // of the outgoing directions, from step / 2 on in theta
    bool below = false;  // the lower hemisphere, too
};

/// Walkthrough, fig. 3.11, 3.14 and 3.17.
inline GonioGrid aluminum_grid(float step_deg) { return {{0, 5, 20, 35, 50, 65}, {0, 15, 30, 45, 60, 75, 90}, step_deg}; }
inline GonioGrid foil_grid(float step_deg) { return {{0, 5, 19, 33, 47, 61, 75}, {0}, step_deg, true}; }

inline Vec3f direction(float theta_deg, float phi_deg) {
    const float theta = theta_deg * kPi / 180, phi = phi_deg * kPi / 180;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// f of a material for any pair of directions.
inline Color3f material_f(const Material& material, const Vec3f& wo, const Vec3f& wi) {
    const Side side = wi.z < 0 ? Side::transmission : Side::reflection;
    Color3f f = side == Side::reflection ? material.kd / kPi : Color3f(0);
    for (const LobeParameters& lobe : material.lobes)
        if (lobe.side == side)
            visit_lobe(lobe, [&](const auto& model) { f += lobe.tint * lobe.strength * model.eval(wo, wi); });
    return f;
}

inline std::vector<BrdfSample> measure(const Material& material, const GonioGrid& grid, const Faults& faults,
                                       unsigned seed = 1) {
    std::mt19937 random(seed);
    std::normal_distribution<float> normal;
    std::vector<BrdfSample> samples;
    const auto record = [&](const Vec3f& incident, const Vec3f& outgoing) {
        const bool through = outgoing.z < 0;
        BrdfSample sample{through ? incident : outgoing, through ? outgoing : incident, Color3f(0)};
        sample.f = material_f(material, sample.wo, sample.wi);
        for (int c = 0; c < 3; ++c)
            sample.f[c] = std::max(0.0f, sample.f[c] * (1 + faults.ratio * normal(random)) + faults.floor * normal(random));
        if (faults.shadow_deg > 0 && std::abs(incident.dot(outgoing)) > std::cos(faults.shadow_deg * kPi / 180))
            sample.f = Color3f(0);
        samples.push_back(sample);
    };
    for (const float phi_i : grid.phi_i_deg)
        for (const float theta_i : grid.theta_i_deg)
            for (float theta = grid.step_deg / 2; theta < (grid.below ? 180 : 90); theta += grid.step_deg)
                for (float phi = 0; phi < 360; phi += grid.step_deg) record(direction(theta_i, phi_i), direction(theta, phi));
    return samples;
}

/// Noise of the same size in all channels, as one sensor behind no filter has.
inline std::vector<BrdfSample> measure_grey(const Material& material, const GonioGrid& grid, const Faults& faults,
                                            unsigned seed = 1) {
    std::vector<BrdfSample> samples = measure(material, grid, faults, seed);
    for (BrdfSample& sample : samples) sample.f = Color3f(sample.f.x);
    return samples;
}

inline LobeParameters kurt_lobe(float ks, float mx, float my, float r0, float alpha) {
    LobeParameters lobe;
    lobe.strength = ks, lobe.mx = mx, lobe.my = my;
    lobe.fresnel = {FresnelKind::schlick, Color3f(r0)};
    lobe.extra = {alpha};
    return lobe;
}

inline LobeParameters through(LobeParameters lobe) {
    lobe.side = Side::transmission;
    lobe.fresnel.complement = true;
    return lobe;
}

struct KnownMaterial {
    std::string name;
    GonioGrid grid;
    Material material;
};

/// Walkthrough, tables 3.1 to 3.3.
inline std::vector<KnownMaterial> published_materials(float step_deg) {
    const auto made = [](float kd, std::vector<LobeParameters> lobes) {
        Material material;
        material.kd = Color3f(kd);
        material.lobes = std::move(lobes);
        return material;
    };
    const GonioGrid aluminum = aluminum_grid(step_deg), foil = foil_grid(step_deg);
    return {
        {"scattergloss, one lobe", aluminum, made(0.003f, {kurt_lobe(0.9f, 0.11f, 0.072f, 0.89f, 0.43f)})},
        {"scattergloss, two lobes", aluminum,
         made(0.003f, {kurt_lobe(0.9f, 0.11f, 0.07f, 0.87f, 0.45f), kurt_lobe(0.12f, 0.25f, 0.17f, 0.89f, 0.6f)})},
        {"white foil", foil,
         made(0.76f, {kurt_lobe(0.78f, 0.124f, 0.136f, 0.029f, 0.5f), through(kurt_lobe(0.67f, 0.25f, 0.17f, 0.75f, 0.6f))})},
        {"miro, one lobe", aluminum, made(0.003f, {kurt_lobe(0.98f, 0.0068f, 0.0297f, 0.84f, 0.49f)})},
        {"miro, two lobes", aluminum,
         made(0.003f, {kurt_lobe(0.57f, 0.0046f, 0.0267f, 0.94f, 0.5f), kurt_lobe(0.54f, 0.013f, 0.1199f, 0.84f, 0.38f)})}};
}

}  // namespace burnish::testing
