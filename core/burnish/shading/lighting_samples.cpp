#include <burnish/shading/lighting_samples.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/factor/direction_map.h>
#include <burnish/light/filter/cube_faces.h>
#include <burnish/sampling/sequence.h>
#include <burnish/shading/material_shader.h>

#include <mutex>
#include <span>

namespace burnish {
namespace {

constexpr float kLeastCosine = 1e-4f;  // n . wo: below it, rounding decides whether the surface is seen at all

std::vector<Vec3f> grid_directions(int size) {
    const DirectionMap map(Mapping::double_parabolic, size);
    std::vector<Vec3f> all;
    for (int texel = 0; texel < map.texels(); ++texel)
        if (map.holds(texel)) all.push_back(map.direction(texel));
    return all;
}

/// Pairs whose value is still to be found.
std::vector<FactorSample> pairs_of(const LightingSampling& sampling) {
    constexpr uint32_t kSeed = 21;
    const std::vector<Vec3f> grid = grid_directions(sampling.size);
    std::vector<FactorSample> pairs;
    if (sampling.weight == ViewWeight::projected) {
        const auto count = static_cast<uint32_t>(grid.size() * grid.size() / 2);
        for (uint32_t i = 0; i < count; ++i) pairs.push_back({seen_pair(i, kSeed), Color3f(0, 0, 0)});
        return pairs;
    }
    for (const Vec3f& n : grid)
        for (const Vec3f& wo : grid)
            if (n.dot(wo) >= kLeastCosine) pairs.push_back({{n, wo}, Color3f(0, 0, 0)});
    return pairs;
}

/// The light as its picture has it: neither turned nor scaled.
Environment as_pictured(const Environment& light) {
    EnvironmentSettings settings = light.settings();
    settings.rotate_deg = 0, settings.flip = false, settings.scale = 1, settings.tint = Color3f(1, 1, 1);
    return light.relit(settings);
}

SurfaceBatch batch_of(std::span<const FactorSample> pairs, const Matrix33f& light_to_world) {
    SurfaceBatch batch;
    for (const FactorSample& sample : pairs) {
        batch.pixel.push_back(static_cast<uint32_t>(batch.pixel.size()));
        batch.n.push_back(sample.pair.a * light_to_world), batch.wo.push_back(sample.pair.b * light_to_world);
    }
    return batch;
}

}  // namespace

void require_factorable(const Material& material) {
    for (const LobeParameters& lobe : material.lobes) {
        const bool layers = lobe.per_pixel.roughness || lobe.per_pixel.anisotropy || lobe.per_pixel.rotation;
        if (lobe.is_anisotropic())
            throw Error(ErrorCode::bad_argument,
                        "material '" + material.name +
                            "' is anisotropic: what it reflects depends on the tangent, which maps of normal and view "
                            "do not know; use another estimator, or equal widths mx and my");
        if (layers)
            throw Error(ErrorCode::bad_argument,
                        "material '" + material.name +
                            "' takes its roughness from a layer of the frame: maps are made for one roughness; "
                            "use another estimator, or a fixed roughness");
    }
}

std::vector<FactorSample> lighting_samples(const Material& material, const Environment& light, const LightingSampling& sampling,
                                           const Progress& progress) {
    require_factorable(material);
    const Environment pictured = as_pictured(light);
    const MaterialShader shader(material, pictured, sampling.estimator);
    const Matrix33f light_to_world = pictured.world_to_light().transposed();
    std::vector<FactorSample> all = pairs_of(sampling);
    constexpr size_t kBlock = 512;
    const size_t blocks = (all.size() + kBlock - 1) / kBlock;
    std::mutex reporting;
    size_t done = 0;
    for_each_index(static_cast<int>(blocks), [&](int block) {
        const size_t begin = static_cast<size_t>(block) * kBlock;
        const std::span<FactorSample> own = std::span(all).subspan(begin, std::min(kBlock, all.size() - begin));
        const SurfaceBatch batch = batch_of(own, light_to_world);
        ShadedBatch shaded;
        sampling.suns ? shader.shade(batch, shaded) : shader.shade_without_suns(batch, shaded);
        for (size_t i = 0; i < own.size(); ++i) own[i].value = shaded.overlay[i];
        const std::lock_guard lock(reporting);
        progress.report("lighting", static_cast<float>(++done) / static_cast<float>(blocks));
    });
    return all;
}

DirectionPair seen_pair(uint32_t i, uint32_t seed) {
    // Two sequences of the same index keep step, whatever their seeds: views are drawn by themselves.
    const Vec2f u = owen_sobol(i, seed), v(unit_fraction(hash_bits(i, seed + 1)), unit_fraction(hash_bits(i, seed + 2)));
    const float z = 1 - 2 * u.x, r = std::sqrt(std::max(1 - z * z, 0.0f)), phi = 2 * kPi * u.y;
    const Vec3f n(r * std::cos(phi), r * std::sin(phi), z);
    const float cosine = std::max(std::sqrt(v.x), kLeastCosine), s = std::sqrt(1 - cosine * cosine), turn = 2 * kPi * v.y;
    return {n, Frame::around(n).to_world({s * std::cos(turn), s * std::sin(turn), cosine})};
}

Vec3f dominant_direction(const Environment& light) {
    Imath::V3d sum(0, 0, 0);
    double total = 0;
    const auto add = [&](const Vec3f& d, double energy) { sum += Imath::V3d(d) * energy, total += energy; };
    for (int face = 0; face < 6; ++face) {
        const Image& picture = light.faces()[face];
        const int size = picture.width;
        const auto edge = [&](int i) { return 2.0 * i / size - 1; };
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const float* rgb = picture.at(x, y);
                const double area = cube_solid_angle(edge(x), edge(x + 1), edge(y), edge(y + 1));
                const Vec3f d = face_to_cube(face, face_place(x, y, size));
                add(d / d.length(), area * luminance({rgb[0], rgb[1], rgb[2]}));
            }
    }
    for (const BrightDisc& disc : light.discs()) add(disc.direction, luminance(disc.flux));
    constexpr double kFromEverywhere = 1e-4;  // share of the light that is left when directions cancel out
    return sum.length() > kFromEverywhere * total ? Vec3f(sum / sum.length()) : Vec3f(0, 0, 1);
}

}  // namespace burnish
