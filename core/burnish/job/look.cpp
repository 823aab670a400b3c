#include <burnish/job/look.h>

#include <burnish/base/error.h>
#include <burnish/factor/factors_file.h>
#include <burnish/job/look_plan.h>
#include <burnish/job/ready_materials.h>
#include <burnish/material/albedo.h>
#include <burnish/material/library.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
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

/// Maps stay what they were made of: told where that is not what is asked for now.
void warn_of_other_maps(const std::string& file, const StoredFactors& stored, const Material& material, const Job& job,
                        std::vector<std::string>& warnings) {
    const nlohmann::json made_of = nlohmann::json::parse(stored.made_of, nullptr, false);
    const auto name_of = [](const std::string& path) { return std::filesystem::path(path).filename(); };
    if (made_of.contains("material") && made_of["material"].dump() != material_to_json(material).dump())
        warnings.push_back(file + ": these maps were made of another '" + material.name +
                           "'; they stay as they are, or make them anew");
    if (made_of.contains("environment") && made_of["environment"].is_string() &&
        name_of(made_of["environment"].get<std::string>()) != name_of(job.environment))
        warnings.push_back(file + ": these maps were made under '" + made_of["environment"].get<std::string>() +
                           "', not under the environment of this job; make them anew");
}

/// The maps that the job names for a material, into `all` by what it is called there.
void read_maps(const Job& job, const std::string& name, const Material& material, const std::string& called,
               std::map<std::string, Factors>& all, std::vector<std::string>& warnings) {
    const auto named = job.factors.find(name);
    if (named == job.factors.end() || all.contains(called)) return;
    const StoredFactors stored = read_factors(named->second);
    warn_of_other_maps(named->second, stored, material, job, warnings);
    all[called] = stored.factors;
}

/// Maps beside another estimator are a mistake, and so are maps of materials that nothing wears.
void check_maps_are_read(const Job& job) {
    if (!job.factors.empty() && job.estimator.kind != EstimatorKind::factored && !job.target.is_set())
        throw Error(ErrorCode::bad_argument,
                    "factors: only the estimator factored reads maps; add --estimator factored, or leave them out");
}

void check_maps_are_worn(const Job& job, const std::set<std::string>& worn) {
    for (const auto& [name, file] : job.factors)
        if (!worn.contains(name))
            throw Error(ErrorCode::bad_argument,
                        "factors: no rule wears material '" + name + "', whose maps are in " + file + "; correct its name");
}

const Factors* find(const std::map<std::string, Factors>& all, const std::string& name) {
    const auto found = all.find(name);
    return found == all.end() ? nullptr : &found->second;
}

/// A material with what is left of its lobes, what its tables are called, as an old one may have the name of a new one, and the maps
/// that were given for all of it.
struct Worn {
    std::string name;
    Material material;
    const Factors* maps = nullptr;
};

Worn worn(const Wardrobe& wardrobe, size_t rule, const std::optional<LobeChoice>& lobes) {
    const std::string& name = wardrobe.rules[rule].material;
    const Material& material = wardrobe.materials[rule];
    std::string kind = "new";
    if (!lobes || lobes->size() == material.lobes.size()) return {kind + " " + name, material, find(wardrobe.factors, name)};
    for (const size_t lobe : *lobes) kind += ' ' + std::to_string(lobe);
    return {kind + " " + name, with_lobes(material, *lobes)};
}

Worn worn_before(const Wardrobe& wardrobe, size_t rule) {
    const std::string& name = wardrobe.rules[rule].material;
    const std::string kind = "old";
    return {kind + " " + name, wardrobe.old_materials[rule], find(wardrobe.old_factors, name)};
}

}  // namespace

Wardrobe prepare_wardrobe(const Job& job) {
    Wardrobe wardrobe;
    wardrobe.rules = all_rules(job);
    check_maps_are_read(job);
    std::set<std::string> checked, all_names;
    for (const AssignRule& rule : wardrobe.rules) {
        const Material& material = wardrobe.materials.emplace_back(resolve(job, rule.material));
        wardrobe.kd.emplace_back(material);
        if (checked.insert(rule.material).second) {
            warn_of_energy(rule.material, material, wardrobe.warnings);
            for (const std::string& note : material.notes)
                wardrobe.warnings.push_back("material '" + rule.material + "': " + note);
        }
        all_names.insert(rule.material),
            read_maps(job, rule.material, material, rule.material, wardrobe.factors, wardrobe.warnings);
        if (job.composite.mode == CompositeMode::difference) {
            const std::string& old = old_name(job, rule.material);
            const Material& before = wardrobe.old_materials.emplace_back(resolve(job, old));
            all_names.insert(old), read_maps(job, old, before, rule.material, wardrobe.old_factors, wardrobe.warnings);
        }
    }
    check_maps_are_worn(job, all_names);
    return wardrobe;
}

Look prepare_look(const Job& job, Wardrobe wardrobe, Rig rig, const Workload& work) {
    Look look{std::move(wardrobe), std::move(rig), {job.estimator, job.density, {}}, work.frames, {}, {}};
    look.ready = std::make_shared<ReadyMaterials>();
    if (job.target.is_set()) {
        look.plan = std::make_shared<LookPlan>(job.target);
        return look;
    }
    const bool is_near = look.rig.lights.size() > (look.rig.has_environment() ? 1 : 0);
    look.shading.density.density = settled_density(job.density.density, job.estimator, work.pixels, is_near);
    return look;
}

Equipment equip(const Look& look, const std::vector<LitRule>& looks, const std::vector<ShadingSettings>& shading) {
    const Wardrobe& wardrobe = look.wardrobe;
    const auto settings_of = [&](size_t i) -> const ShadingSettings& { return shading.empty() ? look.shading : shading[i]; };
    bool sparse = false;
    for (size_t i = 0; i < looks.size(); ++i) sparse |= settings_of(i).is_sparse();
    Equipment equipment;
    for (size_t i = 0; i < looks.size(); ++i) {
        const auto& [rule, chain] = looks[i];
        const ShadingSettings& settings = settings_of(i);
        const auto add = [&](const Worn& own, auto& shaders, auto& predictors) {
            shaders.push_back(look.ready->shader(own.name, own.material, look.rig, chain, settings.estimator, own.maps));
            if (sparse) predictors.push_back(look.ready->predictor(own.name, own.material, look.rig, chain, settings.density));
        };
        add(worn(wardrobe, rule, settings.lobes), equipment.shaders, equipment.predictors);
        if (!wardrobe.old_materials.empty()) add(worn_before(wardrobe, rule), equipment.old_shaders, equipment.old_predictors);
    }
    return equipment;
}

MaterialShader equip_shader(const Look& look, const LitRule& lit, const ShadingSettings& shading) {
    const Worn own = worn(look.wardrobe, lit.rule, shading.lobes);
    return look.ready->shader(own.name, own.material, look.rig, lit.chain, shading.estimator, own.maps);
}

}  // namespace burnish
