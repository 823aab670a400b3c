#include "error_cases.h"

#include "core/room_light.h"
#include "core/scenes.h"

#include <burnish/base/parallel.h>
#include <burnish/light/filter/gaussian_stack.h>
#include <burnish/material/lobe.h>
#include <burnish/plan/configuration.h>
#include <burnish/shading/disc_light.h>
#include <burnish/shading/factored.h>
#include <burnish/shading/fitted.h>
#include <burnish/shading/table_shading.h>
#include <burnish/shading/tap_rule.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace burnish {
namespace {

constexpr int kSphere = 64, kPixels = 300, kFaceSize = 256, kLightHeight = 512;
constexpr double kHighest_db = 62;  // above it the truth's own noise is all there is

SurfaceSettings brushed() {
    SurfaceSettings settings;
    settings.tangent_axis = Vec3f(0.3f, 1, 0.2f).normalized();
    return settings;
}

/// A sphere that lobes are shown on.
struct Sphere {
    AovFrame frame = scenes::sphere_frame(kSphere);
    Assignment assignment = scenes::whole_frame(frame);
    Surfaces surfaces{frame, assignment, brushed()};
    CheckSample sample = spread_sample(surfaces, assignment, 0, kPixels);
};

/// A table that serves any light of this face size; empty where pixels make their own taps.
TapTable shared_table(const LobeParameters& lobe, const EstimatorSettings& settings, const Environment& light) {
    if (settings.kind == EstimatorKind::factored) return {};
    if (settings.kind == EstimatorKind::fitted) return fitted_table(lobe, settings.samples, light.gaussian_stack());
    const TapRule rule(lobe, settings, [&](float omega) { return light.pyramid().level(omega) + settings.level_bias; });
    const int taps = rule.tap_count(lobe.mx, lobe.my);
    return TapTable::covers(lobe, taps) ? TapTable(lobe, taps, rule) : TapTable();
}

/// What MaterialShader does with a table of its own.
std::vector<Color3f> shaded(const SurfaceBatch& batch, const LobeParameters& lobe, const TapTable& table, bool is_fitted,
                            const Environment& light) {
    std::vector<Color3f> overlay(batch.size(), Color3f(0, 0, 0));
    std::vector<float> samples(batch.size());
    const CubeStack& stack = is_fitted ? light.gaussian_stack().stack() : light.pyramid().stack();
    const float distortion = is_fitted ? 0 : CubePyramid::kDistortion;
    add_table_shading({{lobe, table, light.world_to_light()}, stack, distortion, light.gain()}, batch,
                      {overlay, samples, {}, {}});
    visit_lobe(lobe, [&](const auto& model) {
        for (size_t i = 0; i < batch.size() && !light.discs().empty(); ++i) {
            const ShadingPoint point = shading_point(batch, i, lobe, light.world_to_light());
            overlay[i] += disc_light(model, light.discs(), point) * point.scale * light.gain();
        }
    });
    return overlay;
}

/// One lobe under all the lights.
class LobeErrors {
public:
    LobeErrors(const Sphere& sphere, const LobeParameters& lobe, const std::vector<NamedLight>& lights)
        : m_sphere(sphere), m_lobe(lobe), m_lights(lights), m_truths(lights.size()) {
        m_batch.pixel = sphere.sample.pixels;
        sphere.surfaces.fill(m_batch);
        EstimatorSettings exact;
        exact.kind = EstimatorKind::reference, exact.tolerance = 0.015f;
        for_each_index(static_cast<int>(lights.size()), [&](int i) {
            const MaterialShader reference(m_material, lights[static_cast<size_t>(i)].light, exact);
            m_truths[static_cast<size_t>(i)].emplace(sphere.surfaces, sphere.sample, reference);
        });
    }

    /// Display PSNR under every light.
    std::vector<double> of(const Configuration& configuration) const {
        const EstimatorSettings settings = settled(m_lobe, with({}, configuration));
        const TapTable table = shared_table(m_lobe, settings, m_lights[0].light);
        std::vector<double> psnr_db(m_lights.size(), 0.0);
        if (configuration == kFactored && !can_be_factored(m_material)) return psnr_db;
        for_each_index(static_cast<int>(m_lights.size()), [&](int i) {
            const auto l = static_cast<size_t>(i);
            const Environment& light = m_lights[l].light;
            const bool is_fitted = settings.kind == EstimatorKind::fitted;
            const Closeness close = table.tap_count() > 0
                                        ? m_truths[l]->closeness(shaded(m_batch, m_lobe, table, is_fitted, light))
                                        : m_truths[l]->closeness(MaterialShader(m_material, light, settings));
            psnr_db[l] = std::min(close.psnr_db, kHighest_db);
        });
        return psnr_db;
    }

private:
    const Sphere& m_sphere;
    LobeParameters m_lobe;
    const std::vector<NamedLight>& m_lights;
    Material m_material{"lobe", Color3f(0, 0, 0), {m_lobe}};
    SurfaceBatch m_batch;
    std::vector<std::optional<Truth>> m_truths;
};

}  // namespace

std::vector<LobeClass> lobe_classes() {
    std::vector<LobeClass> classes;
    for (const LobeTail tail : {LobeTail::gaussian, LobeTail::long_tail}) {
        for (const float m : {0.005f, 0.02f, 0.05f, 0.1f, 0.2f, 0.4f, 0.8f}) classes.push_back({tail, 1, m});
        for (const float aspect : {3.0f, 10.0f})
            for (const float m : {0.02f, 0.1f, 0.3f}) classes.push_back({tail, aspect, m});
    }
    return classes;
}

LobeParameters lobe_of(const LobeClass& lobe) {
    const float half = std::sqrt(lobe.aspect);
    return scenes::lobe_of(lobe.tail == LobeTail::gaussian ? ModelId::beckmann : ModelId::ggx, lobe.m * half, lobe.m / half);
}

std::vector<NamedLight> named_lights(int count, uint32_t seed, const std::vector<std::string>& files) {
    EnvironmentSettings settings;
    settings.face_size = kFaceSize;
    std::vector<NamedLight> lights;
    for (uint32_t i = seed; i < seed + static_cast<uint32_t>(count); ++i) {
        const std::string number = std::to_string(i);
        lights.push_back(
            {"stress " + number, Environment::from_image(scenes::stress_light(i, kLightHeight), settings, number)});
        lights.push_back({"room " + number, Environment::from_image(scenes::room_light(i, kLightHeight), settings, number)});
    }
    for (const std::string& file : files)
        lights.push_back({std::filesystem::path(file).stem().string(), Environment::load(file, settings)});
    return lights;
}

std::vector<ErrorCase> measure_errors(const std::vector<NamedLobe>& lobes, const std::vector<NamedLight>& lights,
                                      const std::vector<Configuration>& configurations, const Progress& progress) {
    const Sphere sphere;
    std::vector<ErrorCase> cases;
    for (size_t i = 0; i < lobes.size(); ++i) {
        progress.report("errors", static_cast<float>(i) / static_cast<float>(lobes.size()));
        const size_t first = cases.size();
        for (const NamedLight& light : lights) cases.push_back({lobes[i].name, light.name, lobes[i].lobe, {}});
        const LobeErrors errors(sphere, lobes[i].lobe, lights);
        for (const Configuration& configuration : configurations) {
            const std::vector<double> psnr_db = errors.of(configuration);
            for (size_t l = 0; l < lights.size(); ++l) cases[first + l].psnr_db[configuration] = psnr_db[l];
        }
    }
    return cases;
}

}  // namespace burnish
