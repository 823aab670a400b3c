// What a model costs: cycles of one RGB evaluation with Schlick's Fresnel, compiled for the type and through AnyModel's virtual
// call, the least of many runs over random pairs of directions; and how noisy its samples are, as the relative variance of
// f cos / p at three views, draws below the surface included. Beside it the figures of Bandwidth, V.5.6, of a ray tracer's
// evaluation: SGD 3044, Beckmann 1416, Lafortune 551. Prints CSV.
//
//     burnish_model_cost [m, default 0.2]
#include "core/material/lobe_cases.h"

#include <burnish/material/models/all.h>
#include <burnish/sampling/sequence.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>

#ifdef __x86_64__
#include <x86intrin.h>
#endif

using namespace burnish;

namespace {

constexpr int kPairs = 2048, kRuns = 200, kDraws = 1 << 14;

/// Of the time-stamp counter; nanoseconds where there is none.
double ticks() {
#ifdef __x86_64__
    return static_cast<double>(__rdtsc());
#else
    return static_cast<double>(std::chrono::steady_clock::now().time_since_epoch().count());
#endif
}

struct Pair {
    Vec3f wo, wi;
};

Vec3f from_above(float u, float v) {
    const float sine = std::sqrt(1 - u * u), phi = 2 * kPi * v;
    return {sine * std::cos(phi), sine * std::sin(phi), u};
}

std::vector<Pair> random_pairs() {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0.05f, 1);
    std::vector<Pair> pairs(kPairs);
    for (Pair& pair : pairs)
        pair = {from_above(uniform(random), uniform(random)), from_above(uniform(random), uniform(random))};
    return pairs;
}

template <class M>
double cycles(const M& model, const std::vector<Pair>& pairs) {
    double least = 1e30;
    for (int run = 0; run < kRuns; ++run) {
        Color3f sum(0, 0, 0);
        const double start = ticks();
        for (const Pair& pair : pairs) sum += model.eval(pair.wo, pair.wi);
        const double spent = ticks() - start;
        volatile float kept = sum.x + sum.y + sum.z;
        (void)kept;
        least = std::min(least, spent / kPairs);
    }
    return least;
}

template <class M>
double relative_variance(const M& model, float theta_deg) {
    const float theta = theta_deg * kPi / 180;
    const Vec3f wo(std::sin(theta), 0, std::cos(theta));
    double sum = 0, squares = 0;
    for (uint32_t i = 0; i < kDraws; ++i) {
        const Vec3f wi = model.sample(wo, hammersley(i, kDraws));
        const float pdf = model.pdf(wo, wi);
        const double weight = pdf > 0 ? model.eval(wo, wi).y * wi.z / pdf : 0;
        sum += weight, squares += weight * weight;
    }
    return squares * kDraws / (sum * sum) - 1;
}

std::string published(std::string_view model) {
    static const std::map<std::string_view, std::string> known{{"sgd", "3044"}, {"beckmann", "1416"}, {"lafortune", "551"}};
    const auto found = known.find(model);
    return found == known.end() ? "" : found->second;
}

template <class M>
void print_row(ModelId id, float m, const std::vector<Pair>& pairs) {
    const ModelInfo& info = model_info(id);
    LobeParameters lobe = make_lobe(id, m, m);
    lobe.fresnel = {FresnelKind::schlick, Color3f(0.05f, 0.04f, 0.03f)};
    if (const float own = prepare(lobe); own > 0) lobe.mx = lobe.my = own;
    const M model(lobe);
    const AnyModel any(lobe);
    lobe.fresnel = {};
    const M bare(lobe);
    std::printf("%s,%.3g,%.0f,%.0f,%s,%.2g,%.2g,%.2g\n", std::string(info.name).c_str(), lobe.mx, cycles(model, pairs),
                cycles(any, pairs), published(info.name).c_str(), relative_variance(bare, 0), relative_variance(bare, 60),
                relative_variance(bare, 85));
}

}  // namespace

int main(int argc, char** argv) {
    const float m = argc > 1 ? std::strtof(argv[1], nullptr) : 0.2f;
    const std::vector<Pair> pairs = random_pairs();
    std::printf("model,m,cycles,cycles_any_model,cycles_published,variance_0,variance_60,variance_85\n");
#define BURNISH_MODEL(id, type) print_row<type>(ModelId::id, m, pairs);
#include <burnish/material/models/models.def>
#undef BURNISH_MODEL
    return 0;
}
