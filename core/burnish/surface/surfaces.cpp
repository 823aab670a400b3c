#include <burnish/surface/surfaces.h>

#include <burnish/base/parallel.h>
#include <burnish/surface/uv_tangent.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kMiss = 1e9f;       // renderers write 1e10, 1e30 or infinity where no surface was hit
constexpr float kMinWidth = 1e-4f;  // narrowest lobe; below it a lobe is a mirror to float precision

Vec3f vec3(const Image& image, size_t pixel) {
    const float* v = image.at(pixel);
    return {v[0], v[1], v[2]};
}

TangentSource resolve(TangentSource wanted, const AovFrame& frame) {
    if (wanted != TangentSource::automatic) return wanted;
    if (frame.has(Role::tangent)) return TangentSource::layer;
    return frame.has(Role::uv) ? TangentSource::uv : TangentSource::axis;
}

}  // namespace

std::string_view validity_name(Validity validity) {
    static constexpr std::array<std::string_view, kValidityCount> names{
        "valid", "background", "not_finite", "zero_normal", "averaged_normal", "back_facing", "unassigned"};
    return names[static_cast<size_t>(validity)];
}

Surfaces::Surfaces(const AovFrame& frame, const Assignment& assignment, const SurfaceSettings& settings)
    : m_frame(frame),
      m_assignment(assignment),
      m_settings(settings),
      m_position(&frame.layer(Role::position)),
      m_normal(&frame.layer(Role::normal)) {
    if (!frame.camera)
        throw Error(ErrorCode::missing_channel, frame.label() +
                                                    ": no camera, and none could be recovered from the position layer. "
                                                    "Give one in the shot file or with --camera FILE");
    m_eye = frame.camera->centre;
    m_settings.tangent = resolve(settings.tangent, frame);
    if (m_settings.tangent == TangentSource::layer) frame.layer(Role::tangent);
    if (m_settings.tangent == TangentSource::uv) frame.layer(Role::uv);
    m_validity.resize(m_position->pixel_count());
    for_each_index(m_position->height, [&](int y) {
        const size_t row = static_cast<size_t>(y) * m_position->width;
        for (size_t pixel = row; pixel < row + m_position->width; ++pixel) m_validity[pixel] = classify(pixel);
    });
    for (const Validity validity : m_validity) ++m_counts[static_cast<size_t>(validity)];
}

Validity Surfaces::classify(size_t pixel) const {
    const Vec3f p = vec3(*m_position, pixel), n = vec3(*m_normal, pixel);
    const Image* depth = m_frame.find(Role::depth);
    if (p == Vec3f(0, 0, 0) || (depth && !(*depth->at(pixel) < kMiss))) return Validity::background;
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) >= kMiss) return Validity::background;
    if (!is_finite(p) || !is_finite(n)) return Validity::not_finite;
    const float length = n.length();
    if (length < 1e-6f) return Validity::zero_normal;
    if (length < m_settings.min_normal_length) return Validity::averaged_normal;
    if (m_assignment.rule[pixel] < 0) return Validity::unassigned;
    return n.dot(m_eye - p) > 0 ? Validity::valid : Validity::back_facing;
}

Vec3f Surfaces::tangent(const Vec3f& n, size_t pixel) const {
    Vec3f hint = m_settings.tangent_axis.cross(n);
    if (m_settings.tangent == TangentSource::layer) hint = vec3(m_frame.layers.at(Role::tangent), pixel);
    if (m_settings.tangent == TangentSource::uv) hint = uv_tangent(m_frame, pixel).value_or(hint);
    return Frame::along(n, is_finite(hint) ? hint : Vec3f(0, 0, 0)).t;
}

void Surfaces::append(size_t pixel, SurfaceBatch& batch) const {
    const Vec3f p = vec3(*m_position, pixel), n = vec3(*m_normal, pixel).normalized();
    const Vec3f wo = (m_eye - p).normalized();
    Vec3f ng = n;
    if (const Image* layer = m_frame.find(Role::geometric_normal)) {
        const Vec3f given = vec3(*layer, pixel);
        if (is_finite(given) && given.length2() > 1e-6f && given.dot(wo) > 0) ng = given.normalized();
    }
    batch.pixel.push_back(static_cast<uint32_t>(pixel));
    batch.p.push_back(p), batch.n.push_back(n), batch.ng.push_back(ng);
    batch.t.push_back(tangent(n, pixel)), batch.wo.push_back(wo);

    const auto scalar = [&](Role role, float low, float high, std::vector<float>& plane, auto&& convert) {
        if (const Image* layer = m_frame.find(role)) {
            const float value = *layer->at(pixel);
            plane.push_back(convert(std::isfinite(value) ? std::clamp(value, low, high) : low));
        }
    };
    const bool is_alpha = m_settings.roughness_is_alpha;
    scalar(Role::roughness, 0, 1, batch.roughness, [&](float r) { return std::max(is_alpha ? r : r * r, kMinWidth); });
    scalar(Role::anisotropy, -1, 1, batch.anisotropy, [](float a) { return a; });
    scalar(Role::rotation, -1e3f, 1e3f, batch.rotation, [](float turns) { return 2 * kPi * turns; });
    scalar(Role::weight, 0, 1e3f, batch.weight, [](float w) { return w; });
    if (const Image* layer = m_frame.find(Role::tint)) {
        const Vec3f tint = vec3(*layer, pixel);
        batch.tint.push_back(is_finite(tint) ? tint : Vec3f(0, 0, 0));
    }
}

void Surfaces::gather(const Window& tile, int rule, SurfaceBatch& batch) const {
    batch.clear();
    for (int y = tile.y; y < tile.y + tile.height; ++y)
        for (int x = tile.x; x < tile.x + tile.width; ++x) {
            const size_t pixel = static_cast<size_t>(y) * m_position->width + x;
            if (m_validity[pixel] == Validity::valid && m_assignment.rule[pixel] == rule) append(pixel, batch);
        }
}

}  // namespace burnish
