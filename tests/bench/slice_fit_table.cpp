// Fits by slices of all MERL materials, as CSV: `--set sgd` on tables synthesised from the 100 published SGD rows, `--set nbrdf` on
// the 80 networks that stand in for the tables. Errors are those of V.5.3 (brdf_error.h); seconds are of one
// processor.
//
//     burnish_slice_fit_table --data FOLDER --set nbrdf --models sgd,sgd2,beckmann,ggx,abc > fits.csv     (sgd2: two lobes at most;
// published: no fit, the published SGD row against the network)
#include "merl_stand_ins.h"

#include <burnish/base/parallel.h>
#include <burnish/fit/slices/slice_fit.h>
#include <burnish/material/model.h>

#include <CLI/CLI.hpp>

#include <sys/resource.h>

#include <cmath>
#include <cstdio>

using namespace burnish;

namespace {

double processor_seconds() {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

void print_fit(const std::string& material, const std::string& name, const BrdfGrid& grid) {
    FitSettings settings;
    const bool two = name.ends_with("2");
    settings.model = model_by_name(two ? name.substr(0, name.size() - 1) : name);
    settings.max_lobes = two ? 2 : 1;
    const double start = processor_seconds();
    const SliceFit fit = fit_slices(grid, settings, Progress());
    const double seconds = processor_seconds() - start;
    const size_t lobes = fit.result.material.lobes.size();
    std::printf("%s,%s,%zu,%d,%.4e,%.4e,%.4e,%.4e,%.4e,%.3f,%.5f\n", material.c_str(), name.c_str(), lobes,
                fit.result.parameters, fit.error.overall(), fit.error.worst_channel(), fit.slices.overall(),
                fit.slices.worst_channel(), fit.one_lobe.overall(), seconds, lobes ? fit.result.material.lobes[0].mx : 0.0f);
    std::fflush(stdout);
    for (const std::string& note : fit.result.notes)
        std::fprintf(stderr, "%s, %s: %s\n", material.c_str(), name.c_str(), note.c_str());
}

/// How far the published SGD row of a material is from what the grid holds.
void print_published(const merl::Row& row, const BrdfGrid& grid) {
    Channels squares{};
    for (size_t j = 0; j < grid.cells().size(); ++j) {
        const Channels f = merl::sgd(row, grid.angles(grid.cells()[j]));
        for (int c = 0; c < 3; ++c) squares[c] += grid.cells()[j].weight * (f[c] - grid.f(c)[j]) * (f[c] - grid.f(c)[j]);
    }
    const BrdfError error = brdf_error(grid, Channels{std::sqrt(squares[0]), std::sqrt(squares[1]), std::sqrt(squares[2])});
    std::printf("%s,published,1,18,%.4e,%.4e,,,,,\n", row.material.c_str(), error.overall(), error.worst_channel());
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Fits by slices of the MERL materials"};
    std::string data, set = "nbrdf";
    std::vector<std::string> models{"sgd", "sgd2", "beckmann", "ggx", "abc"}, only;
    app.add_option("--data", data, "the folder with brdf_fits")->required();
    app.add_option("--set", set)->check(CLI::IsMember({"sgd", "nbrdf"}));
    app.add_option("--models", models)->delimiter(',');
    app.add_option("--only", only, "materials")->delimiter(',');
    CLI11_PARSE(app, argc, argv);

    const bool networks = set == "nbrdf";
    const auto rows = merl::read_rows(data + (networks ? "/brdf_fits/nbrdf_merl_80.csv" : "/brdf_fits/sgd_bagher2012_bbm.csv"));
    const auto published = merl::read_rows(data + "/brdf_fits/sgd_bagher2012_bbm.csv");
    const ThreadLimit one_core(1);
    std::puts(
        "material,model,lobes,parameters,error,worst_channel,slices_error,slices_worst_channel,one_lobe_error,seconds,width");
    for (const merl::Row& row : rows) {
        if (!only.empty() && std::find(only.begin(), only.end(), row.material) == only.end()) continue;
        const BrdfGrid grid({90, 90, 36, 2}, [&](const GridAngles& angles) -> std::optional<Channels> {
            return networks ? merl::network(row, angles) : merl::sgd(row, angles);
        });
        for (const std::string& model : models) {
            if (model != "published") print_fit(row.material, model, grid);
            for (const merl::Row& other : published)
                if (model == "published" && other.material == row.material) print_published(other, grid);
        }
    }
}
