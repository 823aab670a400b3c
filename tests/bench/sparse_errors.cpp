#include "sparse_errors.h"

#include "core/scenes.h"

#include <burnish/output/compare.h>
#include <burnish/shading/sparse.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr double kHighest_db = 75;  // of pictures that agree

struct Sphere {
    explicit Sphere(int size) : frame(scenes::sphere_frame(size)) {}

    AovFrame frame;
    Assignment assignment = scenes::whole_frame(frame);
    Surfaces surfaces{frame, assignment, {}};
};

double sparse_psnr(const Sphere& sphere, const Material& material, const Environment& light, const MaterialShader& shader,
                   const Image& dense, float safety) {
    DensitySettings density;
    density.safety = safety;
    const BandwidthPredictor predictor(material, light, density);
    const ShadedFrame sparse = shade_sparse(sphere.frame, sphere.surfaces, sphere.assignment, {shader}, {predictor}, {});
    Image mask(dense.width, dense.height, 1);
    for (size_t i = 0; i < mask.pixel_count(); ++i) *mask.at(i) = sphere.surfaces.validity(i) == Validity::valid;
    return std::min(compare_images(sparse.overlay, dense, &mask).display_psnr_db, kHighest_db);
}

}  // namespace

std::map<float, std::vector<double>> measure_sparse_errors(const std::vector<NamedLight>& lights, const Progress& progress) {
    const Sphere spheres[] = {Sphere(120), Sphere(400)};
    std::map<float, std::vector<double>> psnr_db;
    for (size_t i = 0; i < lights.size(); ++i) {
        progress.report("sparse", static_cast<float>(i) / static_cast<float>(lights.size()));
        for (const ModelId model : {ModelId::ggx, ModelId::beckmann})
            for (const float m : {0.03f, 0.1f, 0.4f})
                for (const Sphere& sphere : spheres) {
                    const Environment& light = lights[i].light;
                    const Material material{"lobe", Color3f(0, 0, 0), {scenes::lobe_of(model, m, m)}};
                    const MaterialShader shader(material, light, {});
                    const Image dense = shade_dense(sphere.surfaces, sphere.assignment, {shader}, {}).overlay;
                    for (const float safety : {0.25f, 0.5f, 0.7f, 1.0f, 1.4f, 2.0f, 4.0f})
                        psnr_db[safety].push_back(sparse_psnr(sphere, material, light, shader, dense, safety));
                }
    }
    return psnr_db;
}

}  // namespace burnish
