// The roles an AOV can play. One table gives each role its name, channel count and the aliases renderers use for it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

enum class Role {
    beauty,
    alpha,
    position,
    normal,
    geometric_normal,
    depth,
    tangent,
    uv,
    roughness,
    anisotropy,
    rotation,
    tint,
    weight,
    object_id,
    material_id,
    mask,
    diffuse_direct,
    diffuse_indirect,
    diffuse_albedo,
    irradiance,
    specular_direct,
    specular_indirect,
    specular_albedo,
};

struct RoleInfo {
    Role role;
    std::string_view name;                  // as `--channel name=layer` and the shot file spell it
    int channels;                           // 1, 2 or 3
    bool is_color;                          // light and colour: NaN and infinity are set to 0; data keeps them
    std::string_view help;                  // what the layer holds, units included
    std::vector<std::string_view> aliases;  // normalised last layer tokens (lower case, without [ _-]), best first
};

/// All roles, in the order of the enum.
std::span<const RoleInfo> roles();
const RoleInfo& role_info(Role role);
/// Whether the role is light that reached the camera, or coverage: filtered as the picture is. The others are of the surfaces.
bool is_of_picture(Role role);
/// Role by name; throws Error(bad_argument) listing the names when there is none.
Role role_by_name(std::string_view name);

}  // namespace burnish
