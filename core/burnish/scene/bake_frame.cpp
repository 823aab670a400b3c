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

template <class Work>
void for_each_pixel(const View& view, const Progress& progress, const char* stage, const Work& work) {
    for_each_tile(view.width, view.height, progress, stage, [&](const Window& tile) {
        for (int y = tile.y; y < tile.y + tile.height; ++y)
            for (int x = tile.x; x < tile.x + tile.width; ++x) work(x, y);
    });
}

}  // namespace

void add_seen_light(AovFrame& frame, const Tracer& tracer, const View& view, const SurfaceLight& light, int samples,
                    const Progress& progress) {
    Image beauty(view.width, view.height, 3), alpha(view.width, view.height, 1);
    for_each_pixel(view, progress, "colouring", [&](int x, int y) {
        Color3f sum(0.0f);
        int seen = 0;
        sample_pixel(tracer, view, x, y, samples, [&](const Hit& hit, float diameter) {
            sum += light.radiance(hit, diameter);
            ++seen;
        });
        put(beauty.at(x, y), sum / static_cast<float>(samples));
        *alpha.at(x, y) = static_cast<float>(seen) / static_cast<float>(samples);
    });
    frame.layers[Role::beauty] = std::move(beauty);
    frame.layers[Role::alpha] = std::move(alpha);
}

void add_light_parts(AovFrame& frame, const Tracer& tracer, const View& view, const SurfaceLight& light, int samples,
                     const Progress& progress) {
    Image albedo(view.width, view.height, 3), irradiance(view.width, view.height, 3);
    for_each_pixel(view, progress, "irradiance", [&](int x, int y) {
        Color3f reflectance(0.0f), e(0.0f);
        int seen = 0;
        sample_pixel(tracer, view, x, y, samples, [&](const Hit& hit, float diameter) {
            reflectance += light.albedo(hit, diameter);
            e += light.irradiance(hit, diameter) * kPi;
            ++seen;
        });
        if (seen == 0) return;
        put(albedo.at(x, y), reflectance / static_cast<float>(seen));
        put(irradiance.at(x, y), e / static_cast<float>(seen));
    });
    frame.layers[Role::diffuse_albedo] = std::move(albedo);
    frame.layers[Role::irradiance] = std::move(irradiance);
}

}  // namespace burnish
