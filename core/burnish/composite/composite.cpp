#include <burnish/composite/composite.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/composite/add_overlay.h>

namespace burnish {
namespace {

Color3f color(const Image& image, size_t pixel) {
    const float* c = image.at(pixel);
    return {c[0], c[1], c[2]};
}

void store(Image& image, size_t pixel, const Color3f& c) {
    float* out = image.at(pixel);
    out[0] = c.x, out[1] = c.y, out[2] = c.z;
}

/// Calls `work(pixel)` for every pixel, rows in parallel.
template <class Work>
void for_each_pixel(const Image& image, const Work& work) {
    const size_t width = static_cast<size_t>(image.width);
    for_each_index(image.height, [&](int y) {
        for (size_t pixel = y * width; pixel < (y + 1) * width; ++pixel) work(pixel);
    });
}

/// factor * (direct + indirect), absent layers counting as 0 and an absent factor as 1.
Image modulated_sum(const Image* direct, const Image* indirect, const Image* factor) {
    const Image& first = direct ? *direct : *indirect;
    Image sum = Image::unset(first.width, first.height, 3);
    for_each_pixel(sum, [&](size_t i) {
        Color3f c(0, 0, 0);
        if (direct) c += color(*direct, i);
        if (indirect) c += color(*indirect, i);
        store(sum, i, factor ? c * color(*factor, i) : c);
    });
    return sum;
}

/// The diffuse part: the renderer's passes, or kd/pi * E * albedo from an irradiance layer.
Image diffuse_part(const AovFrame& frame, const Image& kd) {
    const Image *direct = frame.find(Role::diffuse_direct), *indirect = frame.find(Role::diffuse_indirect);
    const Image* albedo = frame.find(Role::diffuse_albedo);
    if (direct || indirect) return modulated_sum(direct, indirect, frame.divided_by_albedo ? albedo : nullptr);
    const auto* irradiance = frame.find(Role::irradiance);
    if (!irradiance)
        throw Error(ErrorCode::missing_channel,
                    frame.label() +
                        ": no beauty and no diffuse light to put the overlay over (looked for beauty, diffuse_direct, "
                        "diffuse_indirect, irradiance). Name one with --channel beauty=LAYER");
    Image diffuse = modulated_sum(irradiance, nullptr, albedo);
    for_each_pixel(diffuse, [&](size_t i) { store(diffuse, i, color(diffuse, i) * color(kd, i) / kPi); });
    return diffuse;
}

const float* row_of(const Image* image, int y) { return image ? image->at(0, y) : nullptr; }

}  // namespace

Image rendered_specular(const AovFrame& frame) {
    const Image *direct = frame.find(Role::specular_direct), *indirect = frame.find(Role::specular_indirect);
    if (!direct && !indirect)
        throw Error(ErrorCode::missing_channel,
                    frame.label() +
                        ": no rendered specular to replace (looked for specular_direct, specular_indirect). "
                        "Name them with --channel specular_direct=LAYER, or use --mode add");
    const Image* albedo = frame.find(Role::specular_albedo);
    if (frame.divided_by_albedo && !albedo)
        throw Error(ErrorCode::missing_channel,
                    frame.label() +
                        ": the specular passes are divided by their colour, and the colour is missing. "
                        "Name it with --channel specular_albedo=LAYER");
    return modulated_sum(direct, indirect, frame.divided_by_albedo ? albedo : nullptr);
}

bool needs_kd(const AovFrame& frame) {
    return !frame.has(Role::beauty) && !frame.has(Role::diffuse_direct) && !frame.has(Role::diffuse_indirect);
}

Composite composite(const AovFrame& frame, const Cover& cover, Image overlay, const Image* old_overlay,
                    const CompositeSettings& settings) {
    const Image *beauty = frame.find(Role::beauty), *alpha = frame.find(Role::alpha), *mask = frame.find(Role::mask);
    if (settings.mode != CompositeMode::add) frame.layer(Role::beauty);
    Composite out;
    if (!beauty) out.diffuse = diffuse_part(frame, cover.kd);
    const Image& base = beauty ? *beauty : out.diffuse;
    const PixelVector<float>& replaced = cover.specular.empty() ? cover.overlay : cover.specular;
    const Image removed = settings.mode == CompositeMode::replace ? rendered_specular(frame) : Image();
    out.beauty = Image::unset(overlay.width, overlay.height, 4);
    out.overlay = std::move(overlay);
    for_each_index(out.overlay.height, [&](int y) {
        const size_t first = static_cast<size_t>(y) * out.overlay.width;
        const OverlayRow row{.overlay = out.overlay.at(first),
                             .old_overlay = settings.mode == CompositeMode::difference ? row_of(old_overlay, y) : nullptr,
                             .base = base.at(first),
                             .removed = removed.empty() ? nullptr : removed.at(first),
                             .coverage = &cover.overlay[first],
                             .replaced = &replaced[first],
                             .mask = row_of(mask, y),
                             .alpha = row_of(alpha, y),
                             .beauty = out.beauty.at(first)};
        add_overlay(row, settings.tint, settings.gain, static_cast<size_t>(out.overlay.width));
    });
    return out;
}

}  // namespace burnish
