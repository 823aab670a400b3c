// The floor of the room that Cycles rendered: its pixels, what Cycles reflects in them, and the lights that burnish has for them.
#pragma once

#include "core/light/depth_edges.h"
#include "core/read_layer.h"

#include <burnish/input/camera_source.h>
#include <burnish/input/exr_reader.h>
#include <burnish/output/compare.h>
#include <burnish/shading/local_shading.h>
#include <burnish/shading/material_shader.h>

#include <filesystem>

namespace burnish_test {

class CyclesFloor {
public:
    /// Every `step`th floor pixel of every `step`th row, its neighbours floor too.
    CyclesFloor(const std::filesystem::path& folder, int step) : m_folder(folder) {
        ReadOptions options;
        options.camera = camera_source(folder / "room.json");
        const AovFrame frame = read_frame(folder / "room.exr", options);
        const Image &position = frame.layer(Role::position),
                    material = read_layer(folder / "room.exr", {"ViewLayer.IndexMA.X"});
        mirror.file = folder / "mirror.exr", mirror.camera = folder / "mirror.json";
        buffer = MirrorBuffer::load(mirror, frame.camera);
        const Image edges = near_depth_edges(buffer, 8);
        for (int y = step; y + 1 < position.height; y += step)
            for (int x = step; x + 1 < position.width; x += step) {
                bool inside = true;
                for (int k = 0; k < 9; ++k) inside = inside && *material.at(x + k % 3 - 1, y + k / 3 - 1) == 1;
                if (!inside) continue;
                const float* p = position.at(x, y);
                batch.pixel.push_back(static_cast<uint32_t>(y * position.width + x));
                batch.p.push_back({p[0], p[1], 0}), batch.n.push_back({0, 0, 1}), batch.t.push_back({1, 0, 0});
                batch.wo.push_back((frame.camera->centre - Vec3f(p[0], p[1], 0)).normalized());
                at_edge.push_back(*edges.at(position.width - 1 - x, y) > 0);
            }
        glossy = pass("Gloss"), diffuse = pass("Diff");
    }

    /// The mirror before a cube map in the room's box.
    LightChain chain(bool second_step) const {
        MirrorSettings settings = mirror;
        settings.second_step = second_step;
        CubeMapSettings cube;
        cube.file = m_folder / "equirect.exr", cube.centre = Vec3f(0.8f, 0.7f, 1.01875f);
        cube.picture.up = UpAxis::z, cube.picture.convention = EnvironmentConvention::blender;
        cube.proxy.kind = ProxyKind::box,
        cube.proxy.box = {Vec3f(0, 0, 1.5f), Vec3f(3, 4, 1.5f), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        return LightChain({{std::make_shared<const Light>(MirrorLight(buffer, settings)), true},
                           {std::make_shared<const Light>(CubeMapLight(cube, {})), true}});
    }

    std::vector<Color3f> shaded(const Material& material, const EstimatorSettings& settings, const LightChain& lights) const {
        ShadedBatch out;
        MaterialShader(std::make_shared<const MaterialTaps>(material, settings), lights).shade(batch, out);
        return out.overlay;
    }

    /// Display PSNR, dB; `edges`: of pixels whose mirror ray ends within 8 pixels of a depth edge.
    double psnr(const std::vector<Color3f>& test, const std::vector<Color3f>& truth, bool edges = false) const {
        Image a(static_cast<int>(test.size()), 1, 3), b = a, mask(a.width, 1, 1);
        for (size_t i = 0; i < test.size(); ++i) {
            std::copy_n(&test[i].x, 3, a.at(i)), std::copy_n(&truth[i].x, 3, b.at(i));
            *mask.at(i) = !edges || at_edge[i] ? 1.0f : 0.0f;
        }
        return compare_images(a, b, &mask).display_psnr_db;
    }

    MirrorSettings mirror;
    MirrorBuffer buffer;
    SurfaceBatch batch;
    std::vector<bool> at_edge;
    std::vector<Color3f> glossy, diffuse;  // of Cycles

private:
    /// Colour times direct and indirect light.
    std::vector<Color3f> pass(const std::string& name) const {
        const auto layer = [&](const std::string& part) {
            const std::string whole = "ViewLayer." + name + part;
            return read_layer(m_folder / "room.exr", {whole + ".R", whole + ".G", whole + ".B"});
        };
        const Image color = layer("Col"), direct = layer("Dir"), indirect = layer("Ind");
        const auto at = [](const Image& image, size_t i) { return Color3f(image.at(i)[0], image.at(i)[1], image.at(i)[2]); };
        std::vector<Color3f> values;
        for (const uint32_t i : batch.pixel) values.push_back(at(color, i) * (at(direct, i) + at(indirect, i)));
        return values;
    }

    std::filesystem::path m_folder;
};

}  // namespace burnish_test
