// Reflections of traced rooms: `reference` against brute force over a lamp, and against what Cycles rendered.
#include "../data.h"
#include "../read_layer.h"
#include "shading_cases.h"

#include <burnish/output/compare.h>
#include <burnish/shading/local_shading.h>

#include <gtest/gtest.h>

using namespace burnish_test;

namespace {

LightChain chain_of(std::shared_ptr<const LitScene> scene, int rays = 4) {
    return LightChain({{std::make_shared<const Light>(TracedLight(std::move(scene), rays)), true}});
}

std::vector<Color3f> shaded(const LobeParameters& lobe, const EstimatorSettings& settings, const LightChain& lights,
                            const SurfaceBatch& batch) {
    ShadedBatch out;
    MaterialShader(std::make_shared<const MaterialTaps>(material(lobe), settings), lights).shade(batch, out);
    return out.overlay;
}

constexpr float kLampHalf = 0.05f, kLampHeight = 2;

std::shared_ptr<const LitScene> floor_and_lamp() {
    Matrix44f turn, place;
    turn.setEulerAngles(Vec3f(kPi, 0, 0)), place.setTranslation(Vec3f(0, 0, kLampHeight));
    Scene scene;
    scene.objects.push_back({"floor", "", make_plane(20, 20), 1, 1, Color3f(0.5f)});
    scene.objects.push_back({"lamp", "", transformed(make_plane(kLampHalf, kLampHalf), turn * place), 2, 2, Color3f(0.0f)});
    scene.objects[1].emission = Color3f(100, 50, 25);
    return std::make_shared<const LitScene>(std::move(scene), LightMaps());
}

/// What a point of the floor reflects of the lamp, by the midpoint rule over the lamp.
Color3f lamp_reflected(const LobeParameters& p, const Vec3f& at, const Vec3f& wo) {
    constexpr int kSteps = 200;
    const float step = 2 * kLampHalf / kSteps;
    return visit_lobe(p, [&](const auto& own) {
        Imath::V3d sum(0, 0, 0);
        for (int i = 0; i < kSteps * kSteps; ++i) {
            const Vec3f way =
                Vec3f((i % kSteps + 0.5f) * step - kLampHalf, (i / kSteps + 0.5f) * step - kLampHalf, kLampHeight) - at;
            const Vec3f wi = way.normalized();
            sum += Imath::V3d(own.eval(wo, wi) * (wi.z * wi.z / way.length2()));
        }
        return Color3f(100, 50, 25) * Color3f(Vec3f(sum * step * step));
    });
}

}  // namespace

TEST(TracedRoom, ReferenceFindsASmallLamp) {
    const LightChain lights = chain_of(floor_and_lamp());
    EstimatorSettings settings = estimator(EstimatorKind::reference);
    settings.tolerance = 1e-3f, settings.max_samples = 1 << 14;
    for (const float m : {0.02f, 0.1f, 0.4f}) {
        const LobeParameters p = lobe(ModelId::ggx, m, m);
        SurfaceBatch batch = fan(0.3f, 8);
        for (size_t i = 0; i < batch.size(); ++i) batch.p.x[i] = 0.2f * static_cast<float>(i);
        const std::vector<Color3f> found = shaded(p, settings, lights, batch);
        for (size_t i = 0; i < batch.size(); ++i) {
            const Color3f expected = lamp_reflected(p, batch.p[i], batch.wo[i]);
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[i][k], expected[k], 0.01f * expected[k] + 1e-5f) << m << " " << i;
        }
    }
}

namespace {

struct Glossy {
    const char* name;
    int material_index;
    float m;
    Color3f tint;
};
constexpr int kEvery = 61;

/// Every so many pixels of an object, none at its edge, and what Cycles saw reflected there.
struct Patch {
    SurfaceBatch batch;
    Image reflected;
};

class CyclesRoom {
public:
    explicit CyclesRoom(const std::filesystem::path& folder) : m_folder(folder) {
        m_position = layer("Position", "XYZ"), m_normal = layer("Normal", "XYZ"), m_material = layer("IndexMA", "X");
        m_reflected = layer("GlossDir", "RGB");
        const Image indirect = layer("GlossInd", "RGB"), color = layer("GlossCol", "RGB");
        for (size_t i = 0; i < m_reflected.data.size(); ++i)
            m_reflected.data[i] = color.data[i] * (m_reflected.data[i] + indirect.data[i]);
        TracedSettings settings;
        settings.scene = (folder / "room_lightmapped.glb").string(), settings.up = UpAxis::z;
        settings.radiance = (folder / "lightmap_radiance_reflected.exr").string();
        m_scene = std::make_shared<const LitScene>(settings);
    }

    std::shared_ptr<const LitScene> scene() const { return m_scene; }

    Patch patch(const Glossy& object) const {
        const Vec3f eye(0.2f, -3.7f, 1.55f);
        Patch patch;
        std::vector<uint32_t> pixels;
        for (int y = 1; y < m_material.height - 1; ++y)
            for (int x = 1 + y * 7 % kEvery; x < m_material.width - 1; x += kEvery)
                if (is_inside(object.material_index, x, y)) pixels.push_back(static_cast<uint32_t>(y * m_material.width + x));
        patch.reflected = Image(static_cast<int>(pixels.size()), 1, 3);
        for (const uint32_t pixel : pixels) {
            const Vec3f p = vec3(m_position, pixel), n = vec3(m_normal, pixel).normalized();
            std::copy_n(m_reflected.at(pixel), 3, patch.reflected.at(patch.batch.size()));
            patch.batch.pixel.push_back(pixel), patch.batch.p.push_back(p), patch.batch.n.push_back(n);
            patch.batch.wo.push_back((eye - p).normalized()), patch.batch.t.push_back(Frame::around(n).t);
        }
        return patch;
    }

private:
    static Vec3f vec3(const Image& image, size_t i) { return {image.at(i)[0], image.at(i)[1], image.at(i)[2]}; }

    Image layer(const std::string& name, const std::string& channels) const {
        std::vector<std::string> names;
        for (const char c : channels) names.push_back("ViewLayer." + name + "." + c);
        return read_layer(m_folder / "room.exr", names);
    }

    bool is_inside(int material, int x, int y) const {
        for (int i = 0; i < 9; ++i)
            if (*m_material.at(x + i % 3 - 1, y + i / 3 - 1) != static_cast<float>(material)) return false;
        return true;
    }

    std::filesystem::path m_folder;
    Image m_position, m_normal, m_material, m_reflected;
    std::shared_ptr<const LitScene> m_scene;
};

double display_psnr(const std::vector<Color3f>& overlay, const Image& truth) {
    Image image(truth.width, 1, 3);
    for (size_t i = 0; i < overlay.size(); ++i) std::copy_n(&overlay[i].x, 3, image.at(i));
    return compare_images(image, truth, nullptr).display_psnr_db;
}

}  // namespace

TEST(TracedRoom, ShowsWhatCyclesReflects) {
    const auto folder = data_path("cycles/room");
    if (!folder) GTEST_SKIP() << "no data";
    const CyclesRoom room(*folder);
    EstimatorSettings reference = estimator(EstimatorKind::reference), taps = estimator(EstimatorKind::fitted, 16);
    reference.tolerance = 0.01f, reference.max_samples = 4096;
    for (const Glossy& object :
         {Glossy{"floor", 1, 0.02f, Color3f(0.5f)}, Glossy{"vase", 2, 0.05f, Color3f(0.7f, 0.7f, 0.65f)}}) {
        LobeParameters p = lobe(ModelId::ggx, object.m, object.m);
        p.tint = object.tint;
        const Patch patch = room.patch(object);
        ASSERT_GT(patch.batch.size(), 50u);
        EXPECT_GT(display_psnr(shaded(p, reference, chain_of(room.scene()), patch.batch), patch.reflected), 42) << object.name;
        EXPECT_GT(display_psnr(shaded(p, taps, chain_of(room.scene(), 16), patch.batch), patch.reflected), 33) << object.name;
    }
}
