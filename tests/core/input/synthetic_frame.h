// The layers of a synthetic view (synthetic_view.h) as a renderer would write them.
#pragma once

#include <core/input/synthetic_exr.h>
#include <core/input/synthetic_view.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace burnish {

/// A ball in a room, seen by a known camera: 96 x 54 pixels.
struct SyntheticFrame {
    Window window{0, 0, 96, 54};
    Camera camera = camera_looking({3.5f, -4.0f, 3.0f}, {0.3f, 0.5f, 1.2f}, 0.6f, 96.0f / 54.0f);
    Image position = position_layer(camera, window, window, SyntheticScene::room_with_ball);
    Image normal = make_normal();
    Image depth = make_depth(false), distance = make_depth(true);
    Image beauty = Image(96, 54, 4, 0.25f);

    /// Each pixel's three values turned by `change`.
    static Image mapped(Image image, const std::function<Vec3f(const Vec3f&)>& change) {
        for (size_t i = 0; i < image.pixel_count(); ++i) {
            float* v = image.at(i);
            const Vec3f result = change({v[0], v[1], v[2]});
            std::copy_n(&result.x, 3, v);
        }
        return image;
    }

    Image constant(float value, int channels = 3) const { return Image(window.width, window.height, channels, value); }

    /// World-space directions as seen in the camera's frame (x right, y up, z towards the viewer).
    Image in_camera_space(const Image& vectors) const {
        const Vec3f x = camera.right.normalized(), y = camera.up.normalized(), z = -camera.forward();
        return mapped(vectors, [=](const Vec3f& n) { return Vec3f(n.dot(x), n.dot(y), n.dot(z)); });
    }

private:
    Image make_normal() const {
        return mapped(position, [](const Vec3f& p) {
            const Vec3f from_ball = p - Vec3f(0.3f, 0.5f, 1.2f);
            if (from_ball.length() < 1.001f) return from_ball.normalized();
            const Vec3f inward[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
            const float gaps[] = {p.x + 5, 5 - p.x, p.y + 5, 5 - p.y, p.z, 6 - p.z};
            return inward[std::min_element(gaps, gaps + 6) - gaps];
        });
    }

    Image make_depth(bool along_ray) const {
        Image layer(window.width, window.height, 1);
        for (size_t i = 0; i < layer.pixel_count(); ++i) {
            const Vec3f ray = Vec3f(position.at(i)[0], position.at(i)[1], position.at(i)[2]) - camera.centre;
            layer.data[i] = along_ray ? ray.length() : ray.dot(camera.forward());
        }
        return layer;
    }
};

/// The one frame that tests read from; made once.
inline const SyntheticFrame& scene() {
    static const SyntheticFrame frame;
    return frame;
}

inline constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

inline std::vector<std::string> rgb(const std::string& layer) { return {layer + ".R", layer + ".G", layer + ".B"}; }
inline std::vector<std::string> xyz(const std::string& layer) { return {layer + ".X", layer + ".Y", layer + ".Z"}; }

}  // namespace burnish
