#include "training_set.h"

#include "core/scenes.h"

#include <burnish/base/parallel.h>
#include <burnish/material/albedo.h>
#include <burnish/material/lobe.h>
#include <burnish/sampling/sequence.h>
#include <burnish/shading/disc_light.h>
#include <burnish/shading/material_shader.h>
#include <burnish/shading/regular.h>

#include <numeric>

namespace burnish {
namespace {

constexpr int kFaceSize = 256;

constexpr int kCandidates = 32;  // for every point that is kept

void add_sphere_point(const Vec2f& disc, float turn, SurfaceBatch& batch) {
    const float r = std::sqrt(disc.x), phi = 2 * kPi * disc.y;
    const Vec3f n(r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - disc.x));
    batch.pixel.push_back(static_cast<uint32_t>(batch.size()));
    batch.p.push_back(n), batch.n.push_back(n), batch.ng.push_back(n), batch.wo.push_back({0, 0, 1});
    batch.t.push_back(Frame::around(n).turned(turn).t);
}

/// Points of a sphere seen along -z, chosen where squared errors may be large, with their chance relative to an equal choice
/// over the picture: under a few lamps, most of a sphere tells nothing. Tangents are turned at random.
std::pair<SurfaceBatch, std::vector<double>> sphere_points(int count, const TrainingGroup& group, uint32_t seed) {
    const int candidates = kCandidates * count;
    const float wide = 4 * kPi * 16 * group.lobe.mx * group.lobe.my;  // solid angle of the lobe, four times as wide
    std::vector<double> power(candidates);
    for (int i = 0; i < candidates; ++i) {
        SurfaceBatch one;
        add_sphere_point(owen_sobol(i, seed), 0, one);
        const Vec3f n = one.n[0], d = (n * (2 * n.z) - Vec3f(0, 0, 1)) * group.light->world_to_light();
        power[i] = std::pow(group.light->pyramid().lookup(d, group.light->pyramid().level(d, wide)).y, 2);
    }
    const double mean = std::accumulate(power.begin(), power.end(), 0.0) / candidates;
    std::pair<SurfaceBatch, std::vector<double>> chosen;
    double sum = 0;  // of chances; every time it passes a half-integer the candidate is taken
    for (int i = 0; i < candidates; ++i) {
        const double chance = 0.8 * power[i] / mean + 0.2;
        const double before = std::floor(sum + 0.5);
        sum += chance / kCandidates;
        for (double k = before; k < std::floor(sum + 0.5); ++k) {
            add_sphere_point(owen_sobol(i, seed), 2 * kPi * owen_sobol(i, seed + 1).x, chosen.first);
            chosen.second.push_back(chance);
        }
    }
    return chosen;
}

}  // namespace

std::vector<Environment> made_lights(int count, uint32_t seed, const MakeLight& make) {
    EnvironmentSettings settings;
    settings.face_size = kFaceSize;
    std::vector<Environment> lights(count);
    for_each_index(count, [&](int i) { lights[i] = Environment::from_image(make(seed + i), settings, "made"); });
    return lights;
}

std::vector<Environment> lights_from(const std::vector<std::string>& files) {
    EnvironmentSettings settings;
    settings.face_size = kFaceSize;
    std::vector<Environment> lights;
    for (const std::string& file : files) lights.push_back(Environment::load(file, settings));
    return lights;
}

TrainingSet::TrainingSet(LobeTail tail, float aspect, const std::vector<float>& widths, std::span<const Environment> lights,
                         int points, uint32_t seed)
    : m_lights(lights.size()) {
    for (const Environment& light : lights)
        for (const float m : widths) {
            LobeParameters lobe;
            lobe.model = tail == LobeTail::gaussian ? ModelId::beckmann : ModelId::ggx;
            lobe.mx = std::min(m * std::sqrt(aspect), 1.0f), lobe.my = m / std::sqrt(aspect);
            m_groups.push_back({&light, m, lobe, {}, 0});
        }
    for_each_index(static_cast<int>(m_groups.size()), [&](int i) { fill(m_groups[i], points, seed + 1000 * i); });
    for (TrainingGroup& group : m_groups) group.first = m_points, m_points += group.points.size();
}

void TrainingSet::fill(TrainingGroup& group, int points, uint32_t seed) const {
    EstimatorSettings settings;
    settings.kind = EstimatorKind::reference, settings.tolerance = 0.01f;
    const auto [batch, chances] = sphere_points(points, group, seed);
    ShadedBatch truth;
    MaterialShader({"training", Color3f(0, 0, 0), {group.lobe}}, *group.light, settings).shade(batch, truth);
    double power = 0;
    for (size_t i = 0; i < batch.size(); ++i) {
        const ShadingPoint point = shading_point(batch, i, group.lobe, group.light->world_to_light());
        const float suns =
            visit_lobe(group.lobe, [&](const auto& lobe) { return disc_light(lobe, group.light->discs(), point).y; });
        const float value = truth.overlay[i].y - suns, albedo = directional_albedo(group.lobe, point.wo, 2048).y;
        group.points.push_back({point, value, albedo, 1 / std::sqrt(chances[i])});
        power += value * value / chances[i];
    }
    group.scale = 1 / std::sqrt(power * m_groups.size());
}

void TrainingSet::group_errors(const TrainingGroup& group, const LobePattern& pattern, double* errors) const {
    const CubePyramid& pyramid = group.light->pyramid();
    const float bias = EstimatorSettings{}.level_bias;
    visit_lobe(group.lobe, [&](const auto& lobe) {
        std::vector<Tap> taps(pattern.size());
        const auto level_of = [&](float omega) { return pyramid.level(omega) + bias; };
        for (const TrainingPoint& at : group.points) {
            regular_taps(lobe, pattern, Quadrature::half_vector, at.point, level_of, taps);
            float light = 0, constant_light = 0;
            for (const Tap& tap : taps) {
                const Vec3f d = at.point.frame.to_world(tap.wi);
                light += tap.weight.x * pyramid.lookup(d, tap.level + CubePyramid::kDistortion * cube_distortion(d)).y;
                constant_light += tap.weight.x;
            }
            const float estimate = constant_light > 0 ? light * at.albedo / constant_light : 0;
            *errors++ = (estimate - at.truth) * at.importance * group.scale;
        }
    });
}

std::vector<float> TrainingSet::point_widths() const {
    std::vector<float> widths;
    for (const TrainingGroup& group : m_groups) widths.insert(widths.end(), group.points.size(), group.m);
    return widths;
}

std::vector<double> TrainingSet::errors(const PatternOf& pattern_of) const {
    std::vector<double> all(m_points);
    for_each_index(static_cast<int>(m_groups.size()),
                   [&](int i) { group_errors(m_groups[i], pattern_of(m_groups[i].m), all.data() + m_groups[i].first); });
    return all;
}

double TrainingSet::width_error(float m, const std::vector<double>& errors) const {
    double sum = 0;
    for (const TrainingGroup& group : m_groups) {
        const double* own = errors.data() + group.first;
        if (group.m == m) sum = std::inner_product(own, own + group.points.size(), own, sum);
    }
    return std::sqrt(sum * m_groups.size() / m_lights);
}

void TrainingSet::relate_to(const std::vector<LobePattern>& rules) {
    std::vector<double> best(m_groups.size(), 1e30);
    for (const LobePattern& rule : rules) {
        const std::vector<double> all = errors([&](float) { return rule; });
        for (size_t g = 0; g < m_groups.size(); ++g) best[g] = std::min(best[g], width_error(m_groups[g].m, all));
    }
    for (size_t g = 0; g < m_groups.size(); ++g) m_groups[g].scale /= best[g];
}

}  // namespace burnish
