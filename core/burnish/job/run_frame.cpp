#include <burnish/job/run_frame.h>

#include <burnish/base/error.h>
#include <burnish/job/stages.h>

#include <algorithm>

namespace burnish {
namespace {

bool is_anisotropic(const LobeParameters& lobe) { return lobe.mx != lobe.my || lobe.per_pixel.anisotropy; }

/// Which axis brushing runs around, when an anisotropic material meets a frame without tangents.
void warn_of_tangents(const Look& look, const Surfaces& surfaces, const SurfaceSettings& settings, FrameReport& report) {
    if (surfaces.tangent_source() != TangentSource::axis) return;
    for (const Material& material : look.wardrobe.materials) {
        if (std::none_of(material.lobes.begin(), material.lobes.end(), is_anisotropic)) continue;
        const Vec3f& a = settings.tangent_axis;
        char axis[96];
        std::snprintf(axis, sizeof axis, "%g,%g,%g", a.x, a.y, a.z);
        report.warnings.push_back("no tangent layer: anisotropic lobes of '" + material.name + "' run around the axis " + axis +
                                  " (--tangent-axis)");
    }
}

void count_pixels(const Surfaces& surfaces, const Assignment& assignment, const Look& look, FrameReport& report) {
    for (int i = 0; i < kValidityCount; ++i)
        report.pixels.emplace_back(validity_name(static_cast<Validity>(i)), surfaces.counts()[static_cast<size_t>(i)]);
    for (const AssignRule& rule : look.wardrobe.rules) report.materials.emplace_back(rule.material, 0);
    for (size_t i = 0; i < assignment.rule.size(); ++i)
        if (surfaces.validity(i) == Validity::valid) ++report.materials[static_cast<size_t>(assignment.rule[i])].second;
    for (size_t rule = 0; rule < look.wardrobe.rules.size(); ++rule) {
        const AssignRule& r = look.wardrobe.rules[rule];
        const bool selects = r.object_index || r.material_index || !r.cryptomatte.empty();
        if (selects && assignment.counts[rule] == 0)
            report.warnings.push_back("the rule for material '" + r.material + "' finds no pixel of its own");
    }
    const size_t broken = surfaces.counts()[static_cast<size_t>(Validity::not_finite)];
    if (broken > 0)
        report.warnings.push_back(std::to_string(broken) + " pixels hold NaN or infinity in P or N and are left as they were");
    if (surfaces.counts()[0] == 0) report.warnings.push_back("no pixel was shaded: see the counts under pixels");
}

/// Coverage only where a pixel was shaded: elsewhere there is no overlay that could take the rendered specular's place.
Assignment covering_shaded(Assignment assignment, const Surfaces& surfaces) {
    for (size_t i = 0; i < assignment.coverage.size(); ++i)
        if (surfaces.validity(i) != Validity::valid) assignment.coverage[i] = 0;
    return assignment;
}

Image validity_image(const Surfaces& surfaces, int width, int height) {
    Image image(width, height, 1);
    for (size_t i = 0; i < image.pixel_count(); ++i) *image.at(i) = static_cast<float>(surfaces.validity(i));
    return image;
}

void describe(const AovFrame& frame, FrameReport& report) {
    report.input = frame.file;
    report.width = frame.data_window.width, report.height = frame.data_window.height;
    for (const auto& [role, image] : frame.layers) report.roles.emplace_back(role_info(role).name);
    if (frame.camera) report.camera = frame.camera->source;
    report.notes = frame.notes;
    report.warnings = frame.warnings;
}

}  // namespace

FrameResult run_frame(const Job& job, const AovFrame& frame, const Look& look, const Assignment* given,
                      const Progress& progress) {
    FrameResult result;
    FrameReport& report = result.report;
    describe(frame, report);
    const bool difference = !look.old_shaders.empty();
    const Window& window = frame.data_window;
    if (given && (given->width != window.width || given->height != window.height))
        throw Error(ErrorCode::size_mismatch, "assign: the masks are " + std::to_string(given->width) + "x" +
                                                  std::to_string(given->height) + ", the frame is " +
                                                  std::to_string(window.width) + "x" + std::to_string(window.height));
    const Assignment assignment = given ? *given : assign_rules(frame, look.wardrobe.rules);
    const Surfaces surfaces = timed(report.seconds, "surface", [&] { return Surfaces(frame, assignment, job.surface); });
    count_pixels(surfaces, assignment, look, report);
    warn_of_tangents(look, surfaces, job.surface, report);
    result.validity = validity_image(surfaces, assignment.width, assignment.height);
    ShadedFrame old;
    timed(report.seconds, "shading", [&] {
        result.shaded = shade_dense(surfaces, assignment, look.shaders, part_of(progress, 0.0f, difference ? 0.5f : 1.0f));
        if (difference) old = shade_dense(surfaces, assignment, look.old_shaders, part_of(progress, 0.5f, 1.0f));
    });
    report.lookups = result.shaded.lookups + old.lookups;
    result.composite = timed(report.seconds, "composite", [&] {
        return composite(frame, covering_shaded(assignment, surfaces), result.shaded.overlay,
                         difference ? &old.overlay : nullptr, look.wardrobe.kd, job.composite);
    });
    return result;
}

Assignment assign_masks(const std::vector<Image>& masks) {
    Assignment assignment;
    assignment.width = masks.front().width, assignment.height = masks.front().height;
    const size_t pixels = masks.front().pixel_count();
    assignment.rule.assign(pixels, -1), assignment.coverage.assign(pixels, 0.0f), assignment.counts.assign(masks.size(), 0);
    for (size_t rule = 0; rule < masks.size(); ++rule) {
        if (masks[rule].width != assignment.width || masks[rule].height != assignment.height)
            throw Error(ErrorCode::size_mismatch, "assign: the masks differ in size");
        for (size_t i = 0; i < pixels; ++i) {
            const float coverage = *masks[rule].at(i);
            if (coverage > 0)
                assignment.rule[i] = static_cast<int16_t>(rule), assignment.coverage[i] = std::min(coverage, 1.0f);
        }
    }
    for (const int16_t rule : assignment.rule)
        if (rule >= 0) ++assignment.counts[static_cast<size_t>(rule)];
    return assignment;
}

}  // namespace burnish
