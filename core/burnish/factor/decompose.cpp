#include <burnish/factor/decompose.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/factor/fill_texels.h>
#include <burnish/factor/leading_products.h>
#include <burnish/factor/pair_grid.h>

#include <algorithm>
#include <array>

namespace burnish {
namespace {

/// A BRDF at all pairs of a grid.
struct PairValues {
    Eigen::MatrixXf known;
    std::array<Eigen::MatrixXf, 3> channels;

    PairValues(const PairGrid& grid, const Parametrization& parametrization, const PairFunction& f, float least_cosine) {
        const int count = static_cast<int>(grid.directions().size());
        known = Eigen::MatrixXf::Zero(count, count);
        channels.fill(known);
        for_each_index(count, [&](int column) {
            for (int row = 0; row < count; ++row) {
                const DirectionPair pair = parametrization.pair_of(grid.directions()[row], grid.directions()[column]);
                if (std::min(pair.a.z, pair.b.z) < least_cosine) continue;
                const Color3f value = f(pair);
                if (!is_finite(value)) throw Error(ErrorCode::bad_argument, "the BRDF to decompose is not finite everywhere");
                known(row, column) = 1;
                for (int channel = 0; channel < 3; ++channel) channels[channel](row, column) = value[channel];
            }
        });
    }
};

void check(const Parametrization& parametrization, const DecomposeSettings& settings) {
    constexpr int kMostTerms = 8;
    if (parametrization.factors.size() != 2 || parametrization.map_count() != 2 || !parametrization.pair_of)
        throw Error(ErrorCode::bad_argument,
                    "parametrisation " + parametrization.name +
                        " has no grid of two maps to decompose; use io or hd, or homomorphic factorisation");
    if (settings.terms < 1 || settings.terms > kMostTerms)
        throw Error(ErrorCode::bad_argument,
                    "expected 1 to 8 terms of a decomposition, found " + std::to_string(settings.terms));
}

/// The map of a term of which `columns` (one a channel) tells the texels that the grid has. The first term is one of values above zero.
FactorMap map_of(const PairGrid& grid, const std::array<Eigen::VectorXf, 3>& columns, bool is_first) {
    FactorMap map{grid.layout(), std::vector<Color3f>(grid.layout().texels())};
    Colors texels = Colors::Zero(grid.layout().texels(), 4);
    std::vector<char> known(grid.layout().texels());
    for (size_t i = 0; i < grid.texels().size(); ++i) {
        known[grid.texels()[i]] = true;
        for (int channel = 0; channel < 3; ++channel) {
            const float value = columns[channel][static_cast<Eigen::Index>(i)];
            texels(grid.texels()[i], channel) = is_first ? std::max(value, 0.0f) : value;
        }
    }
    fill_texels(grid.layout(), texels, std::move(known));
    for (size_t i = 0; i < map.texels.size(); ++i) map.texels[i] = {texels(i, 0), texels(i, 1), texels(i, 2)};
    return map;
}

/// Whichever sign leaves most of u above zero, for both.
void turn_upward(Products& products) {
    for (Eigen::Index term = 0; term < products.u.cols(); ++term)
        if (products.u.col(term).sum() < 0) {
            products.u.col(term) *= -1;
            products.v.col(term) *= -1;
        }
}

}  // namespace

Factors decompose(const Parametrization& parametrization, const PairFunction& f, const DecomposeSettings& settings,
                  const Progress& progress) {
    check(parametrization, settings);
    const PairGrid grid(parametrization, settings.size);
    progress.report("factor", 0);
    PairValues values(grid, parametrization, f, settings.least_cosine);
    progress.report("factor", 0.3f);
    std::array<Products, 3> products;
    for_each_index(3, [&](int channel) {
        HoledMatrix matrix{std::move(values.channels[channel]), values.known};
        products[channel] = settings.method == Decomposition::svd ? least_squares_products(matrix, settings.terms)
                                                                  : normalised_products(std::move(matrix), settings.terms);
        turn_upward(products[channel]);
    });
    Factors factors;
    factors.parametrization = &parametrization;
    for (int term = 0; term < settings.terms; ++term) {
        std::array<Eigen::VectorXf, 3> u, v;
        for (int channel = 0; channel < 3; ++channel)
            u[channel] = products[channel].u.col(term), v[channel] = products[channel].v.col(term);
        factors.terms.push_back({map_of(grid, u, term == 0), map_of(grid, v, term == 0)});
    }
    progress.report("factor", 1);
    return factors;
}

}  // namespace burnish
