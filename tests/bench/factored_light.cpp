// How exact a factored light is: the source's table (Factor 5.7) under real HDRs, and what a display shows of it. Prints CSV.
//
//     burnish_factored_light lebombo_1k.hdr st_fagans_interior_1k.hdr rooitou_park_1k.hdr --material gold.json
//
// Errors as the source measures them: of all pairs that the maps were made from, channel by channel. `dB` is of other pairs, drawn as
// they are seen, against `reference`. The source's reflection is a mirror's: rows "mirror".
#include <burnish/base/display.h>
#include <burnish/factor/factor_error.h>
#include <burnish/factor/factorise.h>
#include <burnish/factor/prescale_search.h>
#include <burnish/material/library.h>
#include <burnish/plan/check_sample.h>
#include <burnish/shading/lighting_samples.h>
#include <burnish/shading/material_shader.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

using namespace burnish;

namespace {

struct Row {
    const char* parametrization;
    int terms;
    bool mirror;
};

constexpr Row kRows[] = {{"nr", 1, true},    {"nr", 1, false},  {"nrv", 1, true}, {"nrv", 1, false}, {"nrhd", 1, true},
                         {"nrhd", 1, false}, {"nre", 1, false}, {"re", 1, false}, {"re", 2, false}};

double seconds_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::vector<DirectionPair> seen_pairs(uint32_t count) {
    std::vector<DirectionPair> pairs;
    for (uint32_t i = 0; i < count; ++i) pairs.push_back(seen_pair(i, 11));
    return pairs;
}

/// Exact radiance of pairs.
std::vector<Color3f> exact_radiance(const Material& material, const Environment& light,
                                    const std::vector<DirectionPair>& pairs) {
    EstimatorSettings reference;
    reference.kind = EstimatorKind::reference;
    const Matrix33f to_world = light.world_to_light().transposed();
    SurfaceBatch batch;
    for (const DirectionPair& pair : pairs) {
        batch.pixel.push_back(static_cast<uint32_t>(batch.pixel.size()));
        batch.n.push_back(pair.a * to_world), batch.wo.push_back(pair.b * to_world);
    }
    ShadedBatch shaded;
    MaterialShader(material, light, reference).shade(batch, shaded);
    return shaded.overlay;
}

double display_db(const Factors& factors, const std::vector<DirectionPair>& pairs, const std::vector<Color3f>& exact) {
    const double exposure = exposure_of(exact, std::vector<double>(exact.size(), 1.0));
    double sum = 0;
    for (size_t i = 0; i < pairs.size(); ++i) {
        const Color3f found = factors(pairs[i]);
        for (int c = 0; c < 3; ++c)
            sum += std::pow(display_encoded(found[c] * exposure) - display_encoded(exact[i][c] * exposure), 2);
    }
    return -10 * std::log10(sum / (3.0 * static_cast<double>(pairs.size())));
}

/// RMS of the 8-bit form.
double eight_bit_rms(const Factors& factors, const std::vector<FactorSample>& samples) {
    return factor_error(quantise(factors, best_prescale(factors, {}, samples)), samples).rms;
}

void print_rows(const std::string& name, const Environment& light, const Material& material, int size) {
    LightingSampling even;
    even.weight = ViewWeight::uniform;
    const double begin = seconds_now();
    const std::vector<FactorSample> samples = lighting_samples(material, light, even);
    const double sampling = seconds_now() - begin;
    const std::vector<DirectionPair> pairs = seen_pairs(4000);
    const std::vector<Color3f> exact = exact_radiance(material, light, pairs);
    for (const Row& row : kRows) {
        FactorGuide guide = row.mirror ? FactorGuide() : FactorGuide::of(material);
        guide.dominant = dominant_direction(light);
        FactoriseSettings settings;
        settings.size = size, settings.terms = row.terms;
        const double start = seconds_now();
        const Factors factors = factorise(parametrization_by_name(row.parametrization), samples, guide, settings);
        const double factoring = seconds_now() - start;
        const FactorError error = factor_error(factors, samples, settings.bias);
        std::printf("%s,%s,%d,%s,%d,%.4f,%.4f,%.4f,%.4f,%.2f,%.2f,%.2f\n", name.c_str(), row.parametrization, row.terms,
                    row.mirror ? "mirror" : "own", size, error.average_relative, error.average_absolute, error.rms,
                    eight_bit_rms(factors, samples), display_db(factors, pairs, exact), sampling, factoring);
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("How exact a factored light is");
    std::vector<std::string> lights;
    std::string material = R"({"model": "beckmann", "m": 0.3, "metal": "gold"})";
    int size = 32;
    app.add_option("LIGHTS", lights, "lat-long pictures")->required();
    app.add_option("--material", material, "JSON [gold by Cook & Torrance's model]");
    app.add_option("--size", size, "texels a side of a disc; the source's maps of 64 x 64 hold two of 32 [32]");
    CLI11_PARSE(app, argc, argv);
    const Material parsed = material_from_json(nlohmann::json::parse(material), "material", "--material");
    std::printf(
        "light,parametrization,terms,reflection,size,average relative,average absolute,RMS,RMS at 8 bits,dB,"
        "seconds of sampling,seconds of factoring\n");
    for (const std::string& file : lights) {
        const std::string name = std::filesystem::path(file).stem().string();
        print_rows(name, Environment::load(file, {}), parsed, size);
    }
}
