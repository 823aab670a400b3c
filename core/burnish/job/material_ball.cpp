#include <burnish/base/parallel.h>
#include <burnish/job/material_ball.h>
#include <burnish/material/diffuse_reflectance.h>
#include <burnish/sampling/sequence.h>
#include <burnish/scene/procedural_sky.h>
#include <burnish/shading/material_shader.h>

#include <vector>

namespace burnish {
namespace {

constexpr float kRadius = 0.94f;  // of half the picture
constexpr float kGrey = 0.05f;    // behind previews, linear

EnvironmentSettings z_up() {
    EnvironmentSettings settings;
    settings.convention = EnvironmentConvention::blender, settings.up = UpAxis::z;
    return settings;
}

/// Irradiance / pi for all directions of a small lat-long picture, by importance samples of the light.
Image diffuse_picture(const Environment& light) {
    constexpr int kWidth = 64;
    constexpr uint32_t kSamples = 4096, kSeed = 7;
    const Matrix33f to_world = light.world_to_light().transposed();
    std::vector<std::pair<Vec3f, Color3f>> samples;
    for (uint32_t i = 0; i < kSamples; ++i) {
        float pdf = 0;
        const Vec3f d = light.sample(owen_sobol(i, kSeed), pdf);
        samples.emplace_back(d * to_world, light.radiance(d) * light.gain() / (pdf * kSamples * kPi));
    }
    Image picture(kWidth, kWidth / 2, 3);
    for_each_index(picture.height, [&](int y) {
        for (int x = 0; x < kWidth; ++x) {
            const Vec3f n = latlong_direction(x + 0.5f, y + 0.5f, picture.width, picture.height);
            Color3f sum(0, 0, 0);
            for (const auto& [d, weight] : samples) sum += weight * std::max(n.dot(d), 0.0f);
            std::copy_n(&sum.x, 3, picture.at(x, y));
        }
    });
    return picture;
}

/// Samples of one row of pixels, those that see the ball, and the column of pixels each belongs to.
struct BallRow {
    SurfaceBatch batch;
    std::vector<int> column;

    BallRow(int y, const BallSettings& settings) {
        const int across = settings.size * settings.samples;
        const float scale = 2 / (static_cast<float>(across) * kRadius), middle = 0.5f * static_cast<float>(across) - 0.5f;
        for (int row = y * settings.samples; row < (y + 1) * settings.samples; ++row)
            for (int i = 0; i < across; ++i) {
                const float x = (static_cast<float>(i) - middle) * scale, z = (middle - static_cast<float>(row)) * scale;
                const float depth2 = 1 - x * x - z * z;
                if (depth2 <= 0) continue;
                const Vec3f n(x, -std::sqrt(depth2), z);
                batch.pixel.push_back(static_cast<uint32_t>(row * across + i));
                batch.n.push_back(n), batch.p.push_back(n), batch.wo.push_back(Vec3f(0, -1, 0));
                batch.t.push_back(Frame::along(n, Vec3f(-n.y, n.x, 0)).t);
                column.push_back(i / settings.samples);
            }
    }
};

}  // namespace

BallLight BallLight::sky() {
    constexpr int kWidth = 1024, kSamples = 2;
    return BallLight(Environment::from_image(ProceduralSky().picture(kWidth, kSamples), z_up(), "sky"));
}

BallLight BallLight::load(const std::string& file) {
    EnvironmentSettings settings;
    settings.up = UpAxis::z;
    return BallLight(Environment::load(file, settings));
}

BallLight::BallLight(Environment light)
    : m_light(std::move(light)), m_diffuse(Environment::from_image(diffuse_picture(m_light), z_up(), "irradiance")) {}

Color3f BallLight::diffuse(const Vec3f& n) const { return m_diffuse.radiance(n * m_diffuse.world_to_light()); }

Image render_ball(const Material& material, const BallLight& light, const BallSettings& settings) {
    const MaterialShader shader(material, light.environment(), settings.estimator);
    const DiffuseReflectance kd(material);
    const float share = 1.0f / static_cast<float>(settings.samples * settings.samples);
    Image ball(settings.size, settings.size, 4);
    for_each_index(settings.size, [&](int y) {
        const BallRow row(y, settings);
        ShadedBatch shaded;
        shader.shade(row.batch, shaded);
        for (size_t i = 0; i < row.batch.size(); ++i) {
            const Vec3f n = row.batch.n[i];
            const Color3f color = shaded.overlay[i] + kd.at(n.dot(row.batch.wo[i])) * light.diffuse(n);
            float* pixel = ball.at(row.column[i], y);
            for (int c = 0; c < 3; ++c) pixel[c] += share * color[c];
            pixel[3] += share;
        }
    });
    return ball;
}

Image over_grey(const Image& ball) {
    Image picture(ball.width, ball.height, 3);
    for (size_t i = 0; i < ball.pixel_count(); ++i)
        for (int c = 0; c < 3; ++c) picture.at(i)[c] = ball.at(i)[c] + (1 - ball.at(i)[3]) * kGrey;
    return picture;
}

}  // namespace burnish
