// A light like a photographed one, made in code: texture of equal contrast in every octave, windows and lamps.
#pragma once

#include <burnish/base/image.h>
#include <burnish/base/types.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace burnish::scenes {

class RoomLight {
public:
    explicit RoomLight(uint32_t seed) : m_random(seed) {
        for (Wave& wave : m_waves) {
            const Imath::V3d along = direction();
            wave.frequency = along * ratio(0.7, 100), wave.phase = 2 * std::numbers::pi * m_uniform(m_random);
        }
        m_slope = direction();
        m_slope *= 1.5 * m_uniform(m_random);
        const int windows = static_cast<int>(7 * m_uniform(m_random));
        for (int i = 0; i < kShapes; ++i) m_shapes.push_back(shape(i < windows));
    }

    double radiance(const Imath::V3d& d) const {
        double exponent = m_slope.dot(d), gain = 1;
        for (const Wave& wave : m_waves) exponent += 0.2 * std::cos(wave.frequency.dot(d) + wave.phase);
        for (const Shape& shape : m_shapes)
            if (shape.holds(d)) gain = std::max(gain, shape.gain);
        return std::exp(exponent) * gain;
    }

private:
    /// In the logarithm of radiance: 48 of amplitude 0.2 have a deviation of about 1.
    struct Wave {
        Imath::V3d frequency;
        double phase;
    };

    /// A window, or a round lamp: sizes are tangents of half the angle.
    struct Shape {
        Imath::V3d centre, right, up;
        bool window;
        double half_width, half_height, gain;

        bool holds(const Imath::V3d& d) const {
            const double along = centre.dot(d), u = right.dot(d) / along, v = up.dot(d) / along;
            if (along <= 0) return false;
            return window ? std::abs(u) < half_width && std::abs(v) < half_height : u * u + v * v < half_width * half_width;
        }
    };

    static constexpr int kShapes = 12;

    double ratio(double low, double high) { return low * std::pow(high / low, m_uniform(m_random)); }

    Imath::V3d direction() {
        const double z = 2 * m_uniform(m_random) - 1, phi = 2 * std::numbers::pi * m_uniform(m_random);
        const double r = std::sqrt(1 - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }

    Shape shape(bool window) {
        Shape s;
        s.window = window, s.centre = direction();
        const double flat = std::max(std::hypot(s.centre.x, s.centre.y), 1e-6);
        s.right = Imath::V3d(-s.centre.y, s.centre.x, 0) / flat, s.up = s.centre.cross(s.right);
        s.half_width = window ? ratio(0.03, 0.5) : std::tan((1 + 2 * m_uniform(m_random)) * std::numbers::pi / 180);
        s.half_height = window ? ratio(0.03, 0.5) : 0;
        s.gain = window ? ratio(3, 200) : ratio(3, 2000);
        return s;
    }

    std::mt19937 m_random;
    std::uniform_real_distribution<double> m_uniform{0, 1};
    std::vector<Wave> m_waves{48};
    std::vector<Shape> m_shapes;
    Imath::V3d m_slope;
};

/// The whole sphere as a lat-long.
inline Image room_light(uint32_t seed, int height = 512) {
    const RoomLight room(seed);
    Image light(2 * height, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < 2 * height; ++x) {
            const double theta = std::numbers::pi * (y + 0.5) / height, phi = std::numbers::pi * (x + 0.5) / height;
            const Imath::V3d d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
            std::fill_n(light.at(x, y), 3, static_cast<float>(room.radiance(d)));
        }
    return light;
}

}  // namespace burnish::scenes
