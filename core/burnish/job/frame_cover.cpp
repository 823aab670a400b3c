#include <burnish/job/frame_cover.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/composite/resolve.h>

#include <algorithm>

namespace burnish {
namespace {

/// Diffuse reflectance by look and, of valid pixels, by the angle they are seen under; black where there is no look.
Image kd_image(const Surfaces& surfaces, const Assignment& assignment, const std::vector<DiffuseReflectance>& kd) {
    Image image(assignment.width, assignment.height, 3);
    const auto width = static_cast<size_t>(assignment.width);
    const auto set = [&](size_t pixel, float cos_o) {
        const Color3f c = kd[static_cast<size_t>(assignment.rule[pixel])].at(cos_o);
        std::copy_n(&c.x, 3, image.at(pixel));
    };
    for_each_index(assignment.height, [&](int y) {
        SurfaceBatch seen;
        for (size_t i = static_cast<size_t>(y) * width; i < (static_cast<size_t>(y) + 1) * width; ++i) {
            if (assignment.rule[i] < 0) continue;
            const bool turns = kd[static_cast<size_t>(assignment.rule[i])].depends_on_view();
            if (turns && surfaces.validity(i) == Validity::valid)
                seen.pixel.push_back(static_cast<uint32_t>(i));
            else
                set(i, 1.0f);
        }
        if (seen.size() == 0) return;
        surfaces.fill(seen, {.position = false, .tangent = false});
        for (size_t k = 0; k < seen.size(); ++k) set(seen.pixel[k], seen.n[k].dot(seen.wo[k]));
    });
    return image;
}

/// 1 where there is a surface, shaded or not.
PixelVector<float> surface_cover(const Surfaces& surfaces, size_t samples) {
    PixelVector<float> cover(samples);
    for (size_t i = 0; i < samples; ++i) cover[i] = surfaces.validity(i) == Validity::background ? 0.0f : 1.0f;
    return cover;
}

/// The frame's alpha in place of the count of samples, which comes in steps.
void take_alpha(const AovFrame& frame, Cover& cover) {
    const Image& alpha = frame.layer(Role::alpha);
    for (size_t i = 0; i < cover.overlay.size(); ++i)
        cover.overlay[i] = std::clamp(*alpha.at(i), 0.0f, 1.0f) * cover.specular[i];
}

void resolve(const Resolver& resolver, const PixelVector<float>& coverage, ShadedFrame& shaded) {
    if (shaded.overlay.empty()) return;
    shaded.overlay = resolver.mean(shaded.overlay, coverage);
    if (!shaded.samples.empty()) shaded.samples = resolver.sum(shaded.samples);
    // The most it can be: as if all samples erred the same way.
    if (!shaded.standard_error.empty()) shaded.standard_error = resolver.mean(shaded.standard_error, coverage);
}

}  // namespace

void cover_shaded(const Surfaces& surfaces, Assignment& assignment) {
    for_each_index(assignment.height, [&](int y) {
        const size_t begin = static_cast<size_t>(y) * assignment.width;
        for (size_t i = begin; i < begin + assignment.width; ++i)
            if (surfaces.validity(i) != Validity::valid) assignment.coverage[i] = 0;
    });
}

Cover pixel_cover(const AovFrame& frame, const Surfaces& surfaces, Assignment& assignment,
                  const std::vector<DiffuseReflectance>& kd) {
    Cover cover;
    if (needs_kd(frame)) cover.kd = kd_image(surfaces, assignment, kd);
    cover.overlay = std::move(assignment.coverage);
    return cover;
}

PixelFilter pixel_filter(const AntialiasSettings& settings, const AovFrame& frame) {
    return settled(settings.filter, frame.renderer);
}

Cover resolve_samples(const AntialiasSettings& settings, const AovFrame& frame, const AovFrame& fine, const Surfaces& surfaces,
                      const Assignment& assignment, const std::vector<DiffuseReflectance>& kd, FrameResult& result,
                      ShadedFrame& old) {
    const Resolver resolver(sample_grid(frame, fine), pixel_filter(settings, frame), fine.data_window, frame.data_window);
    Cover cover = resolver.cover(surfaces, assignment.coverage);
    if (settings.coverage == EdgeCoverage::alpha) take_alpha(frame, cover);
    if (needs_kd(frame))
        cover.kd = resolver.mean(kd_image(surfaces, assignment, kd), surface_cover(surfaces, assignment.coverage.size()));
    resolve(resolver, assignment.coverage, result.shaded);
    resolve(resolver, assignment.coverage, old);
    if (!result.validity.empty()) result.validity = resolver.least(result.validity, static_cast<float>(Validity::background));
    return cover;
}

}  // namespace burnish
