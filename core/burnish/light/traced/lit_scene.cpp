#include <burnish/light/traced/lit_scene.h>

#include <burnish/base/error.h>
#include <burnish/light/picture_reader.h>
#include <burnish/scene/load_scene.h>

#include <Imath/ImathBox.h>

#include <algorithm>

namespace burnish {
namespace {

using Conversion = std::function<void(Image&)>;

void clean(Image& picture) {
    for (float& value : picture.data)
        if (!(value >= 0 && std::isfinite(value))) value = 0;
}

void convert_color(Color3f& color, const Conversion& convert) {
    Image pixel(1, 1, 3);
    std::copy_n(&color.x, 3, pixel.at(0));
    convert(pixel), clean(pixel);
    color = Color3f(pixel.at(0)[0], pixel.at(0)[1], pixel.at(0)[2]);
}

Scene read_scene(const TracedSettings& settings, const Conversion& convert) {
    Scene scene = load_scene(settings.scene, {settings.up, settings.texcoord});
    for (Object& object : scene.objects)
        if (convert) convert_color(object.albedo, convert), convert_color(object.emission, convert);
    return scene;
}

Image read_map(const std::string& file, const Conversion& convert) {
    if (file.empty()) return {};
    Image map = read_picture(file).pixels;
    clean(map);
    if (convert) convert(map), clean(map);
    return map;
}

Imath::Box3f box_of(const Scene& scene) {
    Imath::Box3f box;
    for (const Object& object : scene.objects)
        for (const Vertex& vertex : object.mesh.vertices) box.extendBy(vertex.p);
    return box;
}

}  // namespace

LitScene::LitScene(Scene scene, LightMaps maps)
    : m_scene(std::move(scene)),
      m_tracer(m_scene),
      m_light(m_scene, std::move(maps)),
      m_lamps(m_light),
      m_box(box_of(m_scene)) {}

LitScene::LitScene(const TracedSettings& settings, const std::function<void(Image&)>& convert)
    : LitScene(read_scene(settings, convert), LightMaps{.radiance = read_map(settings.radiance, convert),
                                                        .irradiance = read_map(settings.irradiance, convert),
                                                        .albedo = read_map(settings.albedo, convert)}) {
    const auto shines = [](const Object& object) { return object.emission != Color3f(0, 0, 0); };
    if (settings.radiance.empty() && settings.irradiance.empty() && std::ranges::none_of(m_scene.objects, shines))
        throw Error(ErrorCode::bad_argument, settings.scene +
                                                 ": the scene has no light: give its light map as radiance or irradiance, "
                                                 "or export materials that emit");
}

}  // namespace burnish
