#include <burnish/light/area/convex_polygon.h>

#include <burnish/base/error.h>

#include <algorithm>
#include <string>

namespace burnish {
namespace {

constexpr float kFlat = 1e-3f;  // of the size: how far corners may lie off the plane, or off where they should be

[[noreturn]] void refuse(const std::string& problem) {
    throw Error(ErrorCode::bad_argument, "area light, corners: " + problem);
}

/// Twice the area, along the normal (Newell's sum over the edges, robust for any corners).
Vec3f doubled_area(const std::vector<Vec3f>& corners) {
    Vec3f sum(0, 0, 0);
    for (size_t i = 1; i + 1 < corners.size(); ++i) sum += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
    return sum;
}

void check(const ConvexPolygon& polygon) {
    const std::vector<Vec3f>& corners = polygon.corners;
    const size_t count = corners.size();
    float turned = 0;
    for (size_t i = 0; i < count; ++i) {
        const std::string which = "corner " + std::to_string(i + 1) + " of " + std::to_string(count);
        if (std::fabs(polygon.height(corners[i])) > kFlat * polygon.size)
            refuse(which + " does not lie in one plane with the others. Use several lights of three corners each.");
        const Vec3f in = corners[i] - corners[(i + count - 1) % count], out = corners[(i + 1) % count] - corners[i];
        const float turn = polygon.normal.dot(in.cross(out)), along = in.dot(out);
        if (turn < -kFlat * in.length() * out.length() || in.length() == 0)
            refuse(which +
                   " makes the outline turn back, or lies on another one. Expected a convex outline, each corner once.");
        turned += std::atan2(turn, along);
    }
    if (turned > 3 * kPi) refuse("the outline goes round more than once. Expected a convex outline, each corner once.");
}

}  // namespace

ConvexPolygon::ConvexPolygon(std::vector<Vec3f> given) : corners(std::move(given)) {
    if (corners.size() < 3)
        refuse("expected three or more, found " + std::to_string(corners.size()) + ". Four make a rectangular lamp.");
    if (!std::all_of(corners.begin(), corners.end(), is_finite)) refuse("a coordinate is not a finite number.");
    for (const Vec3f& corner : corners) size = std::max(size, (corner - corners[0]).length());
    const Vec3f doubled = doubled_area(corners);
    area = 0.5f * doubled.length();
    if (!(area > 1e-9f * size * size)) refuse("they lie on one line, so there is no area to shine. Move one of them.");
    normal = doubled / (2 * area);
    check(*this);
}

/// Sutherland & Hodgman 1974.
void ConvexPolygon::above(const Vec3f& from, const Vec3f& up, std::vector<Vec3f>& cut) const {
    cut.clear();
    for (size_t i = 0; i < corners.size(); ++i) {
        const Vec3f &here = corners[i], &next = corners[(i + 1) % corners.size()];
        const float above_here = up.dot(here - from), above_next = up.dot(next - from);
        if (above_here > 0) cut.push_back(here);
        if ((above_here > 0) != (above_next > 0))
            cut.push_back(here + (next - here) * (above_here / (above_here - above_next)));
    }
    if (cut.size() < 3) cut.clear();
}

Vec3f ConvexPolygon::longest_edge() const {
    Vec3f longest(0, 0, 0);
    for (size_t i = 0; i < corners.size(); ++i) {
        const Vec3f edge = corners[(i + 1) % corners.size()] - corners[i];
        if (edge.length2() > longest.length2()) longest = edge;
    }
    return longest.normalized();
}

bool ConvexPolygon::is_parallelogram() const {
    return corners.size() == 4 && (corners[0] + corners[2] - corners[1] - corners[3]).length() <= kFlat * size;
}

}  // namespace burnish
