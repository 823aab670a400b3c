#include <burnish/base/error.h>
#include <burnish/base/json_fields.h>
#include <burnish/output/exr_writer.h>
#include <burnish/output/scene_writer.h>

#include <Imath/ImathBox.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <filesystem>

namespace burnish {
namespace {

using nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little);

constexpr int kFloat = 5126, kUnsigned = 5125, kVertexBuffer = 34962, kIndexBuffer = 34963;

/// A glTF document and its one buffer, as they grow.
class Document {
public:
    explicit Document(UpAxis up) : m_z_up(up == UpAxis::z) {
        m_json["asset"] = {{"version", "2.0"}, {"generator", "burnish " BURNISH_VERSION}};
        m_json["extensionsUsed"] = {"KHR_materials_emissive_strength"};
        m_json["scene"] = 0;
        m_json["scenes"] = {{{"nodes", ordered_json::array()}}};
    }

    void add(const Object& object) {
        const size_t index = m_json["nodes"].size();
        m_json["scenes"][0]["nodes"].push_back(index);
        m_json["nodes"].push_back({{"name", object.name}, {"mesh", index}, {"extras", {{"pass_index", object.object_index}}}});
        const Mesh& mesh = object.mesh;
        ordered_json attributes;
        attributes["POSITION"] = positions(mesh);
        attributes["NORMAL"] = vertices(mesh, "VEC3", [&](const Vertex& v) { return turned(v.n); });
        attributes["TEXCOORD_0"] = vertices(mesh, "VEC2", [](const Vertex& v) { return Vec2f(v.uv.x, 1 - v.uv.y); });
        const size_t indices = accessor(mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]),
                                        3 * mesh.triangles.size(), kUnsigned, "SCALAR", kIndexBuffer);
        const ordered_json primitive = {{"attributes", attributes}, {"indices", indices}, {"material", material(object)}};
        m_json["meshes"].push_back({{"name", object.name}, {"primitives", {primitive}}});
    }

    /// The two chunks of a .glb, each padded to four bytes.
    std::string bytes() const {
        ordered_json json = m_json;
        json["buffers"] = {{{"byteLength", m_buffer.size()}}};
        std::string text = json.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string file = "glTF";
        append(file, 2), append(file, 28 + text.size() + m_buffer.size());
        append(file, text.size()), file += "JSON" + text;
        append(file, m_buffer.size()), file += std::string("BIN\0", 4) + m_buffer;
        return file;
    }

private:
    static void append(std::string& file, size_t number) {
        const auto word = static_cast<uint32_t>(number);
        file.append(reinterpret_cast<const char*>(&word), sizeof word);
    }

    Vec3f turned(const Vec3f& v) const { return m_z_up ? Vec3f(v.x, v.z, -v.y) : v; }

    size_t accessor(const void* data, size_t bytes, size_t count, int component, const char* type, int target) {
        const size_t view = m_json["bufferViews"].size();
        m_json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", m_buffer.size()}, {"byteLength", bytes}, {"target", target}});
        m_json["accessors"].push_back({{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
        m_buffer.append(static_cast<const char*>(data), bytes);
        return view;
    }

    template <class Of>
    size_t vertices(const Mesh& mesh, const char* type, const Of& of) {
        std::vector<decltype(of(mesh.vertices[0]))> values;
        std::ranges::transform(mesh.vertices, std::back_inserter(values), of);
        return accessor(values.data(), values.size() * sizeof(values[0]), values.size(), kFloat, type, kVertexBuffer);
    }

    size_t positions(const Mesh& mesh) {
        const size_t index = vertices(mesh, "VEC3", [&](const Vertex& v) { return turned(v.p); });
        Imath::Box<Vec3f> box;
        for (const Vertex& vertex : mesh.vertices) box.extendBy(turned(vertex.p));
        m_json["accessors"][index]["min"] = to_json_vector(box.min);
        m_json["accessors"][index]["max"] = to_json_vector(box.max);
        return index;
    }

    size_t material(const Object& object) {
        const float strength = std::max({object.emission.x, object.emission.y, object.emission.z});
        const Color3f emissive = strength > 0 ? object.emission / strength : Color3f(0.0f);
        ordered_json color = to_json_vector(object.albedo);
        color.push_back(1);
        ordered_json material = {{"name", object.material}, {"extras", {{"pass_index", object.material_index}}}};
        material["pbrMetallicRoughness"] = {
            {"baseColorFactor", color}, {"metallicFactor", 0}, {"roughnessFactor", to_json_number(object.roughness)}};
        if (strength > 0) {
            material["emissiveFactor"] = to_json_vector(emissive);
            material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = to_json_number(strength);
        }
        ordered_json& known = m_json["materials"];
        const auto found = std::find(known.begin(), known.end(), material);
        if (found != known.end()) return static_cast<size_t>(found - known.begin());
        known.push_back(std::move(material));
        return known.size() - 1;
    }

    bool m_z_up;
    ordered_json m_json = {{"nodes", ordered_json::array()},
                           {"meshes", ordered_json::array()},
                           {"materials", ordered_json::array()},
                           {"accessors", ordered_json::array()},
                           {"bufferViews", ordered_json::array()}};
    std::string m_buffer;
};

}  // namespace

void write_scene(const std::string& file, const Scene& scene, UpAxis up) {
    if (std::filesystem::path(file).extension() != ".glb")
        throw Error(ErrorCode::bad_argument, file + ": scenes are written as binary glTF; end the name in .glb");
    Document document(up);
    for (const Object& object : scene.objects)
        if (!object.mesh.triangles.empty()) document.add(object);
    write_text(file, document.bytes());
}

}  // namespace burnish
