#include <burnish/light/cube_map/proxy_json.h>

#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace burnish {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 2> kPlaneFields{"point", "normal"};
constexpr std::array<std::string_view, 2> kCornerBoxFields{"min", "max"};
constexpr std::array<std::string_view, 5> kTurnedBoxFields{"centre", "half", "x", "y", "z"};

Vec3f direction(const JsonFields& fields, std::string_view key) {
    const Vec3f v = fields.vector(key);
    if (!(v.length() > 0)) fail_expected(fields.path(key), "a direction other than zero", fields.at(key));
    return v;
}

OrientedBox turned_box_from_json(const JsonFields& fields) {
    constexpr float kSkew = 1e-3f;
    fields.expect_only(kTurnedBoxFields);
    OrientedBox box;
    box.centre = fields.vector("centre"), box.half = fields.vector("half");
    if (!(box.half.x > 0 && box.half.y > 0 && box.half.z > 0))
        fail_expected(fields.path("half"), "half the length of each edge, above 0", fields.at("half"));
    for (const auto& [key, axis] : {std::pair("x", &box.x), std::pair("y", &box.y), std::pair("z", &box.z)})
        if (fields.has(key)) *axis = direction(fields, key).normalized();
    if (std::max({std::fabs(box.x.dot(box.y)), std::fabs(box.y.dot(box.z)), std::fabs(box.z.dot(box.x))}) > kSkew)
        throw Error(
            ErrorCode::bad_argument,
            fields.path("x") +
                ": x, y and z are not perpendicular to each other; give all three, or leave out all that the world has");
    return box;
}

OrientedBox box_from_json(const json& value, const std::string& where) {
    const JsonFields fields(value, where);
    if (!fields.has("min") && !fields.has("max")) return turned_box_from_json(fields);
    fields.expect_only(kCornerBoxFields);
    const Vec3f low = fields.vector("min"), high = fields.vector("max");
    if (!(low.x < high.x && low.y < high.y && low.z < high.z))
        fail_expected(fields.path("max"), "a corner beyond min along x, y and z", fields.at("max"));
    OrientedBox box;
    box.centre = (low + high) / 2, box.half = (high - low) / 2;
    return box;
}

json box_to_json(const OrientedBox& box) {
    return {{"centre", to_json_vector(box.centre)},
            {"half", to_json_vector(box.half)},
            {"x", to_json_vector(box.x)},
            {"y", to_json_vector(box.y)},
            {"z", to_json_vector(box.z)}};
}

std::vector<Plane> planes_from_json(const json& value, const std::string& where) {
    if (!value.is_array() || value.empty()) fail_expected(where, "a list of planes [{\"point\": ..., \"normal\": ...}]", value);
    std::vector<Plane> planes;
    for (size_t i = 0; i < value.size(); ++i)
        planes.push_back(plane_from_json(value[i], where + "[" + std::to_string(i) + "]"));
    return planes;
}

}  // namespace

Plane plane_from_json(const json& value, const std::string& where) {
    const JsonFields fields(value, where);
    fields.expect_only(kPlaneFields);
    return {fields.vector("point"), direction(fields, "normal")};
}

json plane_to_json(const Plane& plane) {
    return {{"point", to_json_vector(plane.point)}, {"normal", to_json_vector(plane.normal)}};
}

/// A name, or an object with the one field that says what the proxy is.
ProxySettings proxy_from_json(const json& value, const std::string& where) {
    ProxySettings proxy;
    if (value.is_string()) {
        const std::array<std::string_view, 2> names{"infinite", "depth"};
        proxy.kind = name_from_json(value, where, names) == "depth" ? ProxyKind::depth : ProxyKind::infinite;
        return proxy;
    }
    const std::array<std::string_view, 3> forms{"planes", "box", "mesh"};
    if (!value.is_object())
        fail_expected(where, R"("infinite", "depth", {"planes": ...}, {"box": ...} or {"mesh": ...})", value);
    const JsonFields fields(value, where);
    fields.expect_only(forms);
    fields.expect_at_most_one(forms);
    if (fields.has("planes"))
        proxy.kind = ProxyKind::planes, proxy.planes = planes_from_json(fields.at("planes"), fields.path("planes"));
    else if (fields.has("box"))
        proxy.kind = ProxyKind::box, proxy.box = box_from_json(fields.at("box"), fields.path("box"));
    else
        proxy.kind = ProxyKind::mesh, proxy.mesh = fields.text("mesh");
    if (proxy.kind == ProxyKind::mesh && proxy.mesh.empty()) fail_expected(where, "a field planes, box or mesh", value);
    return proxy;
}

json proxy_to_json(const ProxySettings& proxy) {
    switch (proxy.kind) {
        case ProxyKind::planes: {
            json planes = json::array();
            for (const Plane& plane : proxy.planes) planes.push_back(plane_to_json(plane));
            return {{"planes", planes}};
        }
        case ProxyKind::box: return {{"box", box_to_json(proxy.box)}};
        case ProxyKind::mesh: return {{"mesh", proxy.mesh}};
        case ProxyKind::depth: return "depth";
        case ProxyKind::infinite: break;
    }
    return "infinite";
}

}  // namespace burnish
