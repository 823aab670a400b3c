#include <burnish/scene/load_scene.h>

#include <burnish/base/error.h>
#include <burnish/scene/gltf_document.h>
#include <burnish/scene/mesh_frames.h>

#include <assimp/BaseImporter.h>
#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

namespace burnish {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 31;
constexpr float kFarthest = 1e15f;  // squares of lengths must stay finite

[[noreturn]] void refuse(const std::string& file, std::string problem) {
    std::ranges::replace(problem, '\n', ' ');
    throw Error(ErrorCode::read_failed, file + ": " + problem);
}

bool is_readable(const std::string& file) {
    std::error_code failed;
    return std::filesystem::is_regular_file(file, failed) && std::filesystem::file_size(file, failed) <= kLargestFile;
}

/// Scene files name others; none of them may be a device or endless.
class RegularFiles : public Assimp::DefaultIOSystem {
public:
    Assimp::IOStream* Open(const char* file, const char* mode) override {
        return is_readable(file) ? DefaultIOSystem::Open(file, mode) : nullptr;
    }
};

std::string extension_of(const std::string& file) {
    std::string extension = std::filesystem::path(file).extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension;
}

void check_file(const std::string& file) {
    std::error_code failed;
    const std::string extension = extension_of(file);
    if (extension != ".glb" && extension != ".gltf" && extension != ".obj")
        refuse(file, "expected a scene as .glb, .gltf or .obj; export it as one of these");
    if (!std::filesystem::exists(file, failed)) refuse(file, "no such file; check the path of the scene");
    if (!is_readable(file)) refuse(file, "expected a file of at most 2 GiB; make its meshes simpler");
}

/// Importers of other formats than these are not asked, whatever a damaged file looks like.
void keep_known_formats(Assimp::Importer& importer) {
    for (size_t i = importer.GetImporterCount(); i-- > 0;) {
        const aiImporterDesc& known = *importer.GetImporterInfo(i);
        if (std::string_view(known.mName).starts_with("glTF2") || std::string_view(known.mFileExtensions) == "obj") continue;
        Assimp::BaseImporter* other = importer.GetImporter(i);
        importer.UnregisterLoader(other);
        delete other;
    }
}

const aiScene& read(Assimp::Importer& importer, const std::string& file) {
    keep_known_formats(importer);
    importer.SetIOHandler(new RegularFiles);
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(file, aiProcess_Triangulate | aiProcess_SortByPType |
                                                       aiProcess_JoinIdenticalVertices | aiProcess_ValidateDataStructure);
    if (!scene) refuse(file, std::string("cannot be read: ") + importer.GetErrorString());
    if (!scene->mRootNode) refuse(file, "holds no objects");
    return *scene;
}

Vec3f vec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// Assimp's matrices are for column vectors.
Matrix44f matrix(const aiMatrix4x4& m) {
    return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

Color3f color(const aiMaterial& material, const char* key, const Color3f& fallback) {
    aiColor4D value;
    if (material.Get(key, 0, 0, value) != aiReturn_SUCCESS) return fallback;
    const Color3f rgb(value.r, value.g, value.b);
    return is_finite(rgb) ? Color3f(std::max(rgb.x, 0.0f), std::max(rgb.y, 0.0f), std::max(rgb.z, 0.0f)) : fallback;
}

double number_of(const aiMetadata* data, const char* key) {
    int32_t whole = 0;
    uint64_t natural = 0;
    float real = 0;
    double wide = -1;
    if (!data) return -1;
    if (data->Get(key, whole)) return whole;
    if (data->Get(key, natural)) return static_cast<double>(natural);
    if (data->Get(key, real)) return real;
    return data->Get(key, wide) ? wide : -1;
}

/// Indices that the file gives, else counted in the order of first use.
class Indices {
public:
    int of(unsigned item, std::optional<int> given) {
        if (given) return *given;
        return m_counted.try_emplace(item, static_cast<int>(m_counted.size()) + 1).first->second;
    }

private:
    std::map<unsigned, int> m_counted;
};

/// Makes the objects of a file's nodes.
class Conversion {
public:
    Conversion(const std::string& file, const SceneSettings& settings, const aiScene& from, std::vector<GltfMaterial> materials)
        : m_file(file), m_settings(settings), m_from(from), m_materials(std::move(materials)) {}

    void add(const aiNode& node, const Matrix44f& parent) {
        const Matrix44f to_world = matrix(node.mTransformation) * parent;
        const int index =
            node.mNumMeshes > 0 ? m_nodes.of(m_nodes_seen++, pass_index(number_of(node.mMetaData, "pass_index"))) : 0;
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            const aiMesh& mesh = *m_from.mMeshes[node.mMeshes[i]];
            Object object;
            object.name = node.mName.C_Str(), object.object_index = index;
            set_material(mesh.mMaterialIndex, object);
            object.mesh = world_mesh(mesh, to_world, object.name);
            if (!object.mesh.triangles.empty()) scene.objects.push_back(std::move(object));
        }
        for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], to_world);
    }

    Scene scene;

private:
    void set_material(unsigned index, Object& object) {
        const aiMaterial& material = *m_from.mMaterials[index];
        const GltfMaterial facts = index < m_materials.size() ? m_materials[index] : GltfMaterial();
        object.material = material.GetName().C_Str();
        object.material_index = m_material_indices.of(index, facts.pass_index);
        object.albedo = color(material, "$clr.base", color(material, "$clr.diffuse", object.albedo));
        object.emission = color(material, "$clr.emissive", object.emission) * facts.emissive_strength;
    }

    Mesh world_mesh(const aiMesh& from, const Matrix44f& to_world, const std::string& name) const {
        Mesh mesh;
        const Matrix44f normals = to_world.inverse().transposed();
        const aiVector3D* uv = from.mTextureCoords[m_settings.texcoord];
        if (!uv && m_settings.texcoord > 0)
            throw Error(ErrorCode::bad_argument, m_file + ": mesh '" + name + "' has no TEXCOORD_" +
                                                     std::to_string(m_settings.texcoord) +
                                                     "; export it with that set of texture coordinates, or ask for another");
        for (unsigned i = 0; i < from.mNumVertices; ++i) {
            Vertex vertex{vec3(from.mVertices[i]) * to_world, Vec3f(0, 0, 0), Vec3f(0, 0, 0), Vec2f(0, 0)};
            if (!(vertex.p.length2() < kFarthest * kFarthest))
                refuse(m_file, "mesh '" + name + "': vertex " + std::to_string(i) +
                                   " is not at a finite place; apply its transform and export it again");
            if (from.HasNormals()) normals.multDirMatrix(vec3(from.mNormals[i]), vertex.n), vertex.n.normalize();
            if (uv && std::isfinite(uv[i].x) && std::isfinite(uv[i].y)) vertex.uv = Vec2f(uv[i].x, uv[i].y);
            mesh.vertices.push_back(vertex);
        }
        add_triangles(from, to_world.determinant() < 0, mesh);
        if (!from.HasNormals()) set_face_normals(mesh);
        set_tangents(mesh);
        return mesh;
    }

    /// A transform that mirrors turns triangles inside out.
    static void add_triangles(const aiMesh& from, bool mirrored, Mesh& mesh) {
        for (unsigned i = 0; i < from.mNumFaces; ++i) {
            const aiFace& face = from.mFaces[i];
            if (face.mNumIndices != 3) continue;
            const unsigned b = face.mIndices[mirrored ? 2 : 1], c = face.mIndices[mirrored ? 1 : 2];
            mesh.triangles.push_back({face.mIndices[0], b, c});
        }
    }

    const std::string& m_file;
    const SceneSettings& m_settings;
    const aiScene& m_from;
    std::vector<GltfMaterial> m_materials;
    Indices m_nodes, m_material_indices;
    unsigned m_nodes_seen = 0;
};

}  // namespace

Scene load_scene(const std::string& file, const SceneSettings& settings) {
    if (settings.texcoord < 0 || settings.texcoord >= AI_MAX_NUMBER_OF_TEXTURECOORDS)
        throw Error(ErrorCode::bad_argument, file + ": the set of texture coordinates is " + std::to_string(settings.texcoord) +
                                                 ", expected 0 to " + std::to_string(AI_MAX_NUMBER_OF_TEXTURECOORDS - 1));
    check_file(file);
    const bool gltf = extension_of(file) != ".obj";
    std::vector<GltfMaterial> materials;
    if (gltf) materials = read_gltf_materials(file);
    const Matrix44f z_up(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);  // (x, y, z) -> (x, -z, y)
    try {
        Assimp::Importer importer;
        const aiScene& from = read(importer, file);
        Conversion conversion(file, settings, from, std::move(materials));
        conversion.add(*from.mRootNode, gltf && settings.up == UpAxis::z ? z_up : Matrix44f());
        if (conversion.scene.objects.empty()) refuse(file, "holds no triangles; export meshes");
        return std::move(conversion.scene);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& problem) {
        refuse(file, std::string("cannot be read: ") + problem.what());
    }
}

}  // namespace burnish
