#include <burnish/factor/parametrization.h>

#include <burnish/base/error.h>
#include <burnish/base/nearest_name.h>

#include <algorithm>
#include <array>

namespace burnish {
namespace {

Vec3f half_of(const Vec3f& a, const Vec3f& b) {
    const Vec3f sum = a + b;
    const float length2 = sum.length2();
    return length2 > 1e-12f ? sum / std::sqrt(length2) : a;
}

/// w in the frame about h whose tangent is the x axis made perpendicular to it: Factor 22.
Vec3f difference_from(const Vec3f& h, const Vec3f& w) { return Frame::along(h, {1, 0, 0}).to_local(w); }

/// The surface's frame whose tangent points to the dominant light: isotropic surfaces lit by it alone look the same wherever
/// their directions in this frame are the same, which a tangent made of n alone would not give (Factor 68).
Vec3f toward_dominant(const Vec3f& n, const Vec3f& dominant, const Vec3f& d) { return Frame::along(n, dominant).to_local(d); }

Vec3f dominant_half(const DirectionPair& p, const FactorGuide& guide) {
    return toward_dominant(p.a, guide.dominant, half_of(guide.dominant, p.b));
}

Vec3f dominant_difference(const DirectionPair& p, const FactorGuide& guide) {
    return difference_from(dominant_half(p, guide), toward_dominant(p.a, guide.dominant, guide.dominant));
}

Vec3f elevation_of(const DirectionPair& p, const FactorGuide&) {
    const float z = std::clamp(p.a.dot(p.b), 0.0f, 1.0f);
    return {std::sqrt(1 - z * z), 0, z};
}

DirectionPair pair_itself(const Vec3f& wi, const Vec3f& wo) { return {wi, wo}; }

DirectionPair from_difference(const Vec3f& h, const Vec3f& d) {
    const Vec3f wi = Frame::along(h, {1, 0, 0}).to_world(d);
    return {wi, h * (2 * h.dot(wi)) - wi};
}

constexpr auto kBrdf = FactoredFunction::brdf;
constexpr auto kLighting = FactoredFunction::lighting;
constexpr auto kSphere = DirectionDomain::sphere;
constexpr auto kHemisphere = DirectionDomain::hemisphere;

constexpr ProjectedDirection kDirections[] = {
    {"incident", kBrdf, kHemisphere, false, [](const DirectionPair& p, const FactorGuide&) { return p.a; }, "wi"},
    {"outgoing", kBrdf, kHemisphere, false, [](const DirectionPair& p, const FactorGuide&) { return p.b; }, "wo"},
    {"half", kBrdf, kHemisphere, false, [](const DirectionPair& p, const FactorGuide&) { return half_of(p.a, p.b); },
     "half_of(wi, wo)"},
    {"difference", kBrdf, kHemisphere, false,
     [](const DirectionPair& p, const FactorGuide&) { return difference_from(half_of(p.a, p.b), p.a); },
     "difference_from(half_of(wi, wo), wi)"},
    {"normal", kLighting, kSphere, false, [](const DirectionPair& p, const FactorGuide&) { return p.a; }, "n"},
    {"view", kLighting, kSphere, false, [](const DirectionPair& p, const FactorGuide&) { return p.b; }, "wo"},
    {"reflection", kLighting, kSphere, false,
     [](const DirectionPair& p, const FactorGuide& guide) { return guide.reflection(p); }, "reflection_of(n, wo)"},
    {"elevation", kLighting, DirectionDomain::elevation, false, elevation_of, "elevation_of(n, wo)"},
    {"dominant_half", kLighting, kSphere, true, dominant_half, "toward_dominant(n, dominant, half_of(dominant, wo))"},
    {"dominant_difference", kLighting, kHemisphere, true, dominant_difference,
     "difference_from(toward_dominant(n, dominant, half_of(dominant, wo)), toward_dominant(n, dominant, dominant))"},
};

constexpr std::string_view kGlslOfBoth = R"(vec3 half_of(vec3 a, vec3 b) {
    vec3 sum = a + b;
    float length2 = dot(sum, sum);
    return length2 > 1e-12 ? sum * inversesqrt(length2) : a;
}

vec3 in_frame_along(vec3 n, vec3 hint, vec3 d) {
    vec3 t = hint - n * dot(n, hint);
    float length2 = dot(t, t);
    if (length2 > 1e-12) {
        t *= inversesqrt(length2);
        return vec3(dot(d, t), dot(d, cross(n, t)), dot(d, n));
    }
    float side = n.z < 0.0 ? -1.0 : 1.0, a = -1.0 / (side + n.z), xy = n.x * n.y * a;
    vec3 around_t = vec3(1.0 + side * n.x * n.x * a, side * xy, -side * n.x);
    vec3 around_b = vec3(xy, side + n.y * n.y * a, -n.y);
    return vec3(dot(d, around_t), dot(d, around_b), dot(d, n));
}

vec3 difference_from(vec3 h, vec3 w) { return in_frame_along(h, vec3(1.0, 0.0, 0.0), w); }
)";

constexpr std::string_view kGlslOfLighting =
    R"(vec3 toward_dominant(vec3 n, vec3 dominant, vec3 d) { return in_frame_along(n, dominant, d); }

vec3 reflection_of(vec3 n, vec3 wo) {
    float c = dot(n, wo), at = clamp(c, 0.0, 1.0) * float(reflection_curve.length() - 1);
    int low = min(int(at), reflection_curve.length() - 2);
    vec2 towards = mix(reflection_curve[low], reflection_curve[low + 1], at - float(low));
    return normalize(n * towards.x + (n * c - wo) * towards.y);
}

vec3 elevation_of(vec3 n, vec3 wo) {
    float z = clamp(dot(n, wo), 0.0, 1.0);
    return vec3(sqrt(1.0 - z * z), 0.0, z);
}
)";

Factor by(std::string_view direction, int map) {
    return {&*std::ranges::find(kDirections, direction, &ProjectedDirection::name), map};
}

/// Names are the initials of the directions; `pqp` is p(wi) q(h) p(wo).
const std::vector<Parametrization>& known() {
    static const std::vector<Parametrization> all = {
        {"re",
         "reflection seen from above and near the horizon, shared out by the view's elevation",
         kLighting,
         {by("reflection", 0), by("elevation", 1)},
         nullptr,
         2},
        {"nr", "normal and reflection (Factor 64)", kLighting, {by("normal", 0), by("reflection", 1)}},
        {"nre",
         "normal and reflection, by the view's elevation",
         kLighting,
         {by("normal", 0), by("reflection", 1), by("elevation", 2)}},
        {"nrv", "normal, reflection and view (Factor 65)", kLighting, {by("normal", 0), by("reflection", 1), by("view", 2)}},
        {"nrhd",
         "normal, reflection, half and difference vector about the dominant light (Factor 70)",
         kLighting,
         {by("normal", 0), by("reflection", 1), by("dominant_half", 2), by("dominant_difference", 3)}},
        {"io", "incident and outgoing direction (Factor 20)", kBrdf, {by("incident", 0), by("outgoing", 1)}, pair_itself},
        {"hd", "half and difference vector (Factor 23)", kBrdf, {by("half", 0), by("difference", 1)}, from_difference},
        {"pqp",
         "p(wi) q(h) p(wo), reciprocal (Factor 28)",
         kBrdf,
         {by("incident", 0), by("half", 1), by("outgoing", 0)},
         pair_itself},
    };
    return all;
}

}  // namespace

int Parametrization::map_count() const { return std::ranges::max(factors, {}, &Factor::map).map + 1; }

bool Parametrization::needs_dominant() const {
    return std::ranges::any_of(factors, [](const Factor& factor) { return factor.direction->needs_dominant; });
}

DirectionDomain Parametrization::domain(int map) const {
    DirectionDomain widest = DirectionDomain::elevation;
    for (const Factor& factor : factors)
        if (factor.map == map) widest = std::min(widest, factor.direction->domain);
    return widest;
}

int Parametrization::uses(int map) const { return static_cast<int>(std::ranges::count(factors, map, &Factor::map)); }

std::span<const ProjectedDirection> projected_directions() { return kDirections; }
std::span<const Parametrization> parametrizations() { return known(); }

const Parametrization& parametrization_by_name(std::string_view name) {
    const auto found = std::ranges::find(known(), name, &Parametrization::name);
    if (found != known().end()) return *found;
    std::vector<std::string_view> names;
    std::string list;
    for (const Parametrization& each : known()) {
        names.push_back(each.name);
        list += (list.empty() ? "" : ", ") + each.name;
    }
    throw Error(ErrorCode::bad_argument,
                "unknown parametrisation '" + std::string(name) + "'" + did_you_mean(name, names) + "; known are " + list);
}

std::string glsl_projections(FactoredFunction of) {
    return std::string(kGlslOfBoth) + (of == kLighting ? std::string(kGlslOfLighting) : std::string());
}

}  // namespace burnish
