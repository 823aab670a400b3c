#include <burnish/light/cube_map/cube_map_light.h>

#include <burnish/base/error.h>
#include <burnish/light/environment_picture.h>
#include <burnish/light/filter/gaussian_stack.h>
#include <burnish/light/filter/stack_lookup.h>
#include <burnish/light/light_mean.h>
#include <burnish/scene/load_scene.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kShareBend = 0.42f;  // largest second derivative of a cone's share with its distance from an edge, in sigmas
constexpr float kSamePlace = 3e-4f;  // of the distance from the centre

void find_ends(const Proxy& proxy, std::span<const LightRay> rays, std::vector<RayEnd>& out) {
    std::visit([&](const auto& one) { one.ends(rays, out); }, proxy);
}

/// Suns are shaded as distant light, which a room's lamps are not.
EnvironmentSettings of_a_room(EnvironmentSettings settings) {
    settings.suns = Suns::keep;
    return settings;
}

std::optional<Environment> read_cover(const CubeMapSettings& settings) {
    if (!environment_has_layer(settings.file, PictureLayer::alpha)) return std::nullopt;
    EnvironmentPicture alpha = read_environment_picture(settings.file, PictureLayer::alpha);
    const auto covers = [](const Image& image) { return std::ranges::all_of(image.data, [](float a) { return a >= 1; }); };
    if (alpha.faces ? std::ranges::all_of(*alpha.faces, covers) : covers(alpha.latlong)) return std::nullopt;
    return Environment::from_picture(std::move(alpha), of_a_room(settings.picture), settings.file);
}

std::shared_ptr<const Scene> load_room(const CubeMapSettings& settings) {
    if (settings.proxy.mesh.empty())
        throw Error(ErrorCode::bad_argument,
                    settings.file + ": the mesh proxy has no mesh. Name a glTF or OBJ file of the room.");
    return std::make_shared<const Scene>(load_scene(settings.proxy.mesh, {.up = settings.picture.up}));
}

Proxy make_proxy(const CubeMapSettings& settings, std::shared_ptr<const Scene> room) {
    switch (settings.proxy.kind) {
        case ProxyKind::planes: return BoundingPlanes(settings.proxy.planes, settings.centre);
        case ProxyKind::box: return BoundingPlanes(settings.proxy.box, settings.centre);
        case ProxyKind::depth:
            return DepthImpostor(std::make_shared<const DistanceMap>(DistanceMap::load(settings)), settings.centre);
        case ProxyKind::mesh: return ProxyMesh(room ? std::move(room) : load_room(settings), settings.centre);
        case ProxyKind::infinite: break;
    }
    return InfiniteProxy();
}

/// Filtered values of a map for cones seen from the centre, in world space.
void look_up_cones(const Environment& map, std::span<const SeenCone> cones, std::vector<std::array<float, 4>>& rgba) {
    const GaussianStack& stack = map.gaussian_stack();
    std::vector<StackPlace> places;
    for (const SeenCone& cone : cones) {
        const float level = stack.quick_level(cone.sigma);
        places.push_back({(cone.middle + cone.apart) * map.world_to_light(), level});
        if (!cone.is_one()) places.push_back({(cone.middle - cone.apart) * map.world_to_light(), level});
    }
    std::vector<std::array<float, 4>> found(places.size());
    look_up(stack.stack(), places, {1, 1, 1, 1}, found);
    rgba.resize(cones.size());
    for (size_t i = 0, k = 0; i < cones.size(); ++i) {
        rgba[i] = found[k++];
        if (cones[i].is_one()) continue;
        for (int channel = 0; channel < 3; ++channel) rgba[i][channel] = 0.5f * (rgba[i][channel] + found[k][channel]);
        rgba[i][3] = std::max(rgba[i][3], found[k++][3]);
    }
}

}  // namespace

CubeMapLight::CubeMapLight(const CubeMapSettings& settings, const std::function<void(Image&)>& convert,
                           std::shared_ptr<const Scene> room)
    : CubeMapLight(Environment::load(settings.file, of_a_room(settings.picture), convert), read_cover(settings),
                   settings.centre, make_proxy(settings, std::move(room))) {}

CubeMapLight::CubeMapLight(Environment picture, std::optional<Environment> cover, const Vec3f& centre, Proxy proxy)
    : m_picture(std::move(picture)), m_cover(std::move(cover)), m_centre(centre), m_proxy(std::move(proxy)) {
    if (!is_finite(centre))
        throw Error(ErrorCode::bad_argument, "the centre of a cube map must be finite numbers: where it was taken.");
}

void CubeMapLight::lookup(std::span<const LightRay> rays, std::span<Incident> out) const {
    std::vector<RayEnd> ends;
    find_ends(m_proxy, rays, ends);
    std::vector<SeenCone> cones;
    for (const RayEnd& end : ends) cones.emplace_back(rays[end.ray], end);
    std::vector<std::array<float, 4>> light, cover;
    look_up_cones(m_picture, cones, light);
    if (m_cover) look_up_cones(*m_cover, cones, cover);
    const Color3f& gain = m_picture.gain();
    const float bend_gain = luminance(gain);
    std::fill(out.begin(), out.end(), Incident());
    for (size_t k = 0; k < ends.size(); ++k) {
        const RayEnd& end = ends[k];
        Incident& sum = out[end.ray];
        sum.radiance += gain * Color3f(light[k][0], light[k][1], light[k][2]) * end.share;
        sum.cover += (m_cover ? cover[k][0] : 1.0f) * end.share;
        sum.bend += bend_gain * light[k][3] * cones[k].bend * end.share;
        sum.nearness += end.share / std::max(end.distance, 1e-6f);
    }
    for (size_t k = 0; k < ends.size(); ++k) {
        if (ends[k].share == 1) continue;
        const Color3f own = gain * Color3f(light[k][0], light[k][1], light[k][2]);
        Incident& sum = out[ends[k].ray];
        const float sigma = rays[ends[k].ray].sigma;
        sum.bend += kShareBend / (sigma * sigma) * std::fabs(luminance(own - sum.radiance));
    }
}

float CubeMapLight::mean_luminance() const {
    return luminance(m_picture.gain()) * display_mean_luminance(m_picture.gaussian_stack().stack());
}

RayEnd CubeMapLight::end_of(const LightRay& ray) const {
    std::vector<RayEnd> ends;
    find_ends(m_proxy, {&ray, 1}, ends);
    return ends[0];
}

ExactLight CubeMapLight::exact(const LightRay& ray) const {
    LightRay thin = ray;
    thin.sigma = 0;
    const RayEnd end = end_of(thin);
    const Vec3f d = end.from_centre.normalized() * m_picture.world_to_light();
    const float cover = m_cover ? m_cover->radiance(end.from_centre.normalized() * m_cover->world_to_light()).x : 1.0f;
    return {m_picture.radiance(d) * m_picture.gain(), cover, pdf(thin, end)};
}

// The map's density, by the solid angle that the same piece of the proxy takes up from p. Where the centre does not see what the
// ray meets, nothing is drawn.
float CubeMapLight::pdf(const LightRay& ray, const RayEnd& end) const {
    const Vec3f seen = end.from_centre.normalized();
    const float density = m_picture.pdf(seen * m_picture.world_to_light());
    if (!end.is_somewhere() && std::holds_alternative<InfiniteProxy>(m_proxy)) return density;
    const RayEnd own = end_of({m_centre, seen, seen, 0});
    if (!end.is_somewhere()) return own.is_somewhere() ? 0.0f : density;
    const float far = end.from_centre.length(), cos_seen = std::fabs(end.n.dot(seen)), cos_ray = std::fabs(end.n.dot(ray.d));
    if (!(std::fabs(own.distance - far) < kSamePlace * far) || cos_seen < 1e-6f) return 0;
    const float ratio = end.distance / far;
    return density * ratio * ratio * cos_seen / std::max(cos_ray, 1e-6f);
}

LightDraw CubeMapLight::sample(const Vec3f& p, const Vec2f& u) const {
    LightDraw draw;
    const Vec3f seen = m_picture.sample(u, draw.pdf) * m_picture.world_to_light().transposed();
    draw.d = seen;
    const RayEnd own = end_of({m_centre, seen, seen, 0});
    if (own.is_somewhere()) draw.d = (m_centre + own.from_centre - p).normalized();
    const LightRay ray{p, draw.d, draw.d, 0};
    const RayEnd end = end_of(ray);
    const bool same = end.is_somewhere() == own.is_somewhere() && (end.from_centre.normalized() - seen).length() < kSamePlace;
    draw.pdf = same ? pdf(ray, end) : 0.0f;
    return draw;
}

}  // namespace burnish
