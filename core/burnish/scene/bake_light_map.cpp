#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/sampling/sequence.h>
#include <burnish/scene/atlas.h>
#include <burnish/scene/atlas_texels.h>
#include <burnish/scene/bake_light_map.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kBlock = 4;  // texels that share a set of bounces

/// Every triangle that emits, to be drawn by area and brightness.
class Emitters {
public:
    explicit Emitters(const Scene& scene) {
        for (const Object& object : scene.objects) {
            const float brightness = luminance(object.emission);
            if (!(brightness > 0)) continue;
            for (const auto& [a, b, c] : object.mesh.triangles)
                add(object.mesh.vertices[a].p, object.mesh.vertices[b].p, object.mesh.vertices[c].p, object.emission);
        }
        if (!(m_total > 0))
            throw Error(ErrorCode::bad_argument,
                        "no light to bake: nothing in the scene emits. Give a lamp an emissive material, or name a light map");
    }

    struct Sample {
        Vec3f p, n;
        Color3f weight;  // radiance / pdf by area
    };
    Sample sample(const Vec2f& u) const {
        const auto found = std::ranges::upper_bound(m_lamps, static_cast<double>(u.x) * m_total, {}, &Lamp::end);
        const Lamp& lamp = found == m_lamps.end() ? m_lamps.back() : *found;
        const double x = 1 - (lamp.end - static_cast<double>(u.x) * m_total) / lamp.power;
        const auto r = static_cast<float>(std::sqrt(std::clamp(x, 0.0, 1.0)));
        return {lamp.p + lamp.x * (r * (1 - u.y)) + lamp.y * (r * u.y), lamp.n,
                lamp.emission * static_cast<float>(m_total / luminance(lamp.emission))};
    }

private:
    struct Lamp {
        Vec3f p, x, y, n;
        Color3f emission;
        double power, end;  // area * luminance; the running sum
    };
    void add(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Color3f& emission) {
        const Vec3f n = (b - a).cross(c - a);
        const double power = 0.5 * n.length() * luminance(emission);
        if (!(power > 0)) return;
        m_total += power;
        m_lamps.push_back({a, b - a, c - a, n.normalized(), emission, power, m_total});
    }

    std::vector<Lamp> m_lamps;
    double m_total = 0;
};

Vec3f above(const AtlasTexel& texel) { return leaving_point(Hit{.p = texel.p, .n = texel.n, .ng = texel.ng}); }

Color3f color_at(const Image& image, size_t pixel) {
    const float* c = image.at(pixel);
    return {c[0], c[1], c[2]};
}
void put(Image& image, size_t pixel, const Color3f& c) { std::copy_n(&c.x, 3, image.at(pixel)); }

Color3f from_lamps(const Tracer& tracer, const Emitters& lamps, const AtlasTexel& texel, uint32_t seed,
                   const LightMapSettings& s) {
    const Vec3f origin = above(texel);
    Color3f sum(0.0f);
    for (uint32_t i = 0; i < static_cast<uint32_t>(s.lamp_samples); ++i) {
        const Emitters::Sample lamp = lamps.sample(owen_sobol(i, seed));
        const Vec3f way = lamp.p - origin;
        const float length2 = way.length2(), cosines = way.dot(texel.n) * -way.dot(lamp.n);
        if (way.dot(texel.n) <= 0 || cosines <= 0 || tracer.occluded(origin, way, 0.999f, s.hidden)) continue;
        sum += lamp.weight * (cosines / (length2 * length2));
    }
    return sum / (kPi * static_cast<float>(s.lamp_samples));
}

/// Mean radiance that run `run` of the set of bounces meets.
Color3f from_surfaces(const Tracer& tracer, const SurfaceLight& light, const AtlasTexel& texel, int run,
                      const LightMapSettings& s) {
    const Vec3f origin = above(texel);
    const Frame frame = Frame::around(texel.n);
    Color3f sum(0.0f);
    for (int i = run * s.bounce_samples; i < (run + 1) * s.bounce_samples; ++i) {
        const Vec2f u = owen_sobol(static_cast<uint32_t>(i), 1);
        const float r = std::sqrt(u.x), phi = 2 * kPi * u.y;
        const Vec3f wi = frame.to_world({r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u.x)});
        if (wi.dot(texel.ng) <= 0) continue;
        if (const auto hit = tracer.closest(origin, wi, 0, kInfinitelyFar, s.hidden))
            sum += light.albedo(*hit) * light.irradiance(*hit);
    }
    return sum / static_cast<float>(s.bounce_samples);
}

/// The mean of the block around a texel, as far as it is the same smooth surface: of all runs once.
Color3f block_mean(const Image& map, const std::vector<AtlasTexel>& texels, int x, int y) {
    const AtlasTexel& here = texels[static_cast<size_t>(y) * map.width + x];
    Color3f sum(0.0f);
    int count = 0;
    for (int j = std::max(y - 1, 0); j < std::min(y - 1 + kBlock, map.height); ++j)
        for (int i = std::max(x - 1, 0); i < std::min(x - 1 + kBlock, map.width); ++i) {
            const size_t pixel = static_cast<size_t>(j) * map.width + i;
            const AtlasTexel& there = texels[pixel];
            const Vec3f way = there.p - here.p;
            if (there.object != here.object || there.n.dot(here.n) < 0.9f || std::abs(way.dot(here.n)) > 0.3f * way.length())
                continue;
            sum += color_at(map, pixel);
            ++count;
        }
    return sum / static_cast<float>(count);
}

/// Calls `value(texel, x, y)` for all texels that have a point, and fills the gaps between charts.
template <class Value>
Image painted(const std::vector<AtlasTexel>& texels, int size, const Progress& progress, const std::string& stage,
              const Value& value) {
    Image map(size, size, 3);
    for_each_tile(size, size, progress, stage, [&](const Window& tile) {
        for (int y = tile.y; y < tile.y + tile.height; ++y)
            for (int x = tile.x; x < tile.x + tile.width; ++x) {
                const size_t pixel = static_cast<size_t>(y) * size + x;
                if (texels[pixel].object >= 0) put(map, pixel, value(texels[pixel], x, y));
            }
    });
    fill_gaps(map, texels, kAtlasMargin);
    return map;
}

}  // namespace

Image bake_light_map(const Tracer& tracer, const LightMapSettings& settings, const Progress& progress) {
    const Emitters lamps(tracer.scene());
    const std::vector<AtlasTexel> texels = atlas_texels(tracer.scene(), settings.size);
    const Image direct = painted(texels, settings.size, progress, "lamps", [&](const AtlasTexel& texel, int x, int y) {
        return from_lamps(tracer, lamps, texel, hash_bits(static_cast<uint32_t>(x), static_cast<uint32_t>(y)), settings);
    });
    Image map = direct;
    for (int bounce = 1; bounce <= settings.bounces; ++bounce) {
        const SurfaceLight light(tracer.scene(), {.irradiance = std::move(map)});
        const Image gathered = painted(
            texels, settings.size, progress, "bounce " + std::to_string(bounce), [&](const AtlasTexel& texel, int x, int y) {
                return from_surfaces(tracer, light, texel, x % kBlock + kBlock * (y % kBlock), settings);
            });
        map = painted(texels, settings.size, {}, "", [&](const AtlasTexel&, int x, int y) {
            const size_t pixel = static_cast<size_t>(y) * settings.size + x;
            return color_at(direct, pixel) + block_mean(gathered, texels, x, y);
        });
    }
    return map;
}

}  // namespace burnish
