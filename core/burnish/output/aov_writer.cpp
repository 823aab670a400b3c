#include <burnish/input/cryptomatte.h>
#include <burnish/output/aov_writer.h>
#include <burnish/output/exr_pixels.h>

#include <nlohmann/json.hpp>

#include <cstdio>

namespace burnish {
namespace {

/// Where a role goes; every character of `components` is a channel.
struct Pass {
    Role role;
    const char *name, *components;
    bool is_color;
};
constexpr Pass kPasses[] = {{Role::beauty, "Combined", "RGB", true},
                            {Role::alpha, "Combined", "A", true},
                            {Role::depth, "Depth", "Z", false},
                            {Role::position, "Position", "XYZ", false},
                            {Role::normal, "Normal", "XYZ", false},
                            {Role::uv, "UV", "UV", false},
                            {Role::object_id, "IndexOB", "X", false},
                            {Role::material_id, "IndexMA", "X", false},
                            {Role::diffuse_albedo, "DiffCol", "RGB", true},
                            {Role::diffuse_direct, "DiffDir", "RGB", true},
                            {Role::diffuse_indirect, "DiffInd", "RGB", true},
                            {Role::irradiance, "Irradiance", "RGB", true},
                            {Role::geometric_normal, "GeometricNormal", "XYZ", false},
                            {Role::tangent, "Tangent", "XYZ", false},
                            {Role::roughness, "Roughness", "X", false}};

std::string hex(uint32_t bits) {
    char text[9];
    std::snprintf(text, sizeof text, "%08x", bits);
    return text;
}

/// The layers of a file and the type of each channel, in one order.
struct Content {
    std::vector<OutputLayer> layers;
    std::vector<OIIO::TypeDesc> types;

    void add(const std::string& prefix, const std::string& components, const Image& image, OIIO::TypeDesc type) {
        OutputLayer layer{{}, &image};
        for (const char c : components) layer.channels.push_back(prefix + "." + c);
        types.insert(types.end(), components.size(), type);
        layers.push_back(std::move(layer));
    }
};

/// Two ranks share a layer, as (r, g) and (b, a); `no_rank` fills the second place of the last one where it is free.
void add_matte(const Cryptomatte& matte, const std::string& prefix, const Image& no_rank, Content& content) {
    for (size_t rank = 0; rank < matte.ranks.size(); rank += 2) {
        const std::string layer = prefix + (rank < 20 ? "0" : "") + std::to_string(rank / 2);
        content.add(layer, "rg", matte.ranks[rank], OIIO::TypeFloat);
        content.add(layer, "ba", rank + 1 < matte.ranks.size() ? matte.ranks[rank + 1] : no_rank, OIIO::TypeFloat);
    }
}

void describe_matte(const Cryptomatte& matte, const std::string& prefix, OIIO::ImageSpec& spec) {
    nlohmann::json manifest = nlohmann::json::object();
    for (const auto& [name, id] : matte.manifest) manifest[name] = hex(id);
    const std::string key = "cryptomatte/" + hex(cryptomatte_id(prefix)).substr(0, 7) + "/";
    spec.attribute(key + "name", prefix);
    spec.attribute(key + "hash", "MurmurHash3_32");
    spec.attribute(key + "conversion", "uint32_to_float32");
    spec.attribute(key + "manifest", manifest.dump());
}

/// worldToCamera of the OpenEXR standard: row vectors, camera space left-handed with +Z forward.
void describe_camera(const Camera& camera, OIIO::ImageSpec& spec) {
    const Imath::V3d x = Imath::V3d(camera.right).normalized(), y = Imath::V3d(camera.up).normalized(), z(camera.forward());
    const Imath::V3d c(camera.centre);
    const Imath::M44d to_world(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, c.x, c.y, c.z, 1);
    const Matrix44f to_camera(to_world.inverse());
    spec.attribute("worldToCamera", OIIO::TypeMatrix44, &to_camera);
}

OIIO::ImageSpec aov_spec(const AovFrame& frame, const Content& content) {
    const Window &data = frame.data_window, &display = frame.display_window;
    OIIO::ImageSpec spec(data.width, data.height, static_cast<int>(content.types.size()), OIIO::TypeFloat);
    spec.x = data.x, spec.y = data.y;
    spec.full_x = display.x, spec.full_y = display.y, spec.full_width = display.width, spec.full_height = display.height;
    spec.channelformats = content.types;
    spec.channelnames.clear();
    for (const OutputLayer& layer : content.layers)
        spec.channelnames.insert(spec.channelnames.end(), layer.channels.begin(), layer.channels.end());
    spec.attribute("compression", "zip");
    spec.attribute("Software", "burnish " BURNISH_VERSION);
    spec.attribute("DateTime", "");  // none, so that the same frame gives the same bytes
    return spec;
}

}  // namespace

void write_aovs(const std::string& file, const AovFrame& frame, const std::string& view_layer) {
    Content content;
    for (const Pass& pass : kPasses)
        if (frame.has(pass.role))
            content.add(view_layer + "." + pass.name, pass.components, frame.layer(pass.role),
                        pass.is_color ? OIIO::TypeHalf : OIIO::TypeFloat);
    const Image no_rank(frame.data_window.width, frame.data_window.height, 2);
    for (const Cryptomatte& matte : frame.cryptomattes) add_matte(matte, view_layer + "." + matte.name, no_rank, content);
    OIIO::ImageSpec spec = aov_spec(frame, content);
    for (const Cryptomatte& matte : frame.cryptomattes) describe_matte(matte, view_layer + "." + matte.name, spec);
    if (frame.camera && frame.camera->has_rays) describe_camera(*frame.camera, spec);
    write_layers(file, spec, content.layers);
}

}  // namespace burnish
