// Where a mirrored render sees one surface beside another at a different depth.
#pragma once

#include <burnish/light/mirror/mirror_buffer.h>

#include <algorithm>

namespace burnish_test {

using namespace burnish;

/// 1 on pixels within `reach` of neighbours that lie more than a tenth of a unit off each other's planes, else 0.
inline Image near_depth_edges(const MirrorBuffer& buffer, int reach) {
    const int width = buffer.data.width, height = buffer.data.height;
    const auto at = [](const Image& image, int x, int y) {
        return Vec3f(image.at(x, y)[0], image.at(x, y)[1], image.at(x, y)[2]);
    };
    const auto leaves = [&](int x, int y, int other_x, int other_y) {
        const Vec3f way = at(buffer.position, other_x, other_y) - at(buffer.position, x, y);
        return std::fabs(way.dot(at(buffer.normal, x, y))) > 0.1f;
    };
    Image near(width, height, 1);
    for (int y = 0; y + 1 < height; ++y)
        for (int x = 0; x + 1 < width; ++x) {
            const bool beside = leaves(x, y, x + 1, y) && leaves(x + 1, y, x, y);
            const bool below = leaves(x, y, x, y + 1) && leaves(x, y + 1, x, y);
            for (int j = -reach; (beside || below) && j <= reach; ++j)
                for (int i = -reach; i <= reach; ++i)
                    *near.at(std::clamp(x + i, 0, width - 1), std::clamp(y + j, 0, height - 1)) = 1;
        }
    return near;
}

}  // namespace burnish_test
