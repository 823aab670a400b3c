#include <burnish/base/parallel.h>
#include <burnish/scene/gbuffer.h>

namespace burnish {
namespace {

void put(Image& image, size_t pixel, const Vec3f& v) {
    float* to = image.at(pixel);
    to[0] = v.x, to[1] = v.y, to[2] = v.z;
}

/// The layers of a G-buffer by name, so that the pixel loop looks nothing up.
struct Layers {
    Image &position, &normal, &geometric_normal, &depth, &tangent, &uv, &roughness, &object_id, &material_id;

    Layers(AovFrame& frame)
        : position(frame.layers[Role::position]),
          normal(frame.layers[Role::normal]),
          geometric_normal(frame.layers[Role::geometric_normal]),
          depth(frame.layers[Role::depth]),
          tangent(frame.layers[Role::tangent]),
          uv(frame.layers[Role::uv]),
          roughness(frame.layers[Role::roughness]),
          object_id(frame.layers[Role::object_id]),
          material_id(frame.layers[Role::material_id]) {
        const int width = frame.data_window.width, height = frame.data_window.height;
        for (Image* image : {&position, &normal, &geometric_normal, &tangent}) *image = Image(width, height, 3);
        for (Image* image : {&roughness, &object_id, &material_id}) *image = Image(width, height, 1);
        depth = Image(width, height, 1, kMissDepth);
        uv = Image(width, height, 2);
    }

    void store(size_t pixel, const Hit& hit, const Object& object) {
        put(position, pixel, hit.p);
        put(normal, pixel, hit.n);
        put(geometric_normal, pixel, hit.ng);
        put(tangent, pixel, hit.t);
        *depth.at(pixel) = hit.distance;
        uv.at(pixel)[0] = hit.uv.x, uv.at(pixel)[1] = hit.uv.y;
        *roughness.at(pixel) = object.roughness;
        *object_id.at(pixel) = static_cast<float>(object.object_index);
        *material_id.at(pixel) = static_cast<float>(object.material_index);
    }
};

}  // namespace

AovFrame trace_gbuffer(const Tracer& tracer, const View& view, const Progress& progress) {
    AovFrame frame;
    frame.data_window = frame.display_window = {0, 0, view.width, view.height};
    frame.camera = view.camera;
    Layers layers(frame);
    for_each_tile(view.width, view.height, progress, "tracing", [&](const Window& tile) {
        for (int y = tile.y; y < tile.y + tile.height; ++y)
            for (int x = tile.x; x < tile.x + tile.width; ++x) {
                if (const auto hit = view.closest(tracer, pixel_centre(x, y)))
                    layers.store(static_cast<size_t>(y) * view.width + x, *hit,
                                 tracer.scene().objects[static_cast<size_t>(hit->object)]);
            }
    });
    return frame;
}

AovFrame trace_gbuffer(const Tracer& tracer, const Camera& camera, int width, int height, const Progress& progress) {
    return trace_gbuffer(tracer, View{camera, width, height}, progress);
}

}  // namespace burnish
