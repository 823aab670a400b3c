// Factorisations of BRDFs by every method and parametrisation, with and without polish: time and error, prints CSV. Relative errors are
// to the value and 1e-5 of the mean, as logarithms are taken.
#include "cook_torrance.h"

#include <burnish/factor/brdf_samples.h>
#include <burnish/factor/decompose.h>
#include <burnish/factor/factor_error.h>
#include <burnish/factor/factorise.h>
#include <burnish/factor/prescale_search.h>
#include <burnish/material/library.h>
#include <burnish/material/material_brdf.h>
#include <burnish/material/measured/read_measured.h>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <map>

namespace {

using namespace burnish;

constexpr float kBias = 1e-5f;

/// A BRDF by name: the gold of Cook & Torrance, or what find_material takes.
PairFunction brdf_by_name(const std::string& name) {
    static const std::map<std::string, CookTorrance> known = {{"cook_torrance_0.2", {0.2f}},
                                                              {"cook_torrance_0.3", {0.3f}},
                                                              {"cook_torrance_0.2_diffuse", {0.2f, 0.1f}},
                                                              {"cook_torrance_0.3_diffuse", {0.3f, 0.1f}}};
    if (const auto found = known.find(name); found != known.end()) return found->second;
    return [brdf = MaterialBrdf(find_material(name))](const DirectionPair& pair) { return brdf(pair.b, pair.a); };
}

/// In 8 bits; 0 of several terms, which do not fit.
FactorError eight_bit_error(const Factors& factors, const std::vector<FactorSample>& samples) {
    if (factors.terms.size() > 1) return {};
    return factor_error(quantise(factors, best_prescale(factors, {}, samples)), samples, kBias);
}

struct Table {
    FactoriseSettings settings;
    BrdfSampling sampling;

    void row(const std::string& name, const std::string& parametrization, const char* method, int terms,
             const std::vector<FactorSample>& samples, const std::function<Factors()>& make) const {
        const auto start = std::chrono::steady_clock::now();
        const Factors factors = make();
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        const FactorError error = factor_error(factors, samples, kBias), rounded = eight_bit_error(factors, samples);
        std::printf("%s,%s,%s,%d,%zu,%.2f,%.4f,%.3f,%.4f,%.3f,%.4f,%.4f,%.4f\n", name.c_str(), parametrization.c_str(), method,
                    terms, samples.size(), seconds.count(), error.average_absolute, error.max_absolute, error.average_relative,
                    error.max_relative, error.rms, rounded.average_relative, rounded.rms);
        std::fflush(stdout);
    }

    void homomorphic(const std::string& name, const Parametrization& parametrization,
                     const std::vector<FactorSample>& samples) const {
        for (const int terms : {0, 1, 2, 3}) {
            FactoriseSettings own = settings;
            own.polish = terms > 0;
            own.terms = std::max(terms, 1);
            row(name, parametrization.name, own.polish ? "polished" : "homomorphic", own.terms, samples,
                [&] { return factorise(parametrization, samples, {}, own); });
        }
    }

    void decomposed(const std::string& name, const Parametrization& parametrization, const PairFunction& f,
                    const std::vector<FactorSample>& samples) const {
        for (const Decomposition method : {Decomposition::svd, Decomposition::normalised})
            for (const int terms : {1, 2, 3})
                row(name, parametrization.name, method == Decomposition::svd ? "svd" : "normalised", terms, samples, [&] {
                    return decompose(parametrization, f, {method, settings.size, terms, sampling.least_cosine});
                });
    }
};

}  // namespace

int main(int argc, char** argv) {
    Table table;
    std::vector<std::string> names = {"cook_torrance_0.2", "cook_torrance_0.3", "cook_torrance_0.2_diffuse",
                                      "cook_torrance_0.3_diffuse", "gold"},
                             by = {"pqp", "hd", "io"};
    std::vector<std::string> measured;
    CLI::App app("Factorisations of BRDFs: time and error, prints CSV.");
    app.add_option("brdfs", names, "cook_torrance_0.2, ..., or materials");
    app.add_option("--measured", measured, "measured files, by their own pairs");
    app.add_option("--by", by, "parametrisations");
    app.add_option("--size", table.settings.size, "texels a side of a disc");
    app.add_option("--grid", table.sampling.size, "texels a side of the discs that samples are taken at");
    app.add_option("--least-cosine", table.sampling.least_cosine);
    app.add_option("--smoothness", table.settings.smoothness);
    app.add_option("--iterations", table.settings.iterations);
    app.add_option("--tolerance", table.settings.tolerance);
    app.add_option("--measure", table.settings.measure, "0 relative, 1 display, 2 absolute");
    CLI11_PARSE(app, argc, argv);
    std::printf("brdf,by,method,terms,samples,seconds,avg abs,max abs,avg rel,max rel,rms,avg rel in 8 bits,rms in 8 bits\n");
    for (const std::string& parametrization_name : by) {
        const Parametrization& parametrization = parametrization_by_name(parametrization_name);
        for (const std::string& name : names) {
            const PairFunction f = brdf_by_name(name);
            const std::vector<FactorSample> samples = brdf_samples(parametrization, f, table.sampling);
            table.homomorphic(name, parametrization, samples);
            if (parametrization.factors.size() == 2) table.decomposed(name, parametrization, f, samples);
        }
        for (const std::string& file : measured)
            table.homomorphic(file, parametrization, measured_samples(*read_measured(file)));
    }
}
