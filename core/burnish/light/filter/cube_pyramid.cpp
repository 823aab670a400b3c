#include <burnish/light/filter/cube_pyramid.h>

#include <burnish/base/error.h>
#include <burnish/light/filter/cube_filter.h>

#include <bit>
#include <string>

namespace burnish {
namespace {

void check_faces(const std::array<Image, 6>& faces) {
    const int size = faces[0].width;
    for (const Image& face : faces) {
        if (face.width == size && face.height == size && face.channels >= 3 && std::has_single_bit(static_cast<unsigned>(size)))
            continue;
        throw Error(ErrorCode::bad_argument, "cube map: expected six square RGB faces of one power-of-two size, found one of " +
                                                 std::to_string(face.width) + " x " + std::to_string(face.height) + " x " +
                                                 std::to_string(face.channels) + ". Resample the faces first.");
    }
}

}  // namespace

CubePyramid::CubePyramid(const std::array<Image, 6>& faces, PyramidKernel kernel) {
    check_faces(faces);
    std::vector<int> sizes;
    for (int size = faces[0].width; size > 0; size /= 2) sizes.push_back(size);
    m_stack = CubeStack(sizes);
    m_stack[0].fill(faces);
    CubeFilter filter(sizes[0], kernel);
    for (int level = 1; level < level_count(); ++level) filter.coarser(m_stack[level - 1], m_stack[level]);
    m_texels_per_area = 0.25f * static_cast<float>(face_size()) * static_cast<float>(face_size());
}

Color3f CubePyramid::texel(int level, int face, int x, int y) const {
    const float* rgba = m_stack[level].at(face, x, y);
    return {rgba[0], rgba[1], rgba[2]};
}

}  // namespace burnish
