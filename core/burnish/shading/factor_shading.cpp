#include <burnish/shading/factor_shading.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "burnish/shading/factor_shading.cpp"
#include <hwy/foreach_target.h>

#include <burnish/shading/factor_place_simd.h>

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {

/// What the pixels of a block come to, RGBA.
struct BlockColors {
    HWY_ALIGN float rgba[PlacedLookups::kPixels][4];
};

/// Multiplies by one factor. Texels are read one lookup after the other; compilers make vectors of the four channels.
HWY_INLINE void multiply(const float* texels, int stride, const PlacedLookups& at, size_t count, BlockColors& product) {
    for (size_t i = 0; i < count; ++i) {
        const float* above = texels + 4 * static_cast<ptrdiff_t>(at.texel[i]);
        const float *below = above + 4 * static_cast<ptrdiff_t>(stride), x = at.x[i], y = at.y[i];
        for (int k = 0; k < 4; ++k) {
            const float top = above[k] + (above[k + 4] - above[k]) * x, bottom = below[k] + (below[k + 4] - below[k]) * x;
            product.rgba[i][k] *= top + (bottom - top) * y;
        }
    }
}

/// Lookups of `count` pixels from `begin` on, those of each factor.
void place_block(const FactorShading& shading, const SurfaceBatch& batch, const Matrix33f& world_to_light, size_t begin,
                 size_t count, PlacedLookups* placed) {
    for (size_t i = 0; i < count; i += hn::Lanes(Lanes())) {
        const LitPixels pixels{turned(load(batch.n, begin + i), world_to_light),
                               turned(load(batch.wo, begin + i), world_to_light), shading.guide()};
        for (const FactorShading::Lookup& lookup : shading.lookups())
            place_lookups(shading.textures()[lookup.texture], direction_of(lookup, pixels), i, *placed++);
        placed -= shading.lookups().size();
    }
}

void shade_batch(const FactorShading& shading, const SurfaceBatch& batch, const Matrix33f& world_to_light,
                 std::span<Color3f> radiance) {
    PlacedLookups placed[FactorShading::kMostLookups];
    BlockColors product;
    for (size_t begin = 0; begin < batch.size(); begin += PlacedLookups::kPixels) {
        const size_t count = std::min(PlacedLookups::kPixels, batch.size() - begin);
        place_block(shading, batch, world_to_light, begin, count, placed);
        const auto sums = radiance.subspan(begin, count);
        std::ranges::fill(sums, Color3f(0, 0, 0));
        for (size_t term = 0; term < static_cast<size_t>(shading.terms()); ++term) {
            std::fill_n(product.rgba[0], 4 * count, 1.0f);
            for (size_t k = 0; k < shading.lookups().size(); ++k) {
                const FactorShading::Texture& texture = shading.textures()[shading.lookups()[k].texture];
                multiply(texture.rgba.data() + term * texture.term_floats, texture.stride, placed[k], count, product);
            }
            for (size_t i = 0; i < count; ++i) sums[i] += Color3f(product.rgba[i][0], product.rgba[i][1], product.rgba[i][2]);
        }
        for (Color3f& sum : sums) sum = {std::max(sum.x, 0.0f), std::max(sum.y, 0.0f), std::max(sum.z, 0.0f)};
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <burnish/base/error.h>
#include <burnish/light/filter/cube_faces.h>

namespace burnish {
namespace {

HWY_EXPORT(shade_batch);

constexpr std::string_view kVectorised[] = {"normal",    "view",          "reflection",
                                            "elevation", "dominant_half", "dominant_difference"};

FactorShading::Vectorised vectorised(const ProjectedDirection& direction) {
    return static_cast<FactorShading::Vectorised>(std::ranges::find(kVectorised, direction.name) - std::begin(kVectorised));
}

void append(const Color3f& c, std::vector<float>& rgba) { rgba.insert(rgba.end(), {c.x, c.y, c.z, 0}); }

/// Faces with a border a texel wide; beyond a corner there is no texel: its neighbour.
void append_cube(const FactorMap& map, std::vector<float>& rgba) {
    const int size = map.layout.size();
    const auto is_outside = [&](int i) { return i < 0 || i >= size; };
    for (int face = 0; face < 6; ++face)
        for (int y = -1; y <= size; ++y)
            for (int x = -1; x <= size; ++x) {
                const int beside = is_outside(x) && is_outside(y) ? std::clamp(x, 0, size - 1) : x;
                const CubeTexel texel = unfolded_texel(face, beside, y, size);
                append(map.texels[(texel.face * size + texel.y) * size + texel.x], rgba);
            }
}

FactorShading::Texture texture_of(const std::vector<FactorTerm>& terms, size_t map) {
    const DirectionMap& layout = terms[0][map].layout;
    const bool is_cube = layout.mapping() == Mapping::cube;
    const int rows = layout.height() == 1 ? 2 : 1;  // of what is there
    FactorShading::Texture texture{layout.mapping(), layout.size(), is_cube ? layout.size() + 2 : layout.width(), {}, 0};
    for (const FactorTerm& term : terms) {
        if (is_cube)
            append_cube(term[map], texture.rgba);
        else
            for (int row = 0; row < rows; ++row)
                for (const Color3f& c : term[map].texels) append(c, texture.rgba);
    }
    texture.term_floats = texture.rgba.size() / terms.size();
    return texture;
}

}  // namespace

FactorShading::FactorShading(const Factors& factors) : m_guide(factors.guide), m_terms(static_cast<int>(factors.terms.size())) {
    const Parametrization& parametrization = *factors.parametrization;
    if (parametrization.of != FactoredFunction::lighting)
        throw Error(ErrorCode::bad_argument, "maps of parametrisation '" + parametrization.name +
                                                 "' hold a BRDF, which shades nothing without a light; make maps of a material "
                                                 "under a light: burnish factor --material NAME --env FILE");
    if (parametrization.factors.size() > kMostLookups)
        throw Error(ErrorCode::bad_argument, "parametrisation '" + parametrization.name + "' has " +
                                                 std::to_string(parametrization.factors.size()) +
                                                 " factors; expected at most " + std::to_string(kMostLookups));
    for (const Factor& factor : parametrization.factors)
        m_lookups.push_back({factor.direction, vectorised(*factor.direction), factor.map});
    for (int map = 0; map < parametrization.map_count(); ++map)
        m_textures.push_back(texture_of(factors.terms, static_cast<size_t>(map)));
}

void FactorShading::shade(const SurfaceBatch& batch, const Matrix33f& world_to_light, std::span<Color3f> radiance) const {
    HWY_DYNAMIC_DISPATCH(shade_batch)(*this, batch, world_to_light, radiance);
}

}  // namespace burnish
#endif
