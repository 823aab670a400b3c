#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/input/depth.h>
#include <burnish/input/median.h>
#include <burnish/input/sightings.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace burnish {
namespace {

constexpr size_t kSightings = 2000;
constexpr double kWorstMisfit = 0.02;  // relative: half-float depth and position agree far better than this

}  // namespace

Image position_from_depth(const Image& depth, const Camera& camera, const RowStrips& rows, const Window& display,
                          bool ray_distance) {
    if (!camera.has_rays)
        throw Error(ErrorCode::bad_argument,
                    "position from depth needs the camera's field of view, but only its centre is known; add fov_x_deg");
    Image position(depth.width, depth.height, 3, std::numeric_limits<float>::quiet_NaN());
    for_each_index(depth.height, [&](int y) {
        for (int x = 0; x < depth.width; ++x) {
            const float z = *depth.at(x, y);
            if (!(z > 0 && z < kFarthest)) continue;
            const Vec3f ray = camera.ray(screen_point(rows.data.x + x, rows.data.y + rows.row(y), display));
            const Vec3f p = camera.centre + ray * (ray_distance ? z / ray.length() : z);
            std::copy_n(p.getValue(), 3, position.at(x, y));
        }
    });
    return position;
}

DepthKind depth_kind(const Image& depth, const Image& position, const Camera& camera, const RowStrips& rows,
                     const Window& display) {
    const Imath::V3d centre(camera.centre), forward(camera.forward());
    std::vector<double> planar, distance;  // relative misfit of each reading
    for (const Sighting& s : sample_sightings(position, nullptr, rows, display, kSightings)) {
        const double z = *depth.at(s.pixel), length = (s.point - centre).length();
        if (!(z > 0 && z < kFarthest)) continue;
        planar.push_back(std::fabs(z / forward.dot(s.point - centre) - 1));
        distance.push_back(std::fabs(z / length - 1));
    }
    const double planar_misfit = median(planar), distance_misfit = median(distance);
    if (!(std::min(planar_misfit, distance_misfit) < kWorstMisfit)) return DepthKind::neither;
    return planar_misfit <= distance_misfit ? DepthKind::planar : DepthKind::ray_distance;
}

}  // namespace burnish
