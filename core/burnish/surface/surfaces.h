// What each pixel of a frame knows about its surface: validity, and batches ready for shading.
#pragma once

#include <burnish/input/assign.h>
#include <burnish/input/frame.h>
#include <burnish/surface/classify.h>
#include <burnish/surface/surface_batch.h>

namespace burnish {

/// Where tangents come from; `automatic` takes the first of layer, uv and axis that the frame allows.
enum class TangentSource { automatic, layer, uv, axis };

struct SurfaceSettings {
    TangentSource tangent = TangentSource::automatic;
    Vec3f tangent_axis{0, 0, 1};      // for `axis`: t = axis x n, the radial tangent about this axis
    float min_normal_length = 0.3f;   // shorter averaged normals are not shaded
    bool roughness_is_alpha = false;  // roughness layer holds alpha instead of the artist's r (alpha = r^2)
};

class Surfaces {
public:
    /// Frame and assignment must outlive the surfaces. Needs P, N and the camera; throws Error(missing_channel).
    Surfaces(const AovFrame& frame, const Assignment& assignment, const SurfaceSettings& settings);

    /// Rows of the frame's margins count for nothing, and are valid only where they are to be shaded.
    Validity validity(size_t pixel) const { return m_validity[pixel]; }
    /// Whether any of `count` pixels from `first` on is valid; eight at a time, as frames are mostly asked where they are empty.
    bool any_valid(size_t first, size_t count) const;
    bool roughness_is_alpha() const { return m_settings.roughness_is_alpha; }
    const ValidityCounts& counts() const { return m_counts.validity; }
    /// Valid pixels per rule.
    const std::vector<size_t>& rule_counts() const { return m_counts.rule; }
    /// Whether any pixel that is to be shaded, those of margins included, is of the rule.
    bool has_rule(size_t rule) const { return m_counts.rule[rule] + m_margin_counts.rule[rule] > 0; }
    /// Where the tangents came from in the end: never `automatic`.
    TangentSource tangent_source() const { return m_settings.tangent; }
    /// Appends the valid pixels of `tile` assigned to `rule`, row by row.
    void list(const Window& tile, int rule, std::vector<uint32_t>& pixels) const;
    /// Collects them into `batch` (cleared first).
    void gather(const Window& tile, int rule, SurfaceBatch& batch, const BatchNeeds& needs = {}) const;
    /// Fills a batch that names valid pixels and holds nothing else yet.
    void fill(SurfaceBatch& batch, const BatchNeeds& needs = {}) const;

private:
    /// The frame's layers, looked up once; null where there is none.
    struct Layers {
        explicit Layers(const AovFrame& frame);
        const Image *position, *normal, *geometric_normal, *depth, *tangent;
        const Image *roughness, *anisotropy, *rotation, *tint, *weight;
    };

    void classify_rows();
    void fill_hints(SurfaceBatch& batch) const;
    void fill_tangents(SurfaceBatch& batch) const;
    void fill_geometric_normals(SurfaceBatch& batch) const;
    void fill_parameters(SurfaceBatch& batch) const;

    const AovFrame& m_frame;
    const Assignment& m_assignment;
    SurfaceSettings m_settings;
    Vec3f m_eye;
    Layers m_layers;
    PixelVector<Validity> m_validity;
    PixelCounts m_counts, m_margin_counts;
};

}  // namespace burnish
