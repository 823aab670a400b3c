#include <burnish/job/look.h>

#include <burnish/base/error.h>
#include <burnish/material/albedo.h>
#include <burnish/material/library.h>

#include <cstdio>
#include <map>
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

using ReadyMaterials = std::vector<std::shared_ptr<const ReadyMaterial>>;

/// One for every rule; `materials` may be empty.
ReadyMaterials ready_materials(const Job& job, const Wardrobe& wardrobe, const std::vector<Material>& materials,
                               const Rig& rig) {
    std::map<std::string, std::shared_ptr<ReadyMaterial>> by_name;
    ReadyMaterials ready;
    const bool sparse = is_sparse(job.density.density, job.estimator.kind);
    for (size_t rule = 0; rule < materials.size(); ++rule) {
        std::shared_ptr<ReadyMaterial>& own = by_name[wardrobe.rules[rule].material];
        if (!own) own = std::make_shared<ReadyMaterial>();
        const PossibleLight light = possible_light(rig, rule);
        if (light.distant && !own->distant) {
            own->distant.emplace(materials[rule], *rig.environment(), job.estimator);
            if (sparse) own->distant_predictor.emplace(materials[rule], *rig.environment(), job.density);
        }
        if (light.other && !own->taps) {
            own->taps = std::make_shared<const MaterialTaps>(materials[rule], job.estimator);
            if (sparse) own->probes = std::make_shared<const MaterialProbes>(materials[rule], job.density);
        }
        ready.push_back(own);
    }
    return ready;
}

void equip(const Look& look, const ReadyMaterials& materials, const std::vector<LitRule>& looks,
           std::vector<MaterialShader>& shaders, std::vector<BandwidthPredictor>& predictors) {
    if (materials.empty()) return;
    for (const LitRule& lit : looks) {
        const ReadyMaterial& material = *materials[lit.rule];
        if (look.rig.is_distant(lit.chain)) {
            shaders.push_back(*material.distant);
            if (material.distant_predictor) predictors.push_back(*material.distant_predictor);
            continue;
        }
        const LightChain chain = look.rig.chain(lit.chain);
        shaders.emplace_back(material.taps, chain);
        if (material.probes) predictors.emplace_back(material.probes, chain);
    }
}

}  // namespace

Wardrobe prepare_wardrobe(const Job& job) {
    Wardrobe wardrobe;
    wardrobe.rules = all_rules(job);
    std::set<std::string> checked;
    for (const AssignRule& rule : wardrobe.rules) {
        const Material& material = wardrobe.materials.emplace_back(resolve(job, rule.material));
        wardrobe.kd.emplace_back(material);
        if (checked.insert(rule.material).second) warn_of_energy(rule.material, material, wardrobe.warnings);
        if (job.composite.mode == CompositeMode::difference)
            wardrobe.old_materials.push_back(resolve(job, old_name(job, rule.material)));
    }
    return wardrobe;
}

Look prepare_look(const Job& job, Wardrobe wardrobe, Rig rig) {
    Look look{std::move(wardrobe), std::move(rig), {}, {}};
    look.materials = ready_materials(job, look.wardrobe, look.wardrobe.materials, look.rig);
    look.old_materials = ready_materials(job, look.wardrobe, look.wardrobe.old_materials, look.rig);
    return look;
}

Equipment equip(const Look& look, const std::vector<LitRule>& looks) {
    Equipment equipment;
    equip(look, look.materials, looks, equipment.shaders, equipment.predictors);
    equip(look, look.old_materials, looks, equipment.old_shaders, equipment.old_predictors);
    return equipment;
}

}  // namespace burnish
