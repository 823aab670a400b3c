// How exact a factored light is: the source's table (Factor 5.7) under real HDRs, and what a display shows of it. Prints CSV.
//
//     burnish_factored_light lebombo_1k.hdr st_fagans_interior_1k.hdr rooitou_park_1k.hdr --material gold.json
//
// Errors as the source measures them: of all pairs that the maps were made from, channel by channel. `dB` is of other pairs, drawn as
// they are seen, against `reference`. The source's light was a picture of 8 bits whose highlights had been made ten times as bright;
// rows of the range "source" have pictures brought to that. Its reflection is a mirror's: rows of the direction "mirror".
#include <burnish/base/display.h>
#include <burnish/factor/factor_error.h>
#include <burnish/factor/factorise.h>
#include <burnish/factor/prescale_search.h>
#include <burnish/material/library.h>
#include <burnish/plan/check_sample.h>
#include <burnish/sampling/sequence.h>
#include <burnish/shading/lighting_samples.h>
#include <burnish/shading/material_shader.h>

#include <OpenImageIO/imagebuf.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>

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

Image light_picture(const std::string& file) {
    OIIO::ImageBuf buffer(file);
    Image picture(buffer.spec().width, buffer.spec().height, 3);
    if (!buffer.get_pixels(OIIO::ROI(0, picture.width, 0, picture.height, 0, 1, 0, 3), OIIO::TypeDesc::FLOAT,
                           picture.data.data()))
        throw std::runtime_error(file + ": " + buffer.geterror());
    return picture;
}

/// As an 8-bit picture has it, 2 % of its channels white; what is above nine tenths times ten.
void bring_to_source_range(Image& picture) {
    std::vector<float> sorted(picture.data.begin(), picture.data.end());
    const auto white = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 0.98);
    std::ranges::nth_element(sorted, white);
    for (float& value : picture.data) {
        value = std::round(std::clamp(value / *white, 0.0f, 1.0f) * 255) / 255;
        if (value > 0.9f) value *= 10;
    }
}

/// Pairs drawn evenly over the sphere of views and the projected hemisphere of normals about each; light axes.
std::vector<DirectionPair> seen_pairs(int count) {
    std::vector<DirectionPair> pairs;
    for (int i = 0; i < count; ++i) {
        const Vec2f u = owen_sobol(i, 11), v = owen_sobol(i, 12);
        const float z = 1 - 2 * u.x, s = std::sqrt(std::max(1 - z * z, 0.0f)), phi = 2 * kPi * u.y;
        const Vec3f wo(s * std::cos(phi), s * std::sin(phi), z);
        const float c = std::sqrt(std::max(v.x, 1e-4f)), r = std::sqrt(1 - c * c), turn = 2 * kPi * v.y;
        pairs.push_back({Frame::around(wo).to_world({r * std::cos(turn), r * std::sin(turn), c}), wo});
    }
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

void print_rows(const std::string& name, const char* range, const Environment& light, const Material& material, int size) {
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
        const FactorError error = factor_error(factors, samples);
        std::printf("%s,%s,%s,%d,%s,%d,%.4f,%.4f,%.4f,%.4f,%.2f,%.2f,%.2f\n", name.c_str(), range, row.parametrization,
                    row.terms, row.mirror ? "mirror" : "own", size, error.average_relative, error.average_absolute, error.rms,
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
        "light,range,parametrization,terms,reflection,size,average relative,average absolute,RMS,RMS at 8 bits,dB,"
        "seconds of sampling,seconds of factoring\n");
    for (const std::string& file : lights)
        for (const char* range : {"as it is", "source"}) {
            Image picture = light_picture(file);
            if (std::string(range) == "source") bring_to_source_range(picture);
            const std::string name = std::filesystem::path(file).stem().string();
            print_rows(name, range, Environment::from_image(picture, {}, name), parsed, size);
        }
}
