// The error model's table: prints core/burnish/plan/error_table.json.
//
//     burnish_error_table --lights-from rooitou_park_1k.hdr,lebombo_1k.hdr > core/burnish/plan/error_table.json
//
// `--check` prints how far the table that is compiled in is off, for lobes between its own and lights that it was not made from:
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

#include <cstdio>
#include <map>

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

/// One lobe's cases, a light each.
json lobe_entry(const LobeClass& lobe, std::span<const ErrorCase> cases) {
    json entry = {{"tail", lobe.tail == LobeTail::gaussian ? "gaussian" : "long"},
                  {"aspect", to_json_number(lobe.aspect)},
                  {"m", to_json_number(lobe.m)}};
    for (size_t i = 0; i < configurations().size(); ++i) {
        std::vector<double> gains;
        for (const ErrorCase& one : cases) gains.push_back(one.psnr_db[i] - one.probe_db());
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

void print_table(const std::vector<NamedLight>& lights, const Progress& progress) {
    const std::vector<LobeClass> classes = lobe_classes();
    std::vector<NamedLobe> lobes;
    for (const LobeClass& one : classes) lobes.push_back({"", lobe_of(one)});
    const std::vector<ErrorCase> cases = measure_errors(lobes, lights, part_of(progress, 0, 0.9f));
    json entries = json::array(), names = json::array(), light_names = json::array();
    for (size_t i = 0; i < classes.size(); ++i)
        entries.push_back(lobe_entry(classes[i], std::span(cases).subspan(i * lights.size(), lights.size())));
    for (const Configuration& configuration : configurations()) names.push_back(name_of(configuration));
    for (const NamedLight& light : lights) light_names.push_back(light.name);
    std::printf("{\n  \"made_by\": \"burnish_error_table\",\n  \"lights\": %s,\n  \"configurations\": %s,\n",
                light_names.dump().c_str(), names.dump().c_str());
    print_list("lobes", entries, ",");
    print_list("sparse", sparse_entries(lights, part_of(progress, 0.9f, 1)), "");
    std::printf("}\n");
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
    const std::vector<ErrorCase> cases = measure_errors(lobes_to_check(), lights, progress);
    std::printf("configuration,cases,off_by_mean_db,off_by_rms_db,deviation_rms_db,below_by_1.28_deviations\n");
    for (size_t i = 0; i < configurations().size(); ++i) {
        double sum = 0, squares = 0, expected = 0, below = 0;
        for (const ErrorCase& one : cases) {
            const PredictedGain gain = predicted_gain(one.lobe, configurations()[i]);
            const double off = one.psnr_db[i] - one.probe_db() - gain.mean;
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
    app.add_option("--lights", count, "stress lights, and as many room lights")->capture_default_str();
    app.add_option("--seed", seed, "of the first")->capture_default_str();
    app.add_option("--lights-from", files, "environment files besides")->delimiter(',');
    app.add_flag("--check", is_check, "judge the table that is compiled in");
    CLI11_PARSE(app, argc, argv);
    const Progress progress([](const std::string& stage, float done) {
        std::fprintf(stderr, "%s %.0f %%\n", stage.c_str(), 100 * done);
        return true;
    });
    const std::vector<NamedLight> lights = named_lights(count, seed, files);
    if (is_check)
        print_check(lights, progress);
    else
        print_table(lights, progress);
    return 0;
}
