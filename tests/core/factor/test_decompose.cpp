// Decompositions of functions of known rank, and the samples that BRDFs are factored from.
#include <burnish/base/error.h>
#include <burnish/factor/brdf_samples.h>
#include <burnish/factor/decompose.h>
#include <burnish/factor/factor_error.h>
#include <burnish/factor/leading_products.h>

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr DecomposeSettings kSmall{Decomposition::svd, 12, 1, 0};

/// The rank of its matrix over (wi, wo) is `rank`, 1 to 3.
PairFunction of_rank(int rank) {
    return [rank](const DirectionPair& pair) {
        Color3f f = Color3f(2, 3, 4) * ((1 + pair.a.z) * (2 - pair.b.z));
        if (rank > 1) f += Color3f(0.3f, 0.2f, 0.1f) * (pair.a.x * pair.b.x);
        if (rank > 2) f += Color3f(0.02f, 0.03f, 0.01f) * (pair.a.y * pair.b.y);
        return f;
    };
}

double error_of(Decomposition method, int rank, int terms) {
    const Parametrization& io = parametrization_by_name("io");
    DecomposeSettings settings = kSmall;
    settings.method = method, settings.terms = terms;
    const auto samples = brdf_samples(io, of_rank(rank), {settings.size, 0});
    return factor_error(decompose(io, of_rank(rank), settings), samples).max_relative;
}

TEST(Decompose, TakesAsManyTermsAsTheRank) {
    EXPECT_LT(error_of(Decomposition::svd, 1, 1), 1e-4);
    EXPECT_LT(error_of(Decomposition::svd, 2, 2), 1e-4);
    EXPECT_LT(error_of(Decomposition::svd, 3, 3), 1e-4);
    EXPECT_GT(error_of(Decomposition::svd, 2, 1), 1e-2);
    EXPECT_GT(error_of(Decomposition::svd, 3, 2), 1e-3);
}

TEST(Decompose, IsExactOfOneProductWhenNormalised) {
    EXPECT_LT(error_of(Decomposition::normalised, 1, 1), 1e-5);
    EXPECT_GT(error_of(Decomposition::normalised, 2, 1), 1e-2);
    EXPECT_LT(error_of(Decomposition::normalised, 2, 2), error_of(Decomposition::normalised, 2, 1));
}

TEST(Decompose, FindsSingularValuesInOrder) {
    // Diagonal: its singular values are 5, 3, 2, 1, its vectors the axes.
    const Eigen::MatrixXf known = Eigen::MatrixXf::Ones(4, 4);
    const Products found = least_squares_products({Eigen::Vector4f(2, 5, 1, 3).asDiagonal(), known}, 2);
    EXPECT_NEAR(found.u.col(0).squaredNorm(), 5, 1e-3f);
    EXPECT_NEAR(found.v.col(1).squaredNorm(), 3, 1e-3f);
    EXPECT_NEAR(found.u(1, 0) * found.v(1, 0), 5, 1e-3f);
    EXPECT_NEAR(found.u(3, 1) * found.v(3, 1), 3, 1e-3f);
}

TEST(Decompose, SeesThroughHoles) {
    // u v^T with every seventh value missing: what is there tells the rest.
    const Eigen::VectorXf u = Eigen::VectorXf::LinSpaced(20, 1, 3), v = Eigen::VectorXf::LinSpaced(15, 2, 0.5f);
    Eigen::MatrixXf known = Eigen::MatrixXf::Ones(20, 15);
    for (int i = 0; i < known.size(); i += 7) known.data()[i] = 0;
    const Eigen::MatrixXf whole = u * v.transpose();
    const Products found = least_squares_products({known.cwiseProduct(whole), known}, 1);
    EXPECT_LT((found.u * found.v.transpose() - whole).cwiseAbs().maxCoeff(), 0.01f * whole.maxCoeff());
}

TEST(Decompose, WorksByHalfAndDifferenceToo) {
    const Parametrization& hd = parametrization_by_name("hd");
    const PairFunction f = [&](const DirectionPair& pair) {
        const Vec3f h = hd.factors[0].direction->project(pair, {}), d = hd.factors[1].direction->project(pair, {});
        return Color3f(1, 2, 3) * ((1 + h.z * h.z) * (3 - d.z));
    };
    const auto samples = brdf_samples(hd, f, {12, 0.05f});
    for (const Decomposition method : {Decomposition::svd, Decomposition::normalised}) {
        const Factors factors = decompose(hd, f, {method, 12, 1, 0.05f});
        EXPECT_LT(factor_error(factors, samples).average_relative, method == Decomposition::svd ? 0.01 : 0.05);
    }
}

TEST(Decompose, RefusesWhatHasNoGridOfTwoMaps) {
    for (const char* name : {"pqp", "nr"}) EXPECT_THROW(decompose(parametrization_by_name(name), of_rank(1), kSmall), Error);
    const Parametrization& io = parametrization_by_name("io");
    EXPECT_THROW(decompose(io, of_rank(1), {Decomposition::svd, 12, 0, 0}), Error);
    EXPECT_THROW(decompose(io, of_rank(1), {Decomposition::svd, 2, 1, 0}), Error);
    EXPECT_THROW(decompose(
                     io, [](const DirectionPair&) { return Color3f(std::nanf("")); }, kSmall),
                 Error);
}

TEST(BrdfSamples, TouchEveryTexel) {
    // Half vectors near the horizon belong to pairs of nearly the same directions alone, which lie between texels.
    for (const auto& [name, least] : {std::pair("io", 0.0f), {"hd", 0.35f}, {"pqp", 0.0f}}) {
        const Parametrization& parametrization = parametrization_by_name(name);
        Factors touched = uniform_factors(parametrization, Mapping::double_parabolic, 12, Color3f(0));
        const auto samples = brdf_samples(parametrization, of_rank(1), {12, 0});
        for (const FactorSample& sample : samples) {
            EXPECT_EQ(sample.value, of_rank(1)(sample.pair));
            for (const Factor& factor : parametrization.factors) {
                FactorMap& map = touched.terms[0][factor.map];
                const BlendedTexels blend = map.layout.lookup(factor.direction->project(sample.pair, {}));
                for (int i = 0; i < 4; ++i) map.texels[blend.texel[i]] += Color3f(blend.weight[i]);
            }
        }
        for (const FactorMap& map : touched.terms[0])
            for (int texel = 0; texel < map.layout.texels(); ++texel)
                if (map.layout.direction(texel).z >= least) {
                    EXPECT_GT(map.texels[texel].x, 0.5f) << name << " " << texel;
                }
    }
    EXPECT_THROW(brdf_samples(parametrization_by_name("nr"), of_rank(1)), Error);
}

/// Three pairs, one of them through the sheet.
class ThreePairs : public MeasuredBrdf {
public:
    explicit ThreePairs(bool is_isotropic) : m_is_isotropic(is_isotropic) {}
    Color3f eval(const Vec3f&, const Vec3f&) const override { return Color3f(1); }
    bool is_isotropic() const override { return m_is_isotropic; }
    bool transmits() const override { return true; }
    std::vector<BrdfSample> samples() const override {
        return {{{0.6f, 0, 0.8f}, {0, 0.6f, 0.8f}, Color3f(1, 2, 3)},
                {{0, 0, 1}, {0.8f, 0, 0.6f}, Color3f(4, 5, 6)},
                {{0, 0, 1}, {0.8f, 0, -0.6f}, Color3f(9)}};
    }

private:
    bool m_is_isotropic;
};

TEST(BrdfSamples, TurnWhatIsMeasuredOfIsotropicMaterials) {
    const auto once = measured_samples(ThreePairs(false), 8), turned = measured_samples(ThreePairs(true), 8);
    ASSERT_EQ(once.size(), 2u);
    EXPECT_EQ(once[0].pair.a, Vec3f(0, 0.6f, 0.8f));
    EXPECT_EQ(once[0].pair.b, Vec3f(0.6f, 0, 0.8f));
    ASSERT_EQ(turned.size(), 16u);
    for (size_t i = 0; i < turned.size(); ++i) {
        const FactorSample& original = once[i / 8];
        EXPECT_EQ(turned[i].value, original.value);
        EXPECT_NEAR(turned[i].pair.a.dot(turned[i].pair.b), original.pair.a.dot(original.pair.b), 1e-6f);
        EXPECT_EQ(turned[i].pair.a.z, original.pair.a.z);
    }
    EXPECT_GT((turned[0].pair.a - turned[4].pair.a).length(), 1.0f);  // half a turn apart
}

}  // namespace
}  // namespace burnish
