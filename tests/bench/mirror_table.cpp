// A floor that mirrors a room: the few-sample estimators against Cycles, and against thousands of samples of the same lights.
//
//     burnish_mirror_table DATA/cycles/room [--step 3]
//
// Prints CSV. `polished`: varnish over Cycles' diffuse floor; `metal`, `anisotropic`: the overlay alone (Walkthrough 4.45); `cycles`:
// the floor that Cycles rendered. `off`: without the second step. Edges: within 8 pixels of a depth edge of the mirrored render.
#include "core/light/cycles_floor.h"
#include "core/scenes.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>

using namespace burnish_test;

namespace {

struct Floor {
    std::string name;
    LobeParameters lobe;
    bool over_diffuse = false;
};

std::vector<Floor> floors() {
    Floor cycles{"cycles", scenes::lobe_of(ModelId::ggx, 0.02f, 0.02f)};
    cycles.lobe.tint = Color3f(0.5f);
    Floor polished{"polished", scenes::lobe_of(ModelId::beckmann, 0.02f, 0.02f), true};
    polished.lobe.fresnel = {FresnelKind::schlick, Color3f(0.045f)};
    return {cycles,
            polished,
            {"metal", scenes::lobe_of(ModelId::ggx, 0.09f, 0.09f)},
            {"anisotropic", scenes::lobe_of(ModelId::beckmann, 0.15f, 0.04f)}};
}

struct Choice {
    std::string name;
    EstimatorSettings settings;
};

std::vector<Choice> choices() {
    std::vector<Choice> all;
    const auto add = [&](const char* name, EstimatorKind kind, int samples, PatternKind pattern) {
        EstimatorSettings settings;
        settings.kind = kind, settings.samples = samples, settings.pattern = pattern;
        all.push_back({name, settings});
    };
    for (const int n : {5, 6, 10, 13, 16}) add("fitted", EstimatorKind::fitted, n, PatternKind::automatic);
    for (const int n : {5, 10, 13, 16, 19}) {
        add("circles", EstimatorKind::regular, n, PatternKind::circles);
        add("tuned", EstimatorKind::regular, n, PatternKind::tuned);
        add("ring", EstimatorKind::regular, n, PatternKind::ring);
        add("rings", EstimatorKind::regular, n, PatternKind::rings);
    }
    return all;
}

void print_row(const CyclesFloor& room, const Floor& floor, const Choice& choice, bool second_step, const LightChain& lights,
               const std::vector<Color3f>& converged) {
    const Material material{floor.name, Color3f(0), {floor.lobe}};
    const MaterialShader shader(std::make_shared<const MaterialTaps>(material, choice.settings), lights);
    ShadedBatch out;
    double seconds = 1e9, lookups = 0;
    for (int repeat = 0; repeat < 3; ++repeat) {
        const auto start = std::chrono::steady_clock::now();
        shader.shade(room.batch, out);
        seconds = std::min(seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    for (const float samples : out.samples) lookups += samples;
    std::vector<Color3f> own = out.overlay, truth = converged;
    for (size_t i = 0; floor.over_diffuse && i < own.size(); ++i) own[i] += room.diffuse[i], truth[i] += room.diffuse[i];
    const double pixels = static_cast<double>(own.size()), ns = 1e9 * seconds;
    std::printf("%s,%s,%d,%s,%.1f,%.2f,%.2f", floor.name.c_str(), choice.name.c_str(), choice.settings.samples,
                second_step ? "on" : "off", lookups / pixels, room.psnr(own, truth), room.psnr(own, truth, true));
    if (floor.name == "cycles")
        std::printf(",%.2f,%.2f", room.psnr(own, room.glossy), room.psnr(own, room.glossy, true));
    else
        std::printf(",,");
    std::printf(",%.0f,%.0f\n", ns / pixels, ns / lookups);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    std::string folder;
    int step = 3, most = 8192;
    CLI::App app("Few-sample estimators on a mirror floor: prints CSV");
    app.add_option("folder", folder, "cycles/room of the test data")->required();
    app.add_option("--step", step, "every so manyth pixel and row");
    app.add_option("--samples", most, "of what counts as converged");
    CLI11_PARSE(app, argc, argv);

    const CyclesFloor room(folder, step);
    EstimatorSettings reference;
    reference.kind = EstimatorKind::reference, reference.tolerance = 1e-3f, reference.max_samples = most;
    std::puts(
        "floor,estimator,asked,second_step,lookups,converged_db,converged_edges_db,cycles_db,cycles_edges_db,ns_pixel,ns_"
        "lookup");
    for (const Floor& floor : floors()) {
        const LightChain lights = room.chain(true);
        const std::vector<Color3f> converged = room.shaded({floor.name, Color3f(0), {floor.lobe}}, reference, lights);
        if (floor.name == "cycles")
            std::printf("cycles,reference,%d,on,,,,%.2f,%.2f,,\n", most, room.psnr(converged, room.glossy),
                        room.psnr(converged, room.glossy, true));
        for (const Choice& choice : choices())
            for (const bool second_step : {true, false})
                print_row(room, floor, choice, second_step, second_step ? lights : room.chain(false), converged);
    }
}
