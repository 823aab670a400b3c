#include <burnish/job/look.h>

#include <burnish/base/error.h>
#include <burnish/material/albedo.h>
#include <burnish/material/library.h>

#include <cstdio>
#include <set>

namespace burnish {
namespace {

std::vector<AssignRule> all_rules(const Job& job) {
    std::vector<AssignRule> rules = job.assign;
    if (!job.material.empty()) rules.insert(rules.begin(), AssignRule{job.material, {}, {}, {}});
    if (rules.empty())
        throw Error(ErrorCode::bad_argument,
                    "no material: name one with --material NAME (burnish models lists the presets), or give pixels theirs with "
                    "--assign");
    return rules;
}

Material resolve(const Job& job, const std::string& name) {
    const auto own = job.materials.find(name);
    Material material = own != job.materials.end() ? own->second : find_material(name);
    for (LobeParameters& lobe : material.lobes) {
        lobe.per_pixel.roughness |= job.per_pixel.roughness, lobe.per_pixel.anisotropy |= job.per_pixel.anisotropy;
        lobe.per_pixel.rotation |= job.per_pixel.rotation, lobe.per_pixel.tint |= job.per_pixel.tint;
        lobe.per_pixel.weight |= job.per_pixel.weight;
    }
    return material;
}

const std::string& old_name(const Job& job, const std::string& name) {
    const auto old = job.old_materials.find(name);
    if (old != job.old_materials.end()) return old->second;
    throw Error(ErrorCode::bad_argument, "old_materials: mode difference needs the material that '" + name +
                                             "' was rendered with; add --old-material " + name + "=OLD");
}

void warn_of_energy(const std::string& name, const Material& material, std::vector<std::string>& warnings) {
    constexpr float kNumericalSlack = 1.005f;  // the check's own error
    const EnergyCheck check = check_energy(material);
    if (check.max_albedo <= kNumericalSlack) return;
    char numbers[96];
    std::snprintf(numbers, sizeof numbers, "%.3g times the light at %.0f degrees", check.max_albedo, check.theta_o_deg);
    warnings.push_back("material '" + name + "' creates energy: it reflects " + numbers + "; lower its strength");
}

/// One of each material for the light, be it shader or predictor.
template <class Made, class Settings>
std::vector<Made> for_each_material(const std::vector<Material>& materials, const Environment& light,
                                    const Settings& settings) {
    std::vector<Made> made;
    for (const Material& material : materials) made.emplace_back(material, light, settings);
    return made;
}

}  // namespace

Wardrobe prepare_wardrobe(const Job& job) {
    Wardrobe wardrobe;
    wardrobe.rules = all_rules(job);
    std::set<std::string> checked;
    for (const AssignRule& rule : wardrobe.rules) {
        const Material& material = wardrobe.materials.emplace_back(resolve(job, rule.material));
        wardrobe.kd.push_back(material.kd);
        if (checked.insert(rule.material).second) warn_of_energy(rule.material, material, wardrobe.warnings);
        if (job.composite.mode == CompositeMode::difference)
            wardrobe.old_materials.push_back(resolve(job, old_name(job, rule.material)));
    }
    return wardrobe;
}

Look prepare_look(const Job& job, Wardrobe wardrobe, std::shared_ptr<const Environment> light) {
    Look look{std::move(wardrobe), std::move(light), {}, {}, {}, {}};
    const std::vector<Material>&materials = look.wardrobe.materials, &old_materials = look.wardrobe.old_materials;
    look.shaders = for_each_material<MaterialShader>(materials, *look.light, job.estimator);
    look.old_shaders = for_each_material<MaterialShader>(old_materials, *look.light, job.estimator);
    if (is_sparse(job.density.density, job.estimator.kind)) {
        look.predictors = for_each_material<BandwidthPredictor>(materials, *look.light, job.density);
        look.old_predictors = for_each_material<BandwidthPredictor>(old_materials, *look.light, job.density);
    }
    return look;
}

}  // namespace burnish
