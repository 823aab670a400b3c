#include <burnish/scene/gltf_document.h>

#include <burnish/base/error.h>
#include <burnish/material/import/gltf_file.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace burnish {

using nlohmann::json;

namespace {

constexpr int kDeepestNode = 256;
constexpr double kStrongest = 1e9;
constexpr double kMostElements = 1 << 28;  // vertices and corners of triangles

[[noreturn]] void refuse(const std::string& file, const std::string& problem) {
    throw Error(ErrorCode::read_failed, file + ": " + problem);
}

const json& member(const json& object, const char* name) {
    static const json kNone;
    const auto found = object.is_object() ? object.find(name) : object.end();
    return found != object.end() ? *found : kNone;
}

const json& list(const json& object, const char* name) {
    static const json kEmpty = json::array();
    const json& value = member(object, name);
    return value.is_array() ? value : kEmpty;
}

double number(const json& value, double fallback) { return value.is_number() ? value.get<double>() : fallback; }

/// Place of `value` in a list of `count`; nothing when it names none.
std::optional<size_t> index(const json& value, size_t count) {
    const double place = number(value, -1);
    if (!(place >= 0 && place < static_cast<double>(count))) return std::nullopt;
    return static_cast<size_t>(place);
}

/// A node with two parents, or that is named twice, multiplies with every level.
void check_nodes(const std::string& file, const json& nodes) {
    constexpr size_t kNoParent = SIZE_MAX;
    std::vector<size_t> parents(nodes.size(), kNoParent);
    for (size_t i = 0; i < nodes.size(); ++i)
        for (const json& child : list(nodes[i], "children")) {
            const auto place = index(child, nodes.size());
            if (!place) refuse(file, "nodes[" + std::to_string(i) + "] has a child that does not exist; export it again");
            if (parents[*place] != kNoParent)
                refuse(file,
                       "nodes[" + std::to_string(*place) + "] has two parents, which glTF does not allow; export it again");
            parents[*place] = i;
        }
    for (size_t i = 0; i < nodes.size(); ++i) {
        int depth = 0;
        for (size_t at = parents[i]; at != kNoParent; at = parents[at])
            if (++depth > kDeepestNode)
                refuse(file, "nodes[" + std::to_string(i) + "] lies more than " + std::to_string(kDeepestNode) +
                                 " levels deep, or in a loop; apply the parents' transforms and export it again");
    }
}

void check_scenes(const std::string& file, const json& scenes, size_t nodes) {
    for (const json& scene : scenes) {
        std::vector<bool> named(nodes);
        for (const json& node : list(scene, "nodes")) {
            const auto place = index(node, nodes);
            if (!place || named[*place])
                refuse(file, "a scene names a node twice, or one that does not exist; export it again");
            named[*place] = true;
        }
    }
}

double elements(const json& mesh, const json& accessors) {
    double sum = 0;
    const auto count = [&](const json& accessor) {
        if (const auto place = index(accessor, accessors.size()))
            sum += std::max(number(member(accessors[*place], "count"), 0), 0.0);
    };
    for (const json& primitive : list(mesh, "primitives")) {
        count(member(primitive, "indices"));
        for (const json& attribute : member(primitive, "attributes")) count(attribute);
    }
    return sum;
}

void check_sizes(const std::string& file, const json& document) {
    const json &meshes = list(document, "meshes"), &accessors = list(document, "accessors");
    double sum = 0;
    for (const json& mesh : meshes) sum += elements(mesh, accessors);
    for (const json& node : list(document, "nodes"))
        if (const auto place = index(member(node, "mesh"), meshes.size())) sum += elements(meshes[*place], accessors);
    if (sum > kMostElements) refuse(file, "holds more vertices than burnish reads; make the meshes simpler");
}

GltfMaterial material_of(const json& material) {
    GltfMaterial result;
    const json& strength = member(member(material, "extensions"), "KHR_materials_emissive_strength");
    result.emissive_strength = static_cast<float>(std::clamp(number(member(strength, "emissiveStrength"), 1), 0.0, kStrongest));
    result.pass_index = pass_index(number(member(member(material, "extras"), "pass_index"), -1));
    return result;
}

}  // namespace

std::optional<int> pass_index(double number) {
    if (!(number >= 0 && number <= 1 << 24 && number == std::floor(number))) return std::nullopt;
    return static_cast<int>(number);
}

std::vector<GltfMaterial> read_gltf_materials(const std::string& file) {
    const json document = read_gltf(file);
    check_nodes(file, list(document, "nodes"));
    check_scenes(file, list(document, "scenes"), list(document, "nodes").size());
    check_sizes(file, document);
    std::vector<GltfMaterial> materials;
    for (const json& material : list(document, "materials")) materials.push_back(material_of(material));
    return materials;
}

}  // namespace burnish
