#include <burnish/frequency/light_luminance.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>

#include <bit>
#include <string>

namespace burnish {
namespace {

constexpr int kDiscPoints = 1024;  // a disc of two degrees covers some fifty texels

void check(const std::array<Image, 6>& faces) {
    const int size = faces[0].width;
    for (const Image& face : faces) {
        if (size > 0 && std::has_single_bit(static_cast<unsigned>(size)) && face.width == size && face.height == size &&
            face.channels >= 3)
            continue;
        throw Error(ErrorCode::bad_argument,
                    "light bandwidth: expected six square RGB faces of one size, a power of two, found one of " +
                        std::to_string(face.width) + " x " + std::to_string(face.height) + " x " +
                        std::to_string(face.channels) + ". Resample the faces first.");
    }
}

/// Mean luminance of `step` x `step` texels.
float mean_luminance(const Image& face, int x, int y, int step) {
    Color3f sum(0, 0, 0);
    for (int row = y * step; row < (y + 1) * step; ++row) {
        for (int column = x * step; column < (x + 1) * step; ++column) {
            const float* rgb = face.at(column, row);
            sum += Color3f(rgb[0], rgb[1], rgb[2]);
        }
    }
    return luminance(sum) / static_cast<float>(step * step);
}

float texel_solid_angle(const CubeTexel& t, int size) {
    const auto edge = [&](int i) { return 2.0 * i / size - 1.0; };
    return static_cast<float>(cube_solid_angle(edge(t.x), edge(t.x + 1), edge(t.y), edge(t.y + 1)));
}

/// Points spread evenly over the ellipse, each with its part of the flux.
void paint(const BrightDisc& disc, CubeLevel& level) {
    const int size = level.size(), last = size - 1;
    const float flux = luminance(disc.flux) / kDiscPoints;
    for (int i = 0; i < kDiscPoints; ++i) {
        const float radius = std::sqrt((static_cast<float>(i) + 0.5f) / kDiscPoints), turn = 2.399963f * static_cast<float>(i);
        const Vec3f d = disc.direction + disc.along * (radius * std::cos(turn)) + disc.across * (radius * std::sin(turn));
        const CubeCoord c = cube_coord(d);
        const auto texel = [&](float place) { return std::min(last, static_cast<int>(place * static_cast<float>(size))); };
        const CubeTexel t{c.face, texel(c.x), texel(c.y)};
        *level.at(t.face, t.x, t.y) += flux / texel_solid_angle(t, size);
    }
}

}  // namespace

CubeLevel light_luminance(const std::array<Image, 6>& faces, std::span<const BrightDisc> discs, int largest) {
    check(faces);
    const int size = std::min(faces[0].width, largest), step = faces[0].width / size;
    CubeLevel level(size);
    for_each_index(6 * size, [&](int row) {
        const int face = row / size, y = row % size;
        for (int x = 0; x < size; ++x) *level.at(face, x, y) = mean_luminance(faces[face], x, y, step);
    });
    for (const BrightDisc& disc : discs) paint(disc, level);
    level.fill_borders();
    return level;
}

Image surrounded_face(const CubeLevel& level, int face, int border) {
    const int size = level.size(), width = size + 2 * border;
    Image out(width, width, 1);
    for (int y = -border; y < size + border; ++y) {
        for (int x = -border; x < size + border; ++x) {
            float* value = out.at(x + border, y + border);
            if (x >= 0 && y >= 0 && x < size && y < size) {
                *value = *level.at(face, x, y);
                continue;
            }
            float rgba[4] = {0, 0, 0, 0};
            level.add_bilinear(cube_coord(face_to_cube(face, face_place(x, y, size))), 1.0f, rgba);
            *value = rgba[0];
        }
    }
    return out;
}

}  // namespace burnish
