// Pictures and directions the light tests share.
#pragma once

#include <burnish/light/filter/cube_pyramid.h>

#include <array>
#include <random>

namespace burnish_test {

using namespace burnish;

/// Unit directions, uniform over the sphere, the same in every run.
class Directions {
public:
    explicit Directions(unsigned seed = 1) : m_engine(seed) {}
    Vec3f next() {
        const float z = 2.0f * uniform() - 1.0f, phi = 2.0f * kPi * uniform(), r = std::sqrt(std::max(0.0f, 1.0f - z * z));
        return {r * std::cos(phi), r * std::sin(phi), z};
    }
    float uniform() { return static_cast<float>(m_engine() >> 8) * 0x1p-24f; }

private:
    std::mt19937 m_engine;
};

inline std::array<Image, 6> constant_faces(int size, const Color3f& value) {
    std::array<Image, 6> faces;
    for (Image& face : faces) {
        face = Image(size, size, 3);
        for (size_t i = 0; i < face.pixel_count(); ++i) std::copy_n(&value.x, 3, face.at(i));
    }
    return faces;
}

/// Faces whose texels hold function(direction) at their centres.
template <class Function>
std::array<Image, 6> painted_faces(int size, Function&& function) {
    std::array<Image, 6> faces;
    for (int face = 0; face < 6; ++face) {
        faces[face] = Image(size, size, 3);
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const Color3f c = function(cube_direction(face, (x + 0.5f) / size, (y + 0.5f) / size));
                std::copy_n(&c.x, 3, faces[face].at(x, y));
            }
        }
    }
    return faces;
}

inline double texel_solid_angle(int x, int y, int size) {
    const auto edge = [&](int i) { return 2.0 * i / size - 1.0; };
    return cube_solid_angle(edge(x), edge(x + 1), edge(y), edge(y + 1));
}

/// Sum of green radiance x solid angle over one level.
inline double level_energy(const CubeStack& stack, int level) {
    const CubeLevel& texels = stack[level];
    const int n = texels.size();
    double sum = 0;
    for (int face = 0; face < 6; ++face) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) sum += texel_solid_angle(x, y, n) * texels.at(face, x, y)[1];
        }
    }
    return sum;
}

}  // namespace burnish_test
