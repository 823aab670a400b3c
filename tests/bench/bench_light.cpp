// Distant light: filtered lookups per second on one core beside OpenImageIO's texture system, and the time to make a cube
// pyramid or a Gaussian stack and to resample a lat-long.
#include <burnish/base/parallel.h>
#include <burnish/light/environment.h>
#include <burnish/light/filter/cube_pyramid.h>
#include <burnish/light/filter/cube_resample.h>
#include <burnish/light/filter/gaussian_stack.h>

#include <benchmark/benchmark.h>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>

#include <filesystem>
#include <random>

using namespace burnish;

namespace {

constexpr int kDirections = 1 << 16;

Image noise_latlong(int width) {
    std::mt19937 random(1);
    Image image(width, width / 2, 3);
    for (float& value : image.data) value = static_cast<float>(random() >> 8) * 0x1p-24f;
    return image;
}

/// `coherent`: as neighbouring pixels ask, a slow spiral; else anywhere on the sphere.
std::vector<Vec3f> directions(bool coherent) {
    std::mt19937 random(2);
    const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    std::vector<Vec3f> all(kDirections);
    for (int i = 0; i < kDirections; ++i) {
        const float t = static_cast<float>(i) / kDirections;
        const float z = coherent ? 1.0f - 2.0f * t : 1.0f - 2.0f * uniform(),
                    phi = 2 * kPi * (coherent ? 50.0f * t : uniform());
        const float r = std::sqrt(std::max(0.0f, 1.0f - z * z));
        all[i] = {r * std::cos(phi), r * std::sin(phi), z};
    }
    return all;
}

/// Arguments: face size, coherent, 10 * level.
void trilinear_lookup(benchmark::State& state) {
    const int size = static_cast<int>(state.range(0));
    const CubePyramid pyramid(latlong_to_cube(noise_latlong(4 * size), size), PyramidKernel::binomial6);
    const std::vector<Vec3f> dirs = directions(state.range(1) != 0);
    const float level = static_cast<float>(state.range(2)) / 10;
    for (auto _ : state) {
        Color3f sum(0.0f);
        for (const Vec3f& d : dirs) sum += pyramid.lookup(d, level);
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * kDirections);
}

/// The same by OpenImageIO's TextureSystem: 1024 x 512 lat-long, isotropic trilinear filter of four texels.
void openimageio_environment(benchmark::State& state) {
    const Image image = noise_latlong(1024);
    const OIIO::ImageBuf picture(OIIO::ImageSpec(1024, 512, 3, OIIO::TypeFloat), const_cast<float*>(image.data.data()));
    const auto file = std::filesystem::temp_directory_path() / "burnish_bench_environment.exr";
    OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxEnvLatl, picture, file.string(), OIIO::ImageSpec());
    OIIO::TextureSystem* textures = OIIO::TextureSystem::create(false);
    OIIO::TextureSystem::TextureHandle* handle = textures->get_texture_handle(OIIO::ustring(file.string()));
    OIIO::TextureOpt options;
    options.mipmode = OIIO::TextureOpt::MipModeTrilinear;
    options.interpmode = OIIO::TextureOpt::InterpBilinear;
    const std::vector<Vec3f> dirs = directions(state.range(0) != 0);
    for (auto _ : state) {
        float sum[3] = {0, 0, 0}, rgb[3];
        for (const Vec3f& d : dirs) {
            const Frame frame = Frame::around(d);
            const float width = 4 * 2 * kPi / 1024;
            textures->environment(handle, nullptr, options, d, frame.t * width, frame.b * width, 3, rgb);
            for (int k = 0; k < 3; ++k) sum[k] += rgb[k];
        }
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * kDirections);
    OIIO::TextureSystem::destroy(textures);
    std::filesystem::remove(file);
}

/// Arguments: face size, kernel (0 = 2 x 2, 1 = 4 x 4, 2 = 6 x 6), threads.
void build_pyramid(benchmark::State& state) {
    const int size = static_cast<int>(state.range(0));
    const ThreadLimit limit(static_cast<int>(state.range(2)));
    const auto faces = latlong_to_cube(noise_latlong(4 * size), size);
    for (auto _ : state) benchmark::DoNotOptimize(CubePyramid(faces, static_cast<PyramidKernel>(state.range(1))));
}

/// Arguments: face size, threads.
void build_gaussian_stack(benchmark::State& state) {
    const int size = static_cast<int>(state.range(0));
    const ThreadLimit limit(static_cast<int>(state.range(1)));
    const auto faces = latlong_to_cube(noise_latlong(4 * size), size);
    for (auto _ : state) benchmark::DoNotOptimize(GaussianStack(faces));
}

/// Arguments: lat-long width, threads. The face size is the default one.
void resample_latlong(benchmark::State& state) {
    const int width = static_cast<int>(state.range(0));
    const ThreadLimit limit(static_cast<int>(state.range(1)));
    const Image image = noise_latlong(width);
    for (auto _ : state) benchmark::DoNotOptimize(latlong_to_cube(image, cube_size_for_latlong(width)));
}

/// Arguments: lat-long width, threads. Everything from pixels to a light that can be looked up in its pyramid and sampled.
void whole_environment(benchmark::State& state) {
    const ThreadLimit limit(static_cast<int>(state.range(1)));
    const Image image = noise_latlong(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(&Environment::from_image(image, {}, "noise").pyramid());
}

}  // namespace

BENCHMARK(trilinear_lookup)->ArgNames({"size", "coherent", "level_x10"})->ArgsProduct({{256, 512}, {0, 1}, {0, 5, 25}});
BENCHMARK(openimageio_environment)->ArgName("coherent")->Arg(0)->Arg(1);
BENCHMARK(build_pyramid)
    ->ArgNames({"size", "kernel", "threads"})
    ->ArgsProduct({{256, 512, 1024}, {0, 1, 2}, {2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(build_gaussian_stack)
    ->ArgNames({"size", "threads"})
    ->ArgsProduct({{256, 512, 1024}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(resample_latlong)
    ->ArgNames({"width", "threads"})
    ->ArgsProduct({{1024, 2048, 4096}, {2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(whole_environment)
    ->ArgNames({"width", "threads"})
    ->ArgsProduct({{1024, 4096}, {2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
