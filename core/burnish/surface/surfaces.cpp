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

/// Valid pixels have no zero vectors; the floor keeps those whose square is none finite.
void normalise(Vec3Planes& planes) {
    const size_t count = planes.x.size();
    float *x = planes.x.data(), *y = planes.y.data(), *z = planes.z.data();
    for (size_t i = 0; i < count; ++i) {
        const float length = std::sqrt(std::max(x[i] * x[i] + y[i] * y[i] + z[i] * z[i], 1e-37f));
        x[i] /= length, y[i] /= length, z[i] /= length;
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

std::string_view validity_name(Validity validity) {
    static constexpr std::array<std::string_view, kValidityCount> names{
        "valid", "background", "not_finite", "zero_normal", "averaged_normal", "back_facing", "unassigned"};
    return names[static_cast<size_t>(validity)];
}

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
    const int width = m_layers.position->width, height = m_layers.position->height;
    m_validity.resize(m_layers.position->pixel_count(), Validity::unassigned);
    std::vector<Counts> counts(static_cast<size_t>(height));
    const int top = m_frame.margin_above - m_frame.shaded_above, bottom = m_frame.margin_below - m_frame.shaded_below;
    for_each_index(height - top - bottom, [&](int index) {
        const int y = index + top;
        const size_t row = static_cast<size_t>(y) * width;
        Counts& count = counts[static_cast<size_t>(y)];
        for (size_t pixel = row; pixel < row + width; ++pixel)
            ++count[static_cast<size_t>(m_validity[pixel] = classify(pixel))];
    });
    for (int y = m_frame.margin_above; y < height - m_frame.margin_below; ++y)
        for (size_t i = 0; i < m_counts.size(); ++i) m_counts[i] += counts[static_cast<size_t>(y)][i];
}

Validity Surfaces::classify(size_t pixel) const {
    const Vec3f p = vec3(*m_layers.position, pixel), n = vec3(*m_layers.normal, pixel);
    if (p == Vec3f(0, 0, 0) || (m_layers.depth && !(*m_layers.depth->at(pixel) < kMiss))) return Validity::background;
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) >= kMiss) return Validity::background;
    if (!is_finite(p) || !is_finite(n)) return Validity::not_finite;
    const float length = n.length();
    if (length < 1e-6f) return Validity::zero_normal;
    if (length < m_settings.min_normal_length) return Validity::averaged_normal;
    if (m_assignment.rule[pixel] < 0) return Validity::unassigned;
    return n.dot(m_eye - p) > 0 ? Validity::valid : Validity::back_facing;
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

void Surfaces::fill_geometry(SurfaceBatch& batch) const {
    const size_t count = batch.size();
    copy(*m_layers.position, batch.pixel, batch.p);
    copy(*m_layers.normal, batch.pixel, batch.n);
    normalise(batch.n);
    resize(batch.wo, count);
    for (size_t i = 0; i < count; ++i) batch.wo.x[i] = m_eye.x - batch.p.x[i];
    for (size_t i = 0; i < count; ++i) batch.wo.y[i] = m_eye.y - batch.p.y[i];
    for (size_t i = 0; i < count; ++i) batch.wo.z[i] = m_eye.z - batch.p.z[i];
    normalise(batch.wo);
    batch.ng = batch.n;
    for (size_t i = 0; m_layers.geometric_normal && i < count; ++i) {
        const Vec3f given = vec3(*m_layers.geometric_normal, batch.pixel[i]);
        if (is_finite(given) && given.length2() > 1e-6f && given.dot(batch.wo[i]) > 0) set(batch.ng, i, given.normalized());
    }
    fill_hints(batch);
    make_perpendicular(batch.n, batch.t);
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

void Surfaces::gather(const Window& tile, int rule, SurfaceBatch& batch) const {
    batch.clear();
    for (int y = tile.y; y < tile.y + tile.height; ++y) {
        const size_t row = static_cast<size_t>(y) * m_layers.position->width + tile.x;
        for (size_t pixel = row; pixel < row + tile.width; ++pixel)
            if (m_validity[pixel] == Validity::valid && m_assignment.rule[pixel] == rule)
                batch.pixel.push_back(static_cast<uint32_t>(pixel));
    }
    fill(batch);
}

void Surfaces::fill(SurfaceBatch& batch) const {
    fill_geometry(batch);
    fill_parameters(batch);
}

}  // namespace burnish
