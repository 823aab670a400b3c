#include <burnish/base/parallel.h>
#include <burnish/sampling/sequence.h>
#include <burnish/scene/bake_frame.h>
#include <burnish/scene/gbuffer.h>

namespace burnish {
namespace {

void put(float* to, const Color3f& c) { to[0] = c.x, to[1] = c.y, to[2] = c.z; }

/// Calls `add(hit, diameter)` for what the samples of a pixel meet, `diameter` being a sample's width there in scene units.
template <class Add>
void sample_pixel(const Tracer& tracer, const View& view, int x, int y, int samples, const Add& add) {
    const auto seed = hash_bits(static_cast<uint32_t>(x), static_cast<uint32_t>(y));
    const float spread =
        2 * view.camera.right.length() / static_cast<float>(view.width) / std::sqrt(static_cast<float>(samples));
    const Vec2f corner(static_cast<float>(x), static_cast<float>(y));
    for (uint32_t i = 0; i < static_cast<uint32_t>(samples); ++i)
        if (const auto hit = view.closest(tracer, corner + owen_sobol(i, seed))) add(*hit, spread * hit->distance);
}

/// Means over the samples of a pixel.
struct Pixel {
    Color3f beauty{0.0f}, albedo{0.0f}, irradiance{0.0f};  // the last two over those that see a surface
    float alpha = 0;
};

Pixel seen(const Tracer& tracer, const View& view, const SurfaceLight& light, int x, int y, int samples, bool apart) {
    Pixel sum;
    sample_pixel(tracer, view, x, y, samples, [&](const Hit& hit, float diameter) {
        sum.beauty += light.radiance(hit, diameter);
        sum.alpha += 1;
        if (apart) sum.albedo += light.albedo(hit, diameter), sum.irradiance += light.irradiance(hit, diameter) * kPi;
    });
    if (sum.alpha > 0) sum.albedo /= sum.alpha, sum.irradiance /= sum.alpha;
    sum.beauty /= static_cast<float>(samples), sum.alpha /= static_cast<float>(samples);
    return sum;
}

}  // namespace

void add_seen_light(AovFrame& frame, const Tracer& tracer, const View& view, const SurfaceLight& light, int samples,
                    LightParts parts, const Progress& progress) {
    const int width = view.width, height = view.height;
    const bool apart = parts == LightParts::apart;
    Image beauty(width, height, 3), alpha(width, height, 1);
    Image albedo(apart ? width : 0, height, 3), irradiance(apart ? width : 0, height, 3);
    for_each_tile(width, height, progress, "colouring", [&](const Window& tile) {
        for (int y = tile.y; y < tile.y + tile.height; ++y)
            for (int x = tile.x; x < tile.x + tile.width; ++x) {
                const Pixel pixel = seen(tracer, view, light, x, y, samples, apart);
                put(beauty.at(x, y), pixel.beauty);
                *alpha.at(x, y) = pixel.alpha;
                if (apart) put(albedo.at(x, y), pixel.albedo), put(irradiance.at(x, y), pixel.irradiance);
            }
    });
    frame.layers[Role::beauty] = std::move(beauty);
    frame.layers[Role::alpha] = std::move(alpha);
    if (!apart) return;
    frame.layers[Role::diffuse_albedo] = std::move(albedo);
    frame.layers[Role::irradiance] = std::move(irradiance);
}

}  // namespace burnish
