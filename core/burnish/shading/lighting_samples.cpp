#include <burnish/shading/lighting_samples.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/factor/direction_map.h>
#include <burnish/light/filter/cube_faces.h>
#include <burnish/shading/material_shader.h>

#include <mutex>

namespace burnish {
namespace {

constexpr float kLeastCosine = 1e-4f;  // n . wo: below it, rounding decides whether the surface is seen at all

/// A direction of the grid and the solid angle it stands for.
struct GridDirection {
    Vec3f d;
    float solid_angle;
};

std::vector<GridDirection> grid_directions(int size) {
    const DirectionMap map(Mapping::double_parabolic, size);
    std::vector<GridDirection> all;
    for (int texel = 0; texel < map.texels(); ++texel)
        if (map.holds(texel)) all.push_back({map.direction(texel), static_cast<float>(map.solid_angle(texel))});
    return all;
}

/// The light as its picture has it: neither turned nor scaled.
Environment as_pictured(const Environment& light) {
    EnvironmentSettings settings = light.settings();
    settings.rotate_deg = 0, settings.flip = false, settings.scale = 1, settings.tint = Color3f(1, 1, 1);
    return light.relit(settings);
}

/// All views of one normal that are in front of it.
struct ViewsOf {
    SurfaceBatch batch;                 // world
    std::vector<FactorSample> samples;  // light axes

    ViewsOf(const GridDirection& normal, const std::vector<GridDirection>& views, const Matrix33f& light_to_world,
            ViewWeight weight) {
        for (const GridDirection& view : views) {
            const float cosine = normal.d.dot(view.d);
            if (cosine < kLeastCosine) continue;
            const float seen = cosine * normal.solid_angle * view.solid_angle;
            samples.push_back({{normal.d, view.d}, Color3f(0, 0, 0), weight == ViewWeight::projected ? seen : 1});
            batch.pixel.push_back(static_cast<uint32_t>(batch.pixel.size()));
            batch.n.push_back(normal.d * light_to_world), batch.wo.push_back(view.d * light_to_world);
        }
    }
};

/// Weights whose mean is 1.
void normalise(std::vector<FactorSample>& samples) {
    double sum = 0;
    for (const FactorSample& sample : samples) sum += sample.weight;
    const float scale = static_cast<float>(static_cast<double>(samples.size()) / sum);
    for (FactorSample& sample : samples) sample.weight *= scale;
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
    const std::vector<GridDirection> grid = grid_directions(sampling.size);
    const Matrix33f light_to_world = pictured.world_to_light().transposed();
    std::vector<std::vector<FactorSample>> of_normal(grid.size());
    std::mutex reporting;
    size_t done = 0;
    for_each_index(static_cast<int>(grid.size()), [&](int i) {
        ViewsOf views(grid[i], grid, light_to_world, sampling.weight);
        ShadedBatch shaded;
        sampling.suns ? shader.shade(views.batch, shaded) : shader.shade_without_suns(views.batch, shaded);
        for (size_t k = 0; k < views.samples.size(); ++k) views.samples[k].value = shaded.overlay[k];
        of_normal[i] = std::move(views.samples);
        const std::lock_guard lock(reporting);
        progress.report("lighting", static_cast<float>(++done) / static_cast<float>(grid.size()));
    });
    std::vector<FactorSample> all;
    for (const std::vector<FactorSample>& samples : of_normal) all.insert(all.end(), samples.begin(), samples.end());
    normalise(all);
    return all;
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
