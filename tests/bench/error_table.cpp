// The error model's table: prints core/burnish/plan/error_table.json.
//
//     burnish_error_table --lights-from rooitou_park_1k.hdr,lebombo_1k.hdr > core/burnish/plan/error_table.json
//
// `--only ESTIMATOR --of TABLE` measures that one, under the same lights, and prints the table with its columns new. `--check` prints how far the table that is compiled in is off, for lobes between its own and lights that it was not made from:
//
//     burnish_error_table --check --lights 1 --seed 201 --lights-from studio_small_03_1k.hdr,st_fagans_interior_1k.hdr,...
#include "error_cases.h"
#include "estimator_names.h"
#include "sparse_errors.h"

#include <burnish/base/json_fields.h>
#include <burnish/material/library.h>
#include <burnish/plan/error_model.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <optional>

using namespace burnish;
using nlohmann::json;

namespace {

/// Mean of values, and how far each is from the mean of the others: root mean square.
struct Prediction {
    double mean = 0, deviation = 0;
};

Prediction left_out(const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    Prediction found;
    for (const double value : values) found.mean += value / count;
    for (const double value : values) found.deviation += std::pow((value - found.mean) * count / std::max(1.0, count - 1), 2);
    found.deviation = std::sqrt(found.deviation / count);
    return found;
}

double rounded(double db) { return std::round(db * 10) / 10; }

std::string name_of(const Configuration& configuration) {
    for (const auto& [name, kind] : kEstimators)
        if (kind == configuration.estimator) return name + " " + std::to_string(configuration.samples);
    return "?";
}

/// Which configurations are measured, and the table that holds the others: null where all are.
struct Making {
    std::vector<Configuration> measured = configurations();
    json old;

    bool measures(const Configuration& configuration) const { return std::ranges::count(measured, configuration) > 0; }
    /// Its place in the table that is there; none: it is not part of it.
    std::optional<size_t> old_column(const Configuration& configuration) const {
        if (old.is_null()) return {};
        const json& names = old.at("configurations");
        const auto found = std::ranges::find(names, json(name_of(configuration)));
        return found == names.end() ? std::nullopt : std::optional(static_cast<size_t>(found - names.begin()));
    }
    /// Those of the new table, in their order.
    std::vector<Configuration> columns() const {
        std::vector<Configuration> all;
        for (const Configuration& each : configurations())
            if (measures(each) || old_column(each)) all.push_back(each);
        return all;
    }
};

/// One lobe's cases, a light each; `place` of the lobe in the table.
json lobe_entry(const LobeClass& lobe, size_t place, std::span<const ErrorCase> cases, const Making& making) {
    json entry = {{"tail", lobe.tail == LobeTail::gaussian ? "gaussian" : "long"},
                  {"aspect", to_json_number(lobe.aspect)},
                  {"m", to_json_number(lobe.m)}};
    for (const Configuration& configuration : making.columns()) {
        if (!making.measures(configuration)) {
            for (const char* field : {"gain", "deviation"})
                entry[field].push_back(making.old.at("lobes").at(place).at(field).at(*making.old_column(configuration)));
            continue;
        }
        std::vector<double> gains;
        for (const ErrorCase& one : cases) gains.push_back(one.gain(configuration));
        const Prediction found = left_out(gains);
        entry["gain"].push_back(rounded(found.mean)), entry["deviation"].push_back(rounded(found.deviation));
    }
    return entry;
}

json sparse_entries(const std::vector<NamedLight>& lights, const Progress& progress) {
    json entries = json::array();
    for (const auto& [safety, psnr_db] : measure_sparse_errors(lights, progress)) {
        const Prediction found = left_out(psnr_db);
        entries.push_back({{"safety", to_json_number(safety)},
                           {"psnr", json::array({rounded(found.mean)})},
                           {"deviation", json::array({rounded(found.deviation)})}});
    }
    return entries;
}

/// One entry a line.
void print_list(const char* name, const json& entries, const char* end) {
    std::printf("  \"%s\": [\n", name);
    for (size_t i = 0; i < entries.size(); ++i)
        std::printf("    %s%s\n", entries[i].dump().c_str(), i + 1 < entries.size() ? "," : "");
    std::printf("  ]%s\n", end);
}

void print_table(const std::vector<NamedLight>& lights, const Making& making, const Progress& progress) {
    const std::vector<LobeClass> classes = lobe_classes();
    std::vector<NamedLobe> lobes;
    for (const LobeClass& one : classes) lobes.push_back({"", lobe_of(one)});
    std::vector<Configuration> shaded = making.measured;
    if (!making.measures(kProbe)) shaded.push_back(kProbe);
    const std::vector<ErrorCase> cases = measure_errors(lobes, lights, shaded, part_of(progress, 0, 0.9f));
    json entries = json::array(), names = json::array(), light_names = json::array();
    for (size_t i = 0; i < classes.size(); ++i)
        entries.push_back(lobe_entry(classes[i], i, std::span(cases).subspan(i * lights.size(), lights.size()), making));
    for (const Configuration& configuration : making.columns()) names.push_back(name_of(configuration));
    for (const NamedLight& light : lights) light_names.push_back(light.name);
    std::printf("{\n  \"made_by\": \"burnish_error_table\",\n  \"lights\": %s,\n  \"configurations\": %s,\n",
                light_names.dump().c_str(), names.dump().c_str());
    print_list("lobes", entries, ",");
    print_list("sparse", making.old.is_null() ? sparse_entries(lights, part_of(progress, 0.9f, 1)) : making.old.at("sparse"),
               "");
    std::printf("}\n");
}

/// The configurations of one estimator alone; the others stay as `file` has them.
Making only(const std::string& estimator, const std::string& file) {
    Making making;
    std::ifstream stream(file);
    making.old = json::parse(stream);
    std::erase_if(making.measured, [&](const Configuration& one) { return one.estimator != kEstimators.at(estimator); });
    return making;
}

std::vector<NamedLobe> lobes_to_check() {
    std::vector<NamedLobe> lobes;
    for (const LobeTail tail : {LobeTail::gaussian, LobeTail::long_tail})
        for (const LobeClass& one : {LobeClass{tail, 1, 0.03f}, {tail, 1, 0.15f}, {tail, 1, 0.3f}, {tail, 4, 0.06f}}) {
            const std::string name = tail == LobeTail::gaussian ? "beckmann " : "ggx ";
            lobes.push_back({name + std::to_string(one.m), lobe_of(one)});
        }
    for (const char* name : {"merl:brass", "merl:gold-metallic-paint", "merl:blue-rubber"})
        lobes.push_back({name, find_material(name).lobes[0]});
    return lobes;
}

void print_check(const std::vector<NamedLight>& lights, const Progress& progress) {
    const std::vector<ErrorCase> cases = measure_errors(lobes_to_check(), lights, configurations(), progress);
    std::printf("configuration,cases,off_by_mean_db,off_by_rms_db,deviation_rms_db,below_by_1.28_deviations\n");
    for (size_t i = 0; i < configurations().size(); ++i) {
        double sum = 0, squares = 0, expected = 0, below = 0;
        for (const ErrorCase& one : cases) {
            const PredictedGain gain = predicted_gain(one.lobe, configurations()[i]);
            const double off = one.gain(configurations()[i]) - gain.mean;
            sum += off, squares += off * off, expected += gain.deviation * gain.deviation;
            below += off < -1.28 * gain.deviation;
        }
        const auto count = static_cast<double>(cases.size());
        std::printf("%s,%zu,%.1f,%.1f,%.1f,%.2f\n", name_of(configurations()[i]).c_str(), cases.size(), sum / count,
                    std::sqrt(squares / count), std::sqrt(expected / count), below / count);
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("The error model's table");
    int count = 3;
    uint32_t seed = 101;
    std::vector<std::string> files;
    bool is_check = false;
    std::string estimator, table;
    app.add_option("--lights", count, "stress lights, and as many room lights")->capture_default_str();
    app.add_option("--seed", seed, "of the first")->capture_default_str();
    app.add_option("--lights-from", files, "environment files besides")->delimiter(',');
    app.add_flag("--check", is_check, "judge the table that is compiled in");
    auto* one = app.add_option("--only", estimator, "the estimator to measure; the others are taken from a table");
    one->needs(app.add_option("--of", table, "that table")->check(CLI::ExistingFile))->check(CLI::IsMember(kEstimators));
    CLI11_PARSE(app, argc, argv);
    const Progress progress([](const std::string& stage, float done) {
        std::fprintf(stderr, "%s %.0f %%\n", stage.c_str(), 100 * done);
        return true;
    });
    const std::vector<NamedLight> lights = named_lights(count, seed, files);
    if (is_check)
        print_check(lights, progress);
    else
        print_table(lights, estimator.empty() ? Making() : only(estimator, table), progress);
    return 0;
}
