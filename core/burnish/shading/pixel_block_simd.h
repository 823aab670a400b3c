// Internal. What `shading_point` is for one pixel, for a block of pixels at a time: frames in light axes and where the views
// lie in a table of taps. Lanes are pixels. Compiled once per instruction set.
#include <burnish/shading/batch_lanes_simd.h>
#include <burnish/shading/table_shading.h>

// Included anew for each instruction set.
#if defined(BURNISH_PIXEL_BLOCK_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef BURNISH_PIXEL_BLOCK_SIMD
#undef BURNISH_PIXEL_BLOCK_SIMD
#else
#define BURNISH_PIXEL_BLOCK_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {

/// Pixels in light axes, mirrored at the surface for transmission: reflecting `wo` then gives directions on the far side.
struct PixelBlock {
    static constexpr size_t kPixels = 32, kCorners = 1 << TapTable::kAxes;
    using Planes = float[3][kPixels];
    HWY_ALIGN Planes t, b, n, wo, ng, wo_local;
    HWY_ALIGN float corner_weight[kCorners][kPixels];
    HWY_ALIGN int32_t corner[kCorners][kPixels];  // nodes about the view, as offsets into the table's floats
    int corners = 1;
};

HWY_INLINE void store(const V3& v, size_t i, PixelBlock::Planes& planes) {
    const Lanes d;
    hn::StoreU(v.x, d, planes[0] + i), hn::StoreU(v.y, d, planes[1] + i), hn::StoreU(v.z, d, planes[2] + i);
}

struct Tangents {
    V3 t, b;
};

/// Frame::turned by the lobe's rotation or the pixels' own.
HWY_INLINE Tangents rotated(const LobeTable& lobe_table, const SurfaceBatch& batch, size_t i, const Tangents& f) {
    const Lanes d;
    HWY_ALIGN float cosine[8], sine[8];
    for (size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        const bool own = lobe_table.lobe.per_pixel.rotation && i + lane < batch.rotation.size();
        const float angle = own ? batch.rotation[i + lane] : lobe_table.lobe.rotation;
        cosine[lane] = std::cos(angle), sine[lane] = std::sin(angle);
    }
    const VF c = hn::Load(d, cosine), s = hn::Load(d, sine);
    return {f.t * c + f.b * s, f.b * c - f.t * s};
}

/// The nodes about a place in the table, and their weights.
HWY_INLINE void find_corners(const TapTable& table, const std::array<VF, TapTable::kAxes>& measures, size_t at,
                             PixelBlock& block) {
    const Lanes d;
    const IntLanes di;
    VF weight[PixelBlock::kCorners] = {constant(1)};
    VI node[PixelBlock::kCorners] = {hn::Zero(di)};
    int corners = 1;
    for (int a = 0; a < TapTable::kAxes; ++a) {
        const TapTable::Axis& axis = table.axes()[a];
        if (axis.count == 1) continue;
        const VF place = clamped(hn::Mul(hn::Sub(measures[a], constant(axis.low)), constant(axis.per_unit)),
                                 constant(static_cast<float>(axis.count - 1)));
        const VI low = hn::Min(hn::ConvertTo(di, place), hn::Set(di, axis.count - 2));
        const VF part = hn::Sub(place, hn::ConvertTo(d, low));
        for (int c = 0; c < corners; ++c) {
            weight[corners + c] = hn::Mul(weight[c], part), weight[c] = hn::Sub(weight[c], weight[corners + c]);
            node[c] = hn::Add(node[c], hn::Mul(low, hn::Set(di, axis.stride)));
            node[corners + c] = hn::Add(node[c], hn::Set(di, axis.stride));
        }
        corners *= 2;
    }
    block.corners = corners;
    for (int c = 0; c < corners; ++c) {
        hn::StoreU(weight[c], d, block.corner_weight[c] + at);
        hn::StoreU(hn::Mul(node[c], hn::Set(di, table.node_floats())), di, block.corner[c] + at);
    }
}

/// Pixels i and on of the batch, a vector of them, to entries `at` and on of the block.
HWY_INLINE void prepare_pixels(const LobeTable& lobe_table, const SurfaceBatch& batch, size_t i, size_t at, PixelBlock& block) {
    const TapTable& table = lobe_table.table;
    const V3 n = load(batch.n, i), wo = load(batch.wo, i);
    const bool isotropic = table.axes()[1].count == 1;
    Tangents f;
    f.t = tangent_along(n, isotropic ? wo : load(batch.t, i)), f.b = cross(n, f.t);
    VF x = dot(wo, f.t), y = dot(wo, f.b), z = dot(wo, n);
    if (!isotropic) {
        f = rotated(lobe_table, batch, i, f);
        x = dot(wo, f.t), y = dot(wo, f.b);
    }
    const VF side = constant(table.side_sign()), far = constant(table.side_sign() - 1);
    store(turned(f.t, lobe_table.world_to_light), at, block.t), store(turned(f.b, lobe_table.world_to_light), at, block.b);
    store(turned(n * side, lobe_table.world_to_light), at, block.n);
    store(turned(wo + n * hn::Mul(far, z), lobe_table.world_to_light), at, block.wo);
    store(turned(load(batch.geometric_normal(), i) * side, lobe_table.world_to_light), at, block.ng);
    store({x, y, z}, at, block.wo_local);

    const VF cos_o = clamped(z, constant(1)), one = constant(1);
    const VF stretched_x = hn::Mul(x, constant(table.azimuth_stretch()));
    const VF stretched_y = hn::Mul(y, constant(1 / table.azimuth_stretch()));
    const VF a = hn::Div(stretched_y, hn::Max(hn::Add(hn::Abs(stretched_x), hn::Abs(stretched_y)), constant(1e-30f)));
    const bool rough = lobe_table.lobe.per_pixel.roughness && !batch.roughness.empty();
    find_corners(table,
                 {hn::Sub(hn::Sqrt(hn::Sub(one, cos_o)), hn::Sqrt(cos_o)),
                  hn::IfThenElse(hn::Lt(x, hn::Zero(Lanes())), hn::Sub(constant(2), a), a),
                  hn::Sqrt(rough ? load(batch.roughness, i) : constant(table.width()))},
                 at, block);
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();
#endif
