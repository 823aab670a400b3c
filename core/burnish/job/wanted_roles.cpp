#include <burnish/job/run_frame.h>

#include <algorithm>

namespace burnish {
namespace {

template <class Test>
bool any_lobe(const Wardrobe& wardrobe, Test&& test) {
    return std::any_of(wardrobe.materials.begin(), wardrobe.materials.end(), [&](const Material& material) {
        return std::any_of(material.lobes.begin(), material.lobes.end(), test);
    });
}

void add_per_pixel(const Wardrobe& wardrobe, std::set<Role>& roles) {
    static constexpr std::pair<bool PerPixel::*, Role> kLayers[] = {{&PerPixel::roughness, Role::roughness},
                                                                    {&PerPixel::anisotropy, Role::anisotropy},
                                                                    {&PerPixel::rotation, Role::rotation},
                                                                    {&PerPixel::tint, Role::tint},
                                                                    {&PerPixel::weight, Role::weight}};
    for (const auto& [wanted, role] : kLayers)
        if (any_lobe(wardrobe, [&](const LobeParameters& lobe) { return lobe.per_pixel.*wanted; })) roles.insert(role);
}

bool is_anisotropic(const LobeParameters& lobe) { return lobe.mx != lobe.my || lobe.per_pixel.anisotropy; }

}  // namespace

std::set<Role> wanted_roles(const Job& job, const Wardrobe& wardrobe) {
    std::set<Role> roles = {Role::beauty,           Role::alpha, Role::position, Role::normal,
                            Role::geometric_normal, Role::depth, Role::mask};
    for (const auto& [role, layer] : job.channels) roles.insert(role);
    for (const AssignRule& rule : wardrobe.rules) {
        if (rule.object_index) roles.insert(Role::object_id);
        if (rule.material_index) roles.insert(Role::material_id);
    }
    add_per_pixel(wardrobe, roles);
    if (job.composite.mode == CompositeMode::replace)
        roles.insert({Role::specular_direct, Role::specular_indirect, Role::specular_albedo});
    const TangentSource tangent = job.surface.tangent;
    if (!any_lobe(wardrobe, is_anisotropic)) return roles;
    if (tangent == TangentSource::automatic || tangent == TangentSource::layer) roles.insert(Role::tangent);
    if (tangent == TangentSource::uv) roles.insert(Role::uv);
    return roles;
}

std::map<Role, std::set<Role>> substitute_roles(const Job& job, const Wardrobe& wardrobe) {
    std::map<Role, std::set<Role>> substitutes;
    substitutes[Role::beauty] = {Role::diffuse_direct, Role::diffuse_indirect, Role::diffuse_albedo, Role::irradiance};
    if (job.surface.tangent == TangentSource::automatic && any_lobe(wardrobe, is_anisotropic))
        substitutes[Role::tangent] = {Role::uv};
    return substitutes;
}

}  // namespace burnish
