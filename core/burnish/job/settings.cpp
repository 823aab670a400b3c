#include <burnish/job/settings.h>

#include <burnish/factor/direction_map.h>
#include <burnish/factor/parametrization.h>
#include <burnish/job/job_lights.h>
#include <burnish/job/setting_kinds.h>
#include <burnish/job/structured_settings.h>
#include <burnish/light/light_json.h>

#include <algorithm>

namespace burnish {
namespace {

using namespace setting;
constexpr NumberRange kPositive{0, kAnyNumber.max};

/// Binds a table row to a member of Job, for reading and for writing.
#define AT(member) \
    [](auto& job) -> auto& { return job.member; }

void add_input(std::vector<Setting>& table) {
    using Kind = SettingKind;
    table.push_back(text({"aovs", "", "aovs"}, AT(aovs), Kind::path, "FILE",
                         "the rendered frame with its AOVs, an EXR; #### in its name stands for the frame number"));
    table.push_back(
        text({"fine_aovs", "", "fine_aovs"}, AT(fine_aovs), Kind::path, "FILE",
             "anti-aliasing: positions, normals, ids and the like of the same frame, rendered 2 or 4 times as wide and "
             "high; #### stands for the frame number; empty: those of the frame itself"));
    table.push_back(text({"frames", "", "frames"}, AT(frames), Kind::text, "RANGE",
                         "frames to do: 1-24, 1-100x5, 1,3,7-9; empty: every frame found"));
    table.push_back(choice<BadFrames>({"bad_frames", "", "bad_frames"}, AT(bad_frames),
                                      {{"error", BadFrames::error}, {"skip", BadFrames::skip}},
                                      "a frame that is missing, unreadable or lacks a channel: stop, or report it and go on"));
    table.push_back(
        text({"view", "", "view"}, AT(view), Kind::text, "NAME",
             "view of a multi-view file; all: every view, each in its own part of the output; empty: the first; %V in names of "
             "files stands for left or right, %v for l or r"));
    table.push_back(channels_setting());
    table.push_back(camera_setting());
}

void add_light(std::vector<Setting>& table) {
    table.push_back(lights_setting());
    table.push_back(chain_setting());
    table.push_back(text({"env", "lights", "file"}, AT(environment), SettingKind::path, "FILE",
                         "environment map around the objects: lat-long or cube, .hdr or .exr"));
    table.push_back(choice<EnvironmentConvention>(
        {"env_convention", "lights", "convention"}, AT(light.convention),
        {std::begin(kConventionNames), std::end(kConventionNames)},
        "how the picture lies over directions: openexr has +Z in the middle, Y up; blender +X in the middle, Z up"));
    table.push_back(choice<UpAxis>({"up", "lights", "up"}, AT(light.up), {std::begin(kUpNames), std::end(kUpNames)},
                                   "up axis of the render's world: y for Maya, Houdini, Arnold; z for Blender, 3ds Max"));
    table.push_back(number({"env_rotate", "lights", "rotate"}, AT(light.rotate_deg), kAnyNumber, "degrees",
                           "turns the environment about the up axis"));
    table.push_back(boolean({"env_flip", "lights", "flip"}, AT(light.flip), "mirrors the environment left to right"));
    table.push_back(number({"env_scale", "lights", "scale"}, AT(light.scale), kPositive, "", "multiplies the light"));
    table.push_back(color({"env_tint", "lights", "tint"}, AT(light.tint), kPositive, "colour that multiplies the light"));
    table.push_back(integer({"env_face_size", "lights", "face_size"}, AT(light.face_size), {0, 8192}, "texels",
                            "edge of the cube faces the light is kept in; 0: from the file"));
    table.push_back(choice<PyramidKernel>(
        {"env_kernel", "lights", "kernel"}, AT(light.kernel),
        {{"box2", PyramidKernel::box2}, {"binomial4", PyramidKernel::binomial4}, {"binomial6", PyramidKernel::binomial6}},
        "filter from each level of the light's pyramid to the next"));
    table.push_back(choice<Suns>({"env_suns", "lights", "suns"}, AT(light.suns),
                                 {{"auto", Suns::automatic}, {"keep", Suns::keep}},
                                 "small, very bright discs: shaded apart from the map, which is exact; or kept in the map"));
    table.push_back(text({"env_space", "lights", "space"}, AT(color.environment), SettingKind::text, "NAME",
                         "colour space of the environment; empty: as beauty_space"));
}

void add_materials(std::vector<Setting>& table) {
    table.push_back(text({"material", "", "material"}, AT(material), SettingKind::text, "NAME",
                         "what pixels wear that no assign rule names: a material of the job, a preset, merl:NAME, or a file: "
                         "JSON, a measured table, or glTF or MaterialX, where FILE#NAME chooses one of several"));
    table.push_back(materials_setting());
    table.push_back(assign_setting());
    table.push_back(pairs({"old_material", "", "old_materials"}, AT(old_materials), "NAME=OLD",
                          "mode difference: the material each was rendered with"));
    table.push_back(per_pixel_setting());
}

void add_quality(std::vector<Setting>& table) {
    table.push_back(
        choice<EstimatorKind>({"estimator", "quality", "estimator"}, AT(estimator.kind),
                              {{"fitted", EstimatorKind::fitted},
                               {"regular", EstimatorKind::regular},
                               {"filtered_importance", EstimatorKind::filtered_importance},
                               {"preconvolved", EstimatorKind::preconvolved},
                               {"split_sum", EstimatorKind::split_sum},
                               {"factored", EstimatorKind::factored},
                               {"reference", EstimatorKind::reference}},
                              "how the reflection is integrated; factored shades from maps of material and environment, "
                              "made in seconds; reference is slow and measures its own error"));
    table.push_back(integer({"samples", "quality", "samples"}, AT(estimator.samples), {0, 4096}, "",
                            "lookups per lobe and pixel; 0: as the estimator needs; fitted takes up to 16, regular the pattern "
                            "nearest to it"));
    table.push_back(boolean({"adaptive_samples", "quality", "adaptive_samples"}, AT(estimator.adaptive),
                            "fewer lookups where the light varies little inside the lobe, samples being the most of a pixel; "
                            "regular, filtered_importance, preconvolved; reference: looks at its error as soon as that says"));
    table.push_back(choice<PatternKind>({"pattern", "quality", "pattern"}, AT(estimator.pattern),
                                        {{"auto", PatternKind::automatic},
                                         {"circles", PatternKind::circles},
                                         {"offset_circles", PatternKind::offset_circles},
                                         {"ring", PatternKind::ring},
                                         {"rings", PatternKind::rings},
                                         {"line", PatternKind::line},
                                         {"tuned", PatternKind::tuned}},
                                        "shape of the regular pattern; tuned: fitted to lights, up to 30 samples; auto: tuned "
                                        "where that is better, else circles, or a line where the lobe is very long"));
    table.push_back(number({"border", "quality", "border"}, AT(estimator.border), {0, 0.999}, "",
                           "where the lobe ends: share of its energy left beyond; 0: by sample count"));
    table.push_back(choice<Quadrature>({"quadrature", "quality", "quadrature"}, AT(estimator.quadrature),
                                       {{"half_vector", Quadrature::half_vector},
                                        {"energy", Quadrature::energy},
                                        {"energy_squared", Quadrature::energy_squared}},
                                       "weights of the regular pattern"));
    table.push_back(number({"level_bias", "quality", "level_bias"}, AT(estimator.level_bias), {-8, 8}, "levels",
                           "regular and filtered_importance: added to the pyramid level of every lookup; lower is sharper"));
    table.push_back(boolean({"albedo_correction", "quality", "albedo_correction"}, AT(estimator.albedo_correction),
                            "keeps the lobe's energy at grazing angles"));
    table.push_back(number({"tolerance", "quality", "tolerance"}, AT(estimator.tolerance), {1e-6, 1}, "",
                           "reference: standard error to stop at, relative to the pixel's mean"));
    table.push_back(integer({"max_samples", "quality", "max_samples"}, AT(estimator.max_samples), {1, 1 << 20}, "",
                            "reference: most samples of a pixel"));
}

/// Those of lighting, by their own name.
std::vector<std::pair<std::string_view, std::string>> lighting_parametrizations() {
    std::vector<std::pair<std::string_view, std::string>> names;
    for (const Parametrization& each : parametrizations())
        if (each.of == FactoredFunction::lighting) names.emplace_back(each.name, each.name);
    return names;
}

void add_factored(std::vector<Setting>& table) {
    table.push_back(choice<std::string>(
        {"parametrization", "quality", "parametrization"}, AT(estimator.parametrization), lighting_parametrizations(),
        "factored: directions that its maps are looked up by: normal and reflection; the view's "
        "elevation, too; the view itself; half and difference vector about the main light"));
    table.push_back(integer({"map_size", "quality", "map_size"}, AT(estimator.map_size),
                            {DirectionMap::kLeastSize, DirectionMap::kMostSize}, "texels",
                            "factored: edge of a disc of its maps"));
    table.push_back(
        pairs({"factors", "quality", "factors"}, AT(factors), "NAME=FILE",
              "factored: maps that burnish factor made of the material NAME under this environment, instead of making "
              "them; the environment may be turned and scaled otherwise"));
}

void add_target(std::vector<Setting>& table) {
    table.push_back(
        number({"psnr", "quality", "psnr"}, AT(target.psnr), {0, 100}, "dB",
               "display PSNR that every material is to reach against the exact integral, instead of estimator, samples "
               "and density, which are then chosen; checked at some hundred pixels; 0: not asked"));
    table.push_back(number({"max_error", "quality", "max_error"}, AT(target.max_error), {0, 1}, "",
                           "the same by the largest error of a checked pixel, as displayed, white = 1; 0: not asked"));
    table.push_back(
        number({"time", "quality", "time"}, AT(target.seconds), {0, 1e6}, "seconds",
               "that a frame may take by the clock, light and tables included, reading and writing not, on the machine "
               "that was calibrated: the best picture that does; 0: not asked"));
}

void add_density(std::vector<Setting>& table) {
    table.push_back(choice<ShadingDensity>(
        {"density", "quality", "density"}, AT(density.density),
        {{"auto", ShadingDensity::automatic}, {"dense", ShadingDensity::dense}, {"sparse", ShadingDensity::sparse}},
        "which pixels are shaded: dense, all of them; sparse, as many as the predicted bandwidth "
        "asks for, the others are interpolated; auto: sparse from two million pixels, 32 lookups or "
        "lights near the objects on, but dense for reference"));
    table.push_back(
        choice<PredictionKind>({"prediction", "quality", "prediction"}, AT(density.prediction),
                               {{"curvature", PredictionKind::curvature},
                                {"correlated", PredictionKind::correlated},
                                {"source", PredictionKind::source}},
                               "sparse: what predicts the bandwidth: how sharply the filtered light bends; or wavelet "
                               "bandwidths of light and lobe, space and angle together, or as published"));
    table.push_back(integer({"directions", "quality", "directions"}, AT(density.directions), {0, 64}, "",
                            "sparse: directions of light per lobe and prediction; 0: as the prediction needs"));
    table.push_back(number(
        {"safety", "quality", "safety"}, AT(density.safety), {0.05, 100}, "",
        "sparse: multiplies the predicted bandwidth; 1 keeps within 45 dB of dense, 2 within 52; more is closer and slower"));
}

void add_surface(std::vector<Setting>& table) {
    table.push_back(choice<TangentSource>({"tangent", "surface", "tangent"}, AT(surface.tangent),
                                          {{"auto", TangentSource::automatic},
                                           {"layer", TangentSource::layer},
                                           {"uv", TangentSource::uv},
                                           {"axis", TangentSource::axis}},
                                          "where the direction of brushing comes from; auto: the first that the frame allows"));
    table.push_back(tangent_axis_setting());
    table.push_back(number({"min_normal_length", "surface", "min_normal_length"}, AT(surface.min_normal_length), {0, 1}, "",
                           "pixels whose averaged normal is shorter are not shaded"));
    table.push_back(boolean({"roughness_is_alpha", "surface", "roughness_is_alpha"}, AT(surface.roughness_is_alpha),
                            "the roughness layer holds alpha instead of the artist's roughness (alpha = roughness^2)"));
}

void add_composite(std::vector<Setting>& table) {
    table.push_back(choice<CompositeMode>(
        {"mode", "composite", "mode"}, AT(composite.mode),
        {{"add", CompositeMode::add}, {"replace", CompositeMode::replace}, {"difference", CompositeMode::difference}},
        "add the overlay; replace the rendered specular by it; or add new minus old material"));
    table.push_back(number({"gain", "composite", "gain"}, AT(composite.gain), kPositive, "", "multiplies the overlay"));
    table.push_back(color({"tint", "composite", "tint"}, AT(composite.tint), kPositive, "colour that multiplies the overlay"));
}

void add_antialias(std::vector<Setting>& table) {
    table.push_back(choice<FilterKind>({"filter", "antialias", "filter"}, AT(antialias.filter.kind),
                                       {{"auto", FilterKind::automatic},
                                        {"box", FilterKind::box},
                                        {"triangle", FilterKind::triangle},
                                        {"gaussian", FilterKind::gaussian},
                                        {"blackman_harris", FilterKind::blackman_harris}},
                                       "pixel filter the frame was rendered with, by which fine_aovs become pixels; auto: the "
                                       "default of its renderer, or box"));
    table.push_back(number({"filter_width", "antialias", "filter_width"}, AT(antialias.filter.width), {0, 16}, "pixels",
                           "of that filter; 0: its usual width"));
    table.push_back(
        choice<EdgeCoverage>({"edge_coverage", "antialias", "edge_coverage"}, AT(antialias.coverage),
                             {{"samples", EdgeCoverage::samples}, {"alpha", EdgeCoverage::alpha}},
                             "share of a pixel at an edge that fine_aovs cover: by their samples, or by the frame's "
                             "alpha, for frames rendered over nothing"));
}

void add_color(std::vector<Setting>& table) {
    table.push_back(text({"ocio_config", "color", "config"}, AT(color.config), SettingKind::path, "FILE",
                         "OpenColorIO config; empty: the one $OCIO names"));
    table.push_back(text({"beauty_space", "color", "beauty_space"}, AT(color.beauty), SettingKind::text, "NAME",
                         "linear colour space of the frame, in which burnish shades; empty: as it is"));
    table.push_back(text({"output_space", "color", "output_space"}, AT(color.output), SettingKind::text, "NAME",
                         "colour space of the EXR written; empty: the frame's own"));
}

void add_output(std::vector<Setting>& table) {
    using Kind = SettingKind;
    table.push_back(text({"output", "output", "file"}, AT(output.file), Kind::path, "FILE",
                         "EXR to write; #### stands for the frame number"));
    table.push_back(choice<PixelType>({"pixel_type", "output", "pixel_type"}, AT(output.pixel_type),
                                      {{"half", PixelType::half}, {"float", PixelType::float32}}, "of the EXR's channels"));
    table.push_back(text({"preview", "output", "preview"}, AT(output.preview), Kind::path, "FILE", "PNG to look at"));
    table.push_back(text({"report", "output", "report"}, AT(output.report), Kind::path, "FILE",
                         "JSON report: what was found, done and how long it took"));
    table.push_back(boolean({"diagnostics", "output", "diagnostics"}, AT(output.diagnostics),
                            "adds layers burnish_validity, burnish_samples and, for the reference, burnish_error"));
    table.push_back(boolean({"keep_layers", "output", "keep_layers"}, AT(output.keep_layers),
                            "writes every layer of the frame through beside burnish's own, bit by bit as it is stored"));
    table.push_back(boolean({"skip_existing", "output", "skip_existing"}, AT(output.skip_existing),
                            "leaves out frames whose output is whole, of the same job, and newer than all its inputs"));
    table.push_back(integer({"threads", "", "threads"}, AT(threads), {0, 1024}, "", "worker threads; 0: all cores"));
}

#undef AT

std::vector<Setting> make_settings() {
    std::vector<Setting> table;
    for (auto* add : {add_input, add_light, add_materials, add_target, add_quality, add_factored, add_density, add_surface,
                      add_composite, add_antialias, add_color, add_output})
        add(table);
    return table;
}

}  // namespace

std::span<const Setting> settings() {
    static const std::vector<Setting> table = make_settings();
    return table;
}

void set_settings(Job& job, const nlohmann::json& values, const std::string& where) {
    std::vector<std::string_view> names;
    for (const Setting& setting : settings()) names.push_back(setting.name);
    for (const auto& [name, value] : values.items()) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) fail_unknown(where.empty() ? "job" : where, "setting", name, names);
        settings()[static_cast<size_t>(found - names.begin())].set(job, value, where.empty() ? name : where + ": " + name);
    }
}

}  // namespace burnish
