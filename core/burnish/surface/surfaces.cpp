#include <burnish/surface/surfaces.h>

#include <burnish/base/parallel.h>
#include <burnish/surface/collect.h>
#include <burnish/surface/fetch.h>
#include <burnish/surface/uv_tangent.h>

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cstring>

namespace burnish {
namespace {

constexpr float kMinWidth = 1e-4f;  // narrowest lobe; below it a lobe is a mirror to float precision

Vec3f vec3(const Image& image, size_t pixel) {
    const float* v = image.at(pixel);
    return {v[0], v[1], v[2]};
}

void set(Vec3Planes& planes, size_t i, const Vec3f& v) { planes.x[i] = v.x, planes.y[i] = v.y, planes.z[i] = v.z; }

void resize(Vec3Planes& planes, size_t count) { planes.x.resize(count), planes.y.resize(count), planes.z.resize(count); }

/// Three channels of a layer at these pixels.
void copy(const Image& layer, const std::vector<uint32_t>& pixels, Vec3Planes& planes) {
    resize(planes, pixels.size());
    for (size_t i = 0; i < pixels.size(); ++i) {
        const float* v = layer.at(static_cast<size_t>(pixels[i]));
        planes.x[i] = v[0], planes.y[i] = v[1], planes.z[i] = v[2];
    }
}

/// Frame::along for planes: t <- t made perpendicular to n and unit; any tangent of n where they are parallel or t is zero.
void make_perpendicular(const Vec3Planes& normals, Vec3Planes& tangents) {
    constexpr float kParallel = 1e-12f;
    const size_t count = tangents.x.size();
    const float *nx = normals.x.data(), *ny = normals.y.data(), *nz = normals.z.data();
    float *x = tangents.x.data(), *y = tangents.y.data(), *z = tangents.z.data();
    for (size_t i = 0; i < count; ++i) {
        const float along = x[i] * nx[i] + y[i] * ny[i] + z[i] * nz[i];
        const float tx = x[i] - nx[i] * along, ty = y[i] - ny[i] * along, tz = z[i] - nz[i] * along;
        const float square = tx * tx + ty * ty + tz * tz, length = std::sqrt(std::max(square, kParallel));
        const float is_usable = square > kParallel ? 1.0f : 0.0f;
        x[i] = is_usable * tx / length, y[i] = is_usable * ty / length, z[i] = is_usable * tz / length;
    }
    for (size_t i = 0; i < count; ++i)
        if (x[i] == 0 && y[i] == 0 && z[i] == 0) set(tangents, i, Frame::around(normals[i]).t);
}

TangentSource resolve(TangentSource wanted, const AovFrame& frame) {
    if (wanted != TangentSource::automatic) return wanted;
    if (frame.has(Role::tangent)) return TangentSource::layer;
    return frame.has(Role::uv) ? TangentSource::uv : TangentSource::axis;
}

}  // namespace

Surfaces::Layers::Layers(const AovFrame& frame)
    : position(&frame.layer(Role::position)),
      normal(&frame.layer(Role::normal)),
      geometric_normal(frame.find(Role::geometric_normal)),
      depth(frame.find(Role::depth)),
      tangent(frame.find(Role::tangent)),
      roughness(frame.find(Role::roughness)),
      anisotropy(frame.find(Role::anisotropy)),
      rotation(frame.find(Role::rotation)),
      tint(frame.find(Role::tint)),
      weight(frame.find(Role::weight)) {}

Surfaces::Surfaces(const AovFrame& frame, const Assignment& assignment, const SurfaceSettings& settings)
    : m_frame(frame), m_assignment(assignment), m_settings(settings), m_layers(frame) {
    if (!frame.camera)
        throw Error(ErrorCode::missing_channel, frame.label() +
                                                    ": no camera, and none could be recovered from the position layer. "
                                                    "Give one in the shot file or with --camera FILE");
    m_eye = frame.camera->centre;
    m_settings.tangent = resolve(settings.tangent, frame);
    if (m_settings.tangent == TangentSource::layer) frame.layer(Role::tangent);
    if (m_settings.tangent == TangentSource::uv) frame.layer(Role::uv);
    classify_rows();
}

void Surfaces::classify_rows() {
    const int width = m_assignment.width, height = m_assignment.height;
    m_validity.resize(m_layers.position->pixel_count(), Validity::unassigned);
    m_counts.rule.resize(m_assignment.counts.size());
    m_margin_counts = m_counts;
    tbb::enumerable_thread_specific<PixelCounts> counts(m_counts), margins(m_counts);
    const int top = m_frame.margin_above - m_frame.shaded_above, bottom = m_frame.margin_below - m_frame.shaded_below;
    for_each_index(height - top - bottom, [&](int index) {
        const int y = index + top;
        const bool is_own = y >= m_frame.margin_above && y < height - m_frame.margin_below;
        const size_t first = static_cast<size_t>(y) * width;
        const PixelLayers layers{m_layers.position->at(first), m_layers.normal->at(first),
                                 m_layers.depth ? m_layers.depth->at(first) : nullptr, &m_assignment.rule[first]};
        classify(layers, {m_eye, m_settings.min_normal_length}, {&m_validity[first], static_cast<size_t>(width)},
                 is_own ? counts.local() : margins.local());
    });
    for (const PixelCounts& part : counts) m_counts += part;
    for (const PixelCounts& part : margins) m_margin_counts += part;
}

/// The directions tangents follow, from layer, UVs or the axis.
void Surfaces::fill_hints(SurfaceBatch& batch) const {
    const size_t count = batch.size();
    const Vec3f axis = m_settings.tangent_axis;
    const Vec3Planes& n = batch.n;
    resize(batch.t, count);
    for (size_t i = 0; i < count; ++i) batch.t.x[i] = axis.y * n.z[i] - axis.z * n.y[i];
    for (size_t i = 0; i < count; ++i) batch.t.y[i] = axis.z * n.x[i] - axis.x * n.z[i];
    for (size_t i = 0; i < count; ++i) batch.t.z[i] = axis.x * n.y[i] - axis.y * n.x[i];
    if (m_settings.tangent == TangentSource::axis) return;
    for (size_t i = 0; i < count; ++i) {
        const bool is_layer = m_settings.tangent == TangentSource::layer;
        const Vec3f hint =
            is_layer ? vec3(*m_layers.tangent, batch.pixel[i]) : uv_tangent(m_frame, batch.pixel[i]).value_or(batch.t[i]);
        set(batch.t, i, is_finite(hint) ? hint : Vec3f(0, 0, 0));
    }
}

void Surfaces::fill_tangents(SurfaceBatch& batch) const {
    fill_hints(batch);
    make_perpendicular(batch.n, batch.t);
}

/// The layer's where it is one that the viewer could see, else the shading normal.
void Surfaces::fill_geometric_normals(SurfaceBatch& batch) const {
    batch.ng = batch.n;
    for (size_t i = 0; i < batch.size(); ++i) {
        const Vec3f given = vec3(*m_layers.geometric_normal, batch.pixel[i]);
        if (is_finite(given) && given.length2() > 1e-6f && given.dot(batch.wo[i]) > 0) set(batch.ng, i, given.normalized());
    }
}

void Surfaces::fill_parameters(SurfaceBatch& batch) const {
    const auto scalar = [&](const Image* layer, float low, float high, std::vector<float>& plane, auto&& convert) {
        if (!layer) return;
        plane.reserve(batch.size());
        for (const uint32_t pixel : batch.pixel) {
            const float value = *layer->at(static_cast<size_t>(pixel));
            plane.push_back(convert(std::isfinite(value) ? std::clamp(value, low, high) : low));
        }
    };
    const bool is_alpha = m_settings.roughness_is_alpha;
    scalar(m_layers.roughness, 0, 1, batch.roughness, [&](float r) { return std::max(is_alpha ? r : r * r, kMinWidth); });
    scalar(m_layers.anisotropy, -1, 1, batch.anisotropy, [](float a) { return a; });
    scalar(m_layers.rotation, -1e3f, 1e3f, batch.rotation, [](float turns) { return 2 * kPi * turns; });
    scalar(m_layers.weight, 0, 1e3f, batch.weight, [](float w) { return w; });
    if (!m_layers.tint) return;
    for (const uint32_t pixel : batch.pixel) {
        const Vec3f tint = vec3(*m_layers.tint, pixel);
        batch.tint.push_back(is_finite(tint) ? tint : Vec3f(0, 0, 0));
    }
}

bool Surfaces::any_valid(size_t first, size_t count) const {
    static_assert(static_cast<int>(Validity::valid) == 0 && sizeof(Validity) == 1);
    const Validity* at = &m_validity[first];
    for (; count >= 8; at += 8, count -= 8) {
        uint64_t eight;
        std::memcpy(&eight, at, 8);
        constexpr uint64_t kOnes = 0x0101010101010101, kHighs = 0x8080808080808080;
        if ((eight - kOnes) & ~eight & kHighs) return true;  // some byte is 0
    }
    return std::find(at, at + count, Validity::valid) != at + count;
}

void Surfaces::list(const Window& tile, int rule, std::vector<uint32_t>& pixels) const {
    if (!has_rule(static_cast<size_t>(rule))) return;
    collect({m_validity.data(), m_assignment.rule.data(), static_cast<size_t>(m_assignment.width)}, tile, rule, pixels);
}

void Surfaces::gather(const Window& tile, int rule, SurfaceBatch& batch, const BatchNeeds& needs) const {
    batch.clear();
    list(tile, rule, batch.pixel);
    fill(batch, needs);
}

void Surfaces::fill(SurfaceBatch& batch, const BatchNeeds& needs) const {
    batch.band_start = static_cast<uint32_t>(m_frame.data_window.y) * static_cast<uint32_t>(m_assignment.width);
    fetch_unit(m_layers.normal->data.data(), batch.pixel, batch.n);
    fetch_views(m_layers.position->data.data(), m_eye, batch.pixel, batch.wo);
    if (needs.position) copy(*m_layers.position, batch.pixel, batch.p);
    if (needs.tangent) fill_tangents(batch);
    if (m_layers.geometric_normal) fill_geometric_normals(batch);
    fill_parameters(batch);
}

}  // namespace burnish
