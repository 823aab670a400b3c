#include <burnish/base/parallel.h>
#include <burnish/scene/diffuse.h>
#include <burnish/scene/gbuffer.h>
#include <burnish/scene/light_field.h>

namespace burnish {
namespace {

/// Sums over the colour samples of one pixel.
struct PixelSum {
    Color3f albedo{0.0f}, direct{0.0f}, indirect{0.0f}, sky{0.0f};

    void add(const Color3f& rho, const Irradiance& e) {
        albedo += rho, direct += rho * e.direct / kPi, indirect += rho * e.indirect / kPi;
    }
};

void put(Image& image, size_t pixel, const Color3f& c) {
    float* to = image.at(pixel);
    to[0] = c.x, to[1] = c.y, to[2] = c.z;
}

/// light / albedo where there is albedo, so that albedo * result gives the light back.
Color3f divided(const Color3f& light, const Color3f& albedo) {
    const auto ratio = [](float a, float b) { return b > 0 ? a / b : 0.0f; };
    return {ratio(light.x, albedo.x), ratio(light.y, albedo.y), ratio(light.z, albedo.z)};
}

}  // namespace

void add_diffuse(AovFrame& frame, const Tracer& tracer, const DistantLight& light, const DiffuseSettings& settings,
                 const Progress& progress) {
    const int width = frame.data_window.width, height = frame.data_window.height, n = settings.antialias;
    const IrradianceGatherer gatherer(tracer, light, settings.bounce_samples);
    const LightField field(frame, tracer, gatherer, progress);
    Image albedo(width, height, 3), direct(width, height, 3), indirect(width, height, 3), beauty(width, height, 3);
    for_each_tile(width, height, progress, "colouring", [&](const Window& tile) {
        for (int y = tile.y; y < tile.y + tile.height; ++y)
            for (int x = tile.x; x < tile.x + tile.width; ++x) {
                PixelSum sum;
                for (int i = 0; i < n * n; ++i) {
                    const Vec2f at = subpixel(x, y, i, n);
                    if (const auto hit = closest_at(tracer, *frame.camera, at, width, height))
                        sum.add(tracer.scene().objects[static_cast<size_t>(hit->object)].albedo,
                                field.around(*hit, at.x, at.y));
                    else
                        sum.sky += light.radiance(frame.camera->ray(screen_point(at, width, height)).normalized());
                }
                const size_t pixel = static_cast<size_t>(y) * width + x;
                const float share = 1.0f / static_cast<float>(n * n);
                put(albedo, pixel, sum.albedo * share);
                put(direct, pixel, divided(sum.direct, sum.albedo));
                put(indirect, pixel, divided(sum.indirect, sum.albedo));
                put(beauty, pixel, (sum.direct + sum.indirect + sum.sky) * share);
            }
    });
    frame.layers[Role::diffuse_albedo] = std::move(albedo);
    frame.layers[Role::diffuse_direct] = std::move(direct);
    frame.layers[Role::diffuse_indirect] = std::move(indirect);
    frame.layers[Role::beauty] = std::move(beauty);
    frame.layers[Role::alpha] = Image(width, height, 1, 1.0f);
}

}  // namespace burnish
