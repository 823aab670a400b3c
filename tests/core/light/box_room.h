// A room of boxes seen in its mirror floor, by ray casting: what mirror buffers are checked against.
#pragma once

#include <burnish/light/mirror/mirror_buffer.h>
#include <burnish/light/mirror/plane.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace burnish_test {

using namespace burnish;

/// A room 6 x 8 x 3 with z = 0 as its floor, which rays pass, and boxes standing in it. All surfaces shine with a picture of their own.
class BoxRoom {
public:
    struct Box {
        Vec3f low, high;
    };
    struct Seen {
        float distance;
        Vec3f place, normal;
        Color3f radiance;
    };

    /// `contrast` of the pictures, 0 to 1: 0 is one colour a face.
    explicit BoxRoom(std::vector<Box> boxes, float contrast = 1) : m_boxes(std::move(boxes)), m_contrast(contrast) {}

    Seen look(const Vec3f& p, const Vec3f& d) const {
        Face nearest = face(kWalls, p, d, true, 0);
        for (size_t i = 0; i < m_boxes.size(); ++i) {
            const Face hit = face(m_boxes[i], p, d, false, static_cast<int>(i) + 1);
            if (hit.distance < nearest.distance) nearest = hit;
        }
        Seen seen{nearest.distance, p + d * nearest.distance, Vec3f(0, 0, 0), Color3f(0, 0, 0)};
        seen.normal[nearest.axis] = d[nearest.axis] > 0 ? -1.0f : 1.0f;
        seen.radiance = picture(nearest, seen.place);
        return seen;
    }

    /// What the camera sees of it.
    AovFrame render(const Camera& camera, int width, int height) const {
        AovFrame frame;
        frame.data_window = frame.display_window = {0, 0, width, height};
        frame.camera = camera;
        for (const Role role : {Role::beauty, Role::position, Role::normal}) frame.layers[role] = Image(width, height, 3);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Vec3f ray = camera.ray(screen_point(x, y, frame.display_window)).normalized();
                const Seen seen = look(camera.centre, ray);
                std::copy_n(&seen.radiance.x, 3, frame.layers[Role::beauty].at(x, y));
                std::copy_n(&seen.place.x, 3, frame.layers[Role::position].at(x, y));
                std::copy_n(&seen.normal.x, 3, frame.layers[Role::normal].at(x, y));
            }
        return frame;
    }

private:
    struct Face {
        float distance;
        int box, axis, side;
    };
    static constexpr Box kWalls{{-3, -4, -100}, {3, 4, 3}};

    static Face face(const Box& box, const Vec3f& p, const Vec3f& d, bool inside, int number) {
        float enter = -std::numeric_limits<float>::infinity(), leave = -enter;
        int enter_axis = 0, leave_axis = 0;
        for (int k = 0; k < 3; ++k) {
            const float a = (box.low[k] - p[k]) / d[k], b = (box.high[k] - p[k]) / d[k];
            if (std::min(a, b) > enter) enter = std::min(a, b), enter_axis = k;
            if (std::max(a, b) < leave) leave = std::max(a, b), leave_axis = k;
        }
        if (inside) return {leave, number, leave_axis, d[leave_axis] > 0};
        if (!(enter > 0 && enter < leave)) return {std::numeric_limits<float>::infinity(), number, 0, 0};
        return {enter, number, enter_axis, d[enter_axis] > 0};
    }

    Color3f picture(const Face& face, const Vec3f& place) const {
        const float u = place[(face.axis + 1) % 3], v = place[(face.axis + 2) % 3];
        const float tone = static_cast<float>((face.box * 7 + face.axis * 3 + face.side * 2) % 5 + 1) / 5;
        const float waves = 1 + 0.5f * m_contrast * (std::sin(5 * u + 1) * std::cos(4 * v) + 0.5f * std::sin(11 * v + 3 * u));
        return Color3f(tone, 1.2f - tone, 0.3f + 0.5f * tone) * waves;
    }

    std::vector<Box> m_boxes;
    float m_contrast;
};

/// Stands near the front wall and looks at the floor in the middle.
inline Camera room_camera() {
    Camera camera;
    camera.centre = Vec3f(0.2f, -3.7f, 1.55f);
    camera.axis = Vec3f(-0.01f, 0.985f, -0.17f).normalized();
    camera.right = camera.axis.cross(Vec3f(0, 0, 1)).normalized() * 0.82f;
    camera.up = camera.right.cross(camera.axis) * (9.0f / 16);
    camera.has_rays = true;
    return camera;
}

inline BoxRoom furnished_room(float contrast = 1) {
    return BoxRoom(
        {{{-2.2f, 1.2f, 0}, {-1.2f, 2.2f, 1.5f}}, {{1.5f, 2.2f, 0}, {2.4f, 3.1f, 0.9f}}, {{0.4f, 0.4f, 0}, {0.9f, 0.9f, 1.1f}}},
        contrast);
}

inline MirrorSettings floor_mirror() {
    MirrorSettings settings;
    settings.plane = {Vec3f(1, 2, 0), Vec3f(0, 0, 2)};
    return settings;
}

inline MirrorBuffer floor_buffer(const BoxRoom& room, int width = 640, int height = 360) {
    return MirrorBuffer::from_frame(room.render(mirrored(room_camera(), floor_mirror().plane), width, height));
}

}  // namespace burnish_test
