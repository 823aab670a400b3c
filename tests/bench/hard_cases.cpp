#include "bench/hard_cases.h"

#include "bench/hard_surfaces.h"
#include "core/scenes.h"

#include <array>
#include <map>
#include <stdexcept>

namespace burnish {
namespace {

using Maker = SparseCase (*)(const HardSettings&);

Material plain(const HardSettings& s) { return {"plain", Color3f(0, 0, 0), {scenes::lobe_of(s.model, s.m, s.m)}}; }

SparseCase of_frame(AovFrame frame, std::vector<Material> materials) {
    Assignment assignment = scenes::whole_frame(frame);
    return {"", std::move(frame), std::move(assignment), std::move(materials), {}};
}

AovFrame sphere(const HardSettings& s, int radius = 400) {
    return scenes::sphere_in_frame(s.height * 16 / 9, s.height, radius * s.height / 1080);
}
AovFrame sheet(const HardSettings& s) { return scenes::covered_frame(s.height * 16 / 9, s.height); }

/// The sphere with a layer made by `value` at each pixel.
template <class Value>
SparseCase layered(const HardSettings& s, Role role, bool PerPixel::*use, int channels, Value&& value) {
    AovFrame frame = sphere(s);
    frame.layers[role] = make_layer(frame, channels, value);
    Material material = plain(s);
    material.lobes[0].per_pixel.*use = true;
    SparseCase made = of_frame(std::move(frame), {material});
    made.surface.roughness_is_alpha = true;
    return made;
}

SparseCase bumped(const HardSettings& s, Vec2f (*slope)(int, int)) {
    AovFrame frame = sphere(s);
    tilt_normals(frame, slope);
    return of_frame(std::move(frame), {plain(s)});
}

SparseCase halved(AovFrame frame, const HardSettings& s) {
    round_to_half(frame.layers[Role::normal]);
    return of_frame(std::move(frame), {plain(s)});
}

SparseCase wires(const HardSettings& s, float width) {
    return of_frame(wire_frame(s.height * 16 / 9, s.height, width), {plain(s)});
}

SparseCase stripes(const HardSettings& s) {
    SparseCase made = of_frame(sphere(s), {});
    for (const float m : {0.02f, 0.1f, 0.4f})
        made.materials.push_back({"stripe", Color3f(0, 0, 0), {scenes::lobe_of(s.model, m, m)}});
    for (size_t i = 0; i < made.assignment.rule.size(); ++i)
        made.assignment.rule[i] = static_cast<int16_t>(
            (static_cast<int>(i) % made.assignment.width + static_cast<int>(i) / made.assignment.width) / 7 % 3);
    made.assignment.counts.assign(3, made.assignment.rule.size() / 3);
    return made;
}

SparseCase long_lobe(const HardSettings& s, float my, AovFrame frame) {
    return of_frame(std::move(frame), {{"long", Color3f(0, 0, 0), {scenes::lobe_of(s.model, 0.2f, my)}}});
}

SparseCase coated(const HardSettings& s) {
    Material material{
        "coated", Color3f(0, 0, 0), {scenes::lobe_of(s.model, 0.3f, 0.3f), scenes::lobe_of(s.model, 0.01f, 0.01f)}};
    material.lobes[1].strength = 0.1f;
    return of_frame(sphere(s), {material});
}

SparseCase see_through(const HardSettings& s) {
    Material material = plain(s);
    material.lobes[0].side = Side::transmission;
    return of_frame(sphere(s), {material});
}

float level(float low, float high, float share) { return low + (high - low) * share; }

const std::map<std::string_view, Maker> kMakers{
    {"noise", [](const HardSettings& s) { return bumped(s, noisy_slope); }},
    {"noise_faint", [](const HardSettings& s) { return bumped(s, faint_slope); }},
    {"bumps", [](const HardSettings& s) { return bumped(s, bumpy_slope); }},
    {"waves", [](const HardSettings& s) { return bumped(s, wavy_slope); }},
    {"tiles", [](const HardSettings& s) { return bumped(s, tiled_slope); }},
    {"half", [](const HardSettings& s) { return halved(sphere(s), s); }},
    {"half_sheet", [](const HardSettings& s) { return halved(sheet(s), s); }},
    {"sheet", [](const HardSettings& s) { return of_frame(sheet(s), {plain(s)}); }},
    {"plane", [](const HardSettings& s) { return of_frame(plane_frame(s.height * 16 / 9, s.height), {plain(s)}); }},
    {"wires1", [](const HardSettings& s) { return wires(s, 1); }},
    {"wires2", [](const HardSettings& s) { return wires(s, 2); }},
    {"wires3", [](const HardSettings& s) { return wires(s, 3); }},
    {"stripes", stripes},
    {"small", [](const HardSettings& s) { return of_frame(sphere(s, 12), {plain(s)}); }},
    {"coated", coated},
    {"see_through", see_through},
    {"long5", [](const HardSettings& s) { return long_lobe(s, 0.05f, sphere(s)); }},
    {"long2", [](const HardSettings& s) { return long_lobe(s, 0.02f, sphere(s)); }},
    {"long2_sheet", [](const HardSettings& s) { return long_lobe(s, 0.02f, sheet(s)); }},
    {"rough_ramp",
     [](const HardSettings& s) {
         return layered(s, Role::roughness, &PerPixel::roughness, 1,
                        [](int x, int, float* out) { *out = level(0.02f, 0.5f, ramp(x)); });
     }},
    {"rough_waves",
     [](const HardSettings& s) {
         return layered(s, Role::roughness, &PerPixel::roughness, 1,
                        [](int x, int y, float* out) { *out = level(0.05f, 0.4f, waves(x, y, 64)); });
     }},
    {"rough_noise",
     [](const HardSettings& s) {
         return layered(s, Role::roughness, &PerPixel::roughness, 1,
                        [](int x, int y, float* out) { *out = level(0.1f, 0.3f, noise(x, y)); });
     }},
    {"tint_ramp",
     [](const HardSettings& s) {
         return layered(s, Role::tint, &PerPixel::tint, 3,
                        [](int x, int, float* out) { out[0] = ramp(x), out[1] = 0.5f, out[2] = 1 - ramp(x); });
     }},
    {"tint_waves16",
     [](const HardSettings& s) {
         return layered(s, Role::tint, &PerPixel::tint, 3,
                        [](int x, int y, float* out) { std::fill_n(out, 3, level(0.9f, 1, waves(x, y, 16))); });
     }},
    {"tint_waves32",
     [](const HardSettings& s) {
         return layered(s, Role::tint, &PerPixel::tint, 3,
                        [](int x, int y, float* out) { std::fill_n(out, 3, level(0.8f, 1, waves(x, y, 32))); });
     }},
    {"tint_waves64",
     [](const HardSettings& s) {
         return layered(s, Role::tint, &PerPixel::tint, 3,
                        [](int x, int y, float* out) { std::fill_n(out, 3, level(0.65f, 1, waves(x, y, 64))); });
     }},
    {"tint_slow",
     [](const HardSettings& s) {
         return layered(s, Role::tint, &PerPixel::tint, 3,
                        [](int x, int y, float* out) { std::fill_n(out, 3, level(0.86f, 1, waves(x, y, 32))); });
     }},
    {"tint_noise",
     [](const HardSettings& s) {
         return layered(s, Role::tint, &PerPixel::tint, 3, [](int x, int y, float* out) { std::fill_n(out, 3, noise(x, y)); });
     }},
    {"tint_faint_noise",
     [](const HardSettings& s) {
         return layered(s, Role::tint, &PerPixel::tint, 3,
                        [](int x, int y, float* out) { std::fill_n(out, 3, level(0.98f, 1, noise(x, y))); });
     }},
    {"weight_squares",
     [](const HardSettings& s) {
         return layered(s, Role::weight, &PerPixel::weight, 1,
                        [](int x, int y, float* out) { *out = (x / 24 + y / 24) % 2 ? 1.0f : 0.2f; });
     }},
    {"turned",
     [](const HardSettings& s) {
         SparseCase made =
             layered(s, Role::rotation, &PerPixel::rotation, 1, [](int x, int y, float* out) { *out = 3 * waves(x, y, 400); });
         made.materials[0].lobes[0].mx = 0.2f, made.materials[0].lobes[0].my = 0.05f;
         return made;
     }},
};

const std::vector<std::string_view> kNames = [] {
    std::vector<std::string_view> names;
    for (const auto& [name, maker] : kMakers) names.push_back(name);
    return names;
}();

}  // namespace

std::span<const std::string_view> hard_case_names() { return kNames; }

SparseCase hard_case(std::string_view name, const HardSettings& settings) {
    SparseCase made = kMakers.at(name)(settings);
    made.name = name;
    return made;
}

}  // namespace burnish
