// The published SGD fits of the 100 MERL materials, checked: prints a CSV row per material and channel. Needs the test data.
//
//     scale         published normaliser over the closed form, minus 1
//     table         largest error of the tabulated G1 over all angles
//     published_l2  mean square of the published fit of G1 less Smith's, over angles;  fit_l2: of our own fit
//     own, ggx      variance over squared mean of one sample of the albedo at 45 degrees, by slopes drawn from the table, and by
//                   those of GGX of the same alpha as the source has it
//     albedo        largest directional albedo of the material, kd included, at theta degrees
#include "core/material/sgd_rows.h"

#include <burnish/material/albedo.h>
#include <burnish/material/any_model.h>
#include <burnish/material/library.h>
#include <burnish/material/lobes/microfacet.h>
#include <burnish/material/sgd/sgd_data.h>

#include <cstdio>
#include <random>

using namespace burnish;

namespace {

constexpr int kSamples = 200000, kAngles = 900;
const Vec3f kView(std::sqrt(0.5f), 0, std::sqrt(0.5f));

double table_error(const ShiftedGamma& slopes) {
    const SmithTable table(slopes);
    double worst = 0;
    for (int i = 0; i < kAngles; ++i) {
        const double cot = 1 / std::tan((i + 0.5) * M_PI / 2 / kAngles);
        worst = std::max(worst, std::abs(table.G1(static_cast<float>(cot)) - slopes.G1(cot)));
    }
    return worst;
}

/// Variance over squared mean of weights, drawn one at a time.
template <class Draw>
double relative_variance(Draw draw) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0, 1);
    double sum = 0, square = 0;
    for (int i = 0; i < kSamples; ++i) {
        const double weight = draw(Vec2f(uniform(random), uniform(random)));
        sum += weight, square += weight * weight;
    }
    return square * kSamples / (sum * sum) - 1;
}

double own_variance(const AnyModel& lobe, int channel) {
    return relative_variance([&](const Vec2f& u) {
        const Vec3f wi = lobe.sample(kView, u);
        const float pdf = lobe.pdf(kView, wi);
        return pdf > 0 ? lobe.eval(kView, wi)[channel] * wi.z / pdf : 0.0f;
    });
}

double ggx_variance(const AnyModel& lobe, int channel, float alpha) {
    return relative_variance([&](const Vec2f& u) {
        const float slope = alpha * std::sqrt(u.x / (1 - u.x)), phi = 2 * kPi * u.y, z = 1 / std::sqrt(1 + slope * slope);
        const Vec3f h(slope * z * std::cos(phi), slope * z * std::sin(phi), z), wi = reflect(kView, h);
        const float e = slope * slope + alpha * alpha, D = alpha * alpha / (kPi * e * e * z * z * z * z);
        const float cos_d = kView.dot(h);
        return cos_d > 0 && wi.z > 0 ? lobe.eval(kView, wi)[channel] * wi.z * 4 * cos_d / (D * z) : 0.0f;
    });
}

}  // namespace

int main() {
    std::puts("material,channel,alpha,p,scale,table,published_l2,fit_l2,own,ggx,albedo,theta");
    for (const SgdRow& row : sgd_rows("sgd_bagher2012_bbm.csv")) {
        const Material material = find_material("merl:" + row.material);
        const AnyModel lobe(material.lobes.at(0));
        const EnergyCheck energy = check_energy(material);
        for (int k = 0; k < 3; ++k) {
            const double alpha = row.at("alpha", k), p = row.at("p", k);
            const ShiftedGamma slopes(alpha, p);
            const FittedShadowing published(row.at("lambda", k), row.at("c", k), row.at("k", k));
            std::printf("%s,%c,%g,%g,%.2g,%.2g,%.2g,%.2g,%.3g,%.3g,%.3f,%g\n", row.material.c_str(), "rgb"[k], alpha, p,
                        row.at("kap", k) * alpha * upper_gamma(1 - p, alpha) - 1, table_error(slopes),
                        shadowing_error(published, slopes), fit_g1(alpha, p).l2, own_variance(lobe, k),
                        ggx_variance(lobe, k, static_cast<float>(alpha)), energy.max_albedo, energy.theta_o_deg);
        }
    }
}
