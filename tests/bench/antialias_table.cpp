// What anti-aliasing costs in processor time: surfaces, shading and resolving of one frame at 1, 4 and 16 samples a pixel, dense
// and sparse, as CSV on standard output. `exponent`: of the time against the samples, from 1 to this many; 1 is a cost in proportion.
#include "core/scenes.h"

#include <burnish/base/parallel.h>
#include <burnish/composite/resolve.h>
#include <burnish/output/compare.h>
#include <burnish/shading/sparse.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <ctime>
#include <filesystem>

using namespace burnish;

namespace {

struct Table {
    int height = 270, repeats = 7, threads = 1;
    std::vector<int> radii{100, 30}, factors{1, 2, 4};
    std::vector<float> widths{0.01f, 0.1f, 0.3f};
    std::vector<std::string> lights;
    PixelFilter filter{FilterKind::blackman_harris, 1.5f};
};

/// Of the processor, milliseconds.
struct Times {
    double surface = 1e30, shading = 1e30, resolving = 1e30;

    double total() const { return surface + shading + resolving; }
};

template <class Work>
auto timed(double& least, Work&& work) {
    const std::clock_t begin = std::clock();
    auto result = work();
    least = std::min(least, 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    return result;
}

struct Look {
    std::vector<MaterialShader> shaders;
    std::vector<BandwidthPredictor> predictors;
};

Look look_of(const Environment& light, float m) {
    const Material material{"bench", Color3f(0, 0, 0), {scenes::lobe_of(ModelId::ggx, m, m)}};
    return {{MaterialShader(material, light, EstimatorSettings{})}, {BandwidthPredictor(material, light, {})}};
}

/// The overlay in pixels, and the least times of some runs.
Image shade(const Table& table, const AovFrame& fine, int factor, const Look& look, bool is_sparse, Times& times) {
    const Window pixels{0, 0, fine.data_window.width / factor, fine.data_window.height / factor};
    Image overlay;
    for (int i = 0; i < table.repeats; ++i) {
        Assignment assignment = scenes::whole_frame(fine);
        const Surfaces surfaces = timed(times.surface, [&] { return Surfaces(fine, assignment, {}); });
        const ShadedFrame shaded = timed(times.shading, [&] {
            return is_sparse ? shade_sparse(fine, surfaces, assignment, look.shaders, look.predictors, {})
                             : shade_dense(surfaces, assignment, look.shaders, {});
        });
        for (size_t s = 0; s < assignment.coverage.size(); ++s)
            if (surfaces.validity(s) != Validity::valid) assignment.coverage[s] = 0;
        overlay = timed(times.resolving, [&] {
            const Resolver resolver({factor, 0, 0}, table.filter, fine.data_window, pixels);
            Image mean = resolver.mean(shaded.overlay, assignment.coverage);
            const Cover cover = resolver.cover(surfaces, assignment.coverage);
            for (size_t p = 0; p < mean.pixel_count(); ++p)
                for (int c = 0; c < 3; ++c) mean.at(p)[c] *= cover.overlay[p];
            return mean;
        });
    }
    return overlay;
}

void print_rows(const Table& table, const std::string& light_name, const Environment& light, int radius, float m) {
    const Look look = look_of(light, m);
    Times first[2];
    for (const int factor : table.factors) {
        const int width = table.height * 16 / 9 * factor, height = table.height * factor;
        const AovFrame fine = scenes::sphere_in_frame(width, height, radius * factor);
        Image dense;
        for (const bool is_sparse : {false, true}) {
            Times times;
            const Image overlay = shade(table, fine, factor, look, is_sparse, times);
            if (factor == table.factors.front()) first[is_sparse] = times;
            const auto exponent = [&](double now, double then) { return std::log(now / then) / std::log(factor * factor); };
            std::printf("%s,%d,%g,%s,%d,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%.1f\n", light_name.c_str(), radius, m,
                        is_sparse ? "sparse" : "dense", factor * factor, times.surface, times.shading, times.resolving,
                        times.total(), exponent(times.shading, first[is_sparse].shading),
                        exponent(times.total(), first[is_sparse].total()),
                        is_sparse ? compare_images(overlay, dense, nullptr).display_psnr_db : 99.9);
            std::fflush(stdout);
            if (!is_sparse) dense = overlay;
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    Table table;
    CLI::App app("What anti-aliasing costs.");
    app.add_option("--height", table.height, "of the frame, pixels; 16:9");
    app.add_option("--radii", table.radii, "of the sphere, pixels");
    app.add_option("--m", table.widths, "slope widths");
    app.add_option("--factors", table.factors, "samples across a pixel; the first is compared with");
    app.add_option("--lights", table.lights, "environment maps; none: a stress light");
    app.add_option("--repeats", table.repeats);
    app.add_option("--threads", table.threads);
    CLI11_PARSE(app, argc, argv);
    const ThreadLimit limit(table.threads);
    std::printf(
        "light,radius,m,shading,samples,surface_ms,shading_ms,resolving_ms,total_ms,shading_exponent,total_exponent,psnr_db\n");
    const auto rows = [&](const std::string& name, const Environment& light) {
        for (const int radius : table.radii)
            for (const float m : table.widths) print_rows(table, name, light, radius, m);
    };
    for (const std::string& file : table.lights) rows(std::filesystem::path(file).stem().string(), Environment::load(file, {}));
    if (table.lights.empty()) rows("stress", Environment::from_image(scenes::stress_light(1), {}, "stress"));
}
