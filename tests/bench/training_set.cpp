#include "training_set.h"

#include "core/scenes.h"

#include <burnish/base/parallel.h>
#include <burnish/material/albedo.h>
#include <burnish/material/lobe.h>
#include <burnish/sampling/sequence.h>
#include <burnish/shading/material_shader.h>
#include <burnish/shading/regular.h>

#include <numeric>

namespace burnish {
namespace {

constexpr int kFaceSize = 256;

/// Points spread over the visible half of a sphere, equally over its picture, seen along -z; tangents turned at random.
SurfaceBatch sphere_points(int count, uint32_t seed) {
    SurfaceBatch batch;
    for (int i = 0; i < count; ++i) {
        const Vec2f disc = owen_sobol(i, seed), turn = owen_sobol(i, seed + 1);
        const float r = std::sqrt(disc.x), phi = 2 * kPi * disc.y;
        const Vec3f n(r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - disc.x));
        batch.pixel.push_back(i);
        batch.p.push_back(n), batch.n.push_back(n), batch.ng.push_back(n), batch.wo.push_back({0, 0, 1});
        batch.t.push_back(Frame::around(n).turned(2 * kPi * turn.x).t);
    }
    return batch;
}

}  // namespace

TrainingSet::TrainingSet(LobeTail tail, float aspect, const std::vector<float>& widths, int lights, int points, uint32_t seed) {
    EnvironmentSettings settings;
    settings.face_size = kFaceSize;
    for (int i = 0; i < lights; ++i)
        m_lights.push_back(Environment::from_image(scenes::stress_light(seed + i, 2 * kFaceSize), settings, "stress"));
    for (const Environment& light : m_lights)
        for (const float m : widths) {
            LobeParameters lobe;
            lobe.model = tail == LobeTail::gaussian ? ModelId::beckmann : ModelId::ggx;
            lobe.mx = std::min(m * std::sqrt(aspect), 1.0f), lobe.my = m / std::sqrt(aspect);
            m_groups.push_back({&light, lobe, {}, 0});
        }
    for_each_index(static_cast<int>(m_groups.size()), [&](int i) { fill(m_groups[i], points, seed + 1000 * i); });
    m_points = m_groups.size() * points;
}

void TrainingSet::fill(TrainingGroup& group, int points, uint32_t seed) const {
    EstimatorSettings settings;
    settings.kind = EstimatorKind::reference, settings.tolerance = 0.01f;
    const SurfaceBatch batch = sphere_points(points, seed);
    ShadedBatch truth;
    MaterialShader({"training", Color3f(0, 0, 0), {group.lobe}}, *group.light, settings).shade(batch, truth);
    double power = 0;
    for (int i = 0; i < points; ++i) {
        const ShadingPoint point = shading_point(batch, i, group.lobe, group.light->world_to_light());
        group.points.push_back({point, truth.overlay[i].y, directional_albedo(group.lobe, point.wo, 2048).y});
        power += truth.overlay[i].y * truth.overlay[i].y;
    }
    group.scale = 1 / std::sqrt(power * m_groups.size());
}

void TrainingSet::group_errors(const TrainingGroup& group, const LobePattern& pattern, double* errors) const {
    const CubePyramid& pyramid = group.light->pyramid();
    const float bias = EstimatorSettings{}.level_bias;
    visit_lobe(group.lobe, [&](const auto& lobe) {
        for (const TrainingPoint& at : group.points) {
            const auto look = [&](const Vec3f& wi, float omega) {  // red: the light, green: constant light
                const Vec3f d = at.point.frame.to_world(wi);
                return Color3f(pyramid.lookup(d, pyramid.level(d, omega) + bias).y, 1, 0);
            };
            const Color3f sum = regular_estimate(lobe, pattern, Quadrature::half_vector, at.point, look);
            const float estimate = sum.y > 0 ? sum.x * at.albedo / sum.y : 0;
            *errors++ = (estimate - at.truth) * group.scale;
        }
    });
}

std::vector<double> TrainingSet::errors(const LobePattern& pattern) const {
    std::vector<double> all(m_points);
    const size_t each = m_points / m_groups.size();
    for_each_index(static_cast<int>(m_groups.size()),
                   [&](int i) { group_errors(m_groups[i], pattern, all.data() + i * each); });
    return all;
}

void TrainingSet::relate_to(const LobePattern& rule) {
    const std::vector<double> all = errors(rule);
    const size_t each = m_points / m_groups.size();
    const auto mean_square = [&](float mx) {  // over the lights, at one width
        double sum = 0;
        for (size_t g = 0; g < m_groups.size(); ++g)
            if (m_groups[g].lobe.mx == mx) sum = std::inner_product(&all[g * each], &all[g * each] + each, &all[g * each], sum);
        return sum * m_groups.size() / m_lights.size();
    };
    std::vector<double> scales;
    for (const TrainingGroup& group : m_groups) scales.push_back(group.scale / std::sqrt(mean_square(group.lobe.mx)));
    for (size_t g = 0; g < m_groups.size(); ++g) m_groups[g].scale = scales[g];
}

}  // namespace burnish
