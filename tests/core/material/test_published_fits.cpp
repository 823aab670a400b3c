// The published fits of the MERL materials through our models: each row becomes a lobe by the convention of its authors, which is
// held to their equation, and all of them show about what the independent SGD fits of the same materials show.
#include <burnish/material/lobes/abc_normals.h>
#include <burnish/material/material_brdf.h>
#include <core/data.h>
#include <core/material/published_fits.h>
#include <core/material/textbook.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace burnish {

namespace {

using textbook::Vec3d;

Color3f scaled(const Color3f& c, double by) { return c * static_cast<float>(by); }

/// kd, tint and a lobe whose two widths are m.
Material one_lobe(const FitRow& row, ModelId model, double m, const Color3f& tint, const Fresnel& fresnel = {}) {
    LobeParameters lobe;
    lobe.model = model;
    lobe.mx = lobe.my = static_cast<float>(m);
    lobe.tint = tint;
    lobe.fresnel = fresnel;
    return {row.material, row.color(row.has("kD_r") ? "kD" : "diffuse"), {lobe}};
}

Fresnel schlick(double r0) { return {FresnelKind::schlick, Color3f(static_cast<float>(r0))}; }
Fresnel dielectric(double ior) { return {FresnelKind::dielectric, Color3f(static_cast<float>(ior))}; }

Material abc(const FitRow& row) {
    const double K = AbcNormals::peak(row["B"], row["C"]);
    Material material = one_lobe(row, ModelId::abc, 1, scaled(row.color("A"), 4 / (M_PI * K)), dielectric(row["ior"]));
    LobeParameters& lobe = material.lobes[0];
    lobe.extra = {static_cast<float>(row["B"]), static_cast<float>(row["C"])};
    lobe.mx = lobe.my = prepare(lobe);
    return material;
}

Material lafortune(const FitRow& row) {
    Material material = one_lobe(row, ModelId::lafortune, 1 / std::sqrt(2 * row["sharpness"]), row.color("specular"));
    material.lobes[0].extra = {static_cast<float>(row["Cxy"]), static_cast<float>(row["Cz"])};
    return material;
}

struct PublishedModel {
    std::string file;
    std::function<Material(const FitRow&)> material;
    /// The authors' equation of the specular part without its colour; none where ours is another model, near theirs.
    std::function<double(const FitRow&, const Vec3d& wo, const Vec3d& wi, const Vec3d& h)> specular;
    double closeness;  // median over the materials of |ln(fit / SGD)|, at most
};

const PublishedModel kPublished[] = {
    {"ngan2005_ward", [](const FitRow& r) { return one_lobe(r, ModelId::ward, r["roughness"], r.color("specular")); },
     [](const FitRow& r, const Vec3d& wo, const Vec3d& wi, const Vec3d& h) {
         const double m2 = r["roughness"] * r["roughness"];
         return std::exp((1 - 1 / (h.z * h.z)) / m2) / (4 * M_PI * m2 * std::sqrt(wo.z * wi.z));
     },
     0.25},
    {"ngan2005_wardduer", [](const FitRow& r) { return one_lobe(r, ModelId::ward_duer, r["roughness"], r.color("specular")); },
     [](const FitRow& r, const Vec3d& wo, const Vec3d& wi, const Vec3d& h) {
         const double m2 = r["roughness"] * r["roughness"];
         return std::exp((1 - 1 / (h.z * h.z)) / m2) / (4 * M_PI * m2 * wo.z * wi.z);
     },
     0.3},
    {"ngan2005_blinnphong",
     [](const FitRow& r) {
         return one_lobe(r, ModelId::blinn_phong, std::sqrt(2 / (r["sharpness"] + 2)), scaled(r.color("specular"), 4));
     },
     [](const FitRow& r, const Vec3d&, const Vec3d&, const Vec3d& h) {
         return (r["sharpness"] + 2) / (2 * M_PI) * std::pow(h.z, r["sharpness"]);
     },
     0.27},
    {"ngan2005_lafortune", lafortune,
     [](const FitRow& r, const Vec3d& wo, const Vec3d& wi, const Vec3d&) {
         const double n = r["sharpness"], largest = std::max(std::abs(r["Cxy"]), std::abs(r["Cz"]));
         return (n + 2) / (2 * M_PI) * textbook::lafortune(r["Cxy"] / largest, r["Cz"] / largest, n, wo, wi);
     },
     0.4},
    {"ngan2005_ashikhminshirley",
     [](const FitRow& r) {
         return one_lobe(r, ModelId::ashikhmin_shirley, std::sqrt(2 / (r["sharpness"] + 1)), r.color("specular"),
                         schlick(r["fresnelReflectance"]));
     },
     [](const FitRow& r, const Vec3d& wo, const Vec3d& wi, const Vec3d& h) {
         const double n = r["sharpness"], r0 = r["fresnelReflectance"], cos_d = wo.dot(h);
         const double F = r0 + (1 - r0) * std::pow(1 - cos_d, 5);
         return (n + 1) / (8 * M_PI) * std::pow(h.z, n) * F / (cos_d * std::max(wo.z, wi.z));
     },
     0.27},
    {"ngan2005_cooktorrance",  // theirs has V-grooves and F D G / (pi cos cos)
     [](const FitRow& r) {
         return one_lobe(r, ModelId::beckmann, r["roughness"], scaled(r.color("specular"), 4 / M_PI), schlick(r["eta"]));
     },
     nullptr, 0.25},
    {"low2012_cooktorrance_E2",  // theirs has V-grooves and F D G / (cos cos)
     [](const FitRow& r) {
         return one_lobe(r, ModelId::beckmann, r["roughness"], scaled(r.color("specular"), 4), dielectric(r["eta"]));
     },
     nullptr, 0.17},
    {"low2012_ashikhminshirley_E2",
     [](const FitRow& r) {
         return one_lobe(r, ModelId::ashikhmin_shirley, std::sqrt(2 / (r["sharpness"] + 1)), r.color("specular"),
                         dielectric(r["fresnelReflectance"]));
     },
     nullptr, 0.17},
    {"abc_low2012", abc,
     [](const FitRow& r, const Vec3d& wo, const Vec3d& wi, const Vec3d& h) {
         const double F = dielectric_fresnel(static_cast<float>(r["ior"]), static_cast<float>(wo.dot(h)));
         return F * textbook::groove_G(wo, wi, h) * std::pow(1 + r["B"] * (1 - h.z), -r["C"]) / (M_PI * wo.z * wi.z);
     },
     0.2},
};

/// Half vectors theta_h from the normal, directions theta_d from them, across.
std::vector<std::pair<Vec3d, Vec3d>> views() {
    std::vector<std::pair<Vec3d, Vec3d>> all;
    for (const double h_deg : {0.0, 2.0, 5.0, 10.0, 20.0})
        for (const double d_deg : {10.0, 30.0, 50.0}) {
            const double th = h_deg * M_PI / 180, td = d_deg * M_PI / 180;
            const Vec3d h(std::sin(th), 0, std::cos(th)), across(0, std::sin(td), 0);
            all.emplace_back(h * std::cos(td) - across, h * std::cos(td) + across);
        }
    return all;
}

double median(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

}  // namespace

TEST(PublishedFits, AreTheirAuthorsEquations) {
    if (!data_path("public/brdf_fits")) GTEST_SKIP() << "set BURNISH_DATA to the data folder for public/brdf_fits";
    for (const PublishedModel& published : kPublished) {
        if (!published.specular) continue;
        for (const FitRow& row : read_fits(published.file)) {
            const MaterialBrdf brdf(published.material(row));
            const bool is_abc = row.has("kD_r");
            for (const auto& [wo, wi] : views()) {
                const double shape = published.specular(row, wo, wi, (wo + wi).normalized());
                const double expected = row[is_abc ? "kD_g" : "diffuse_g"] / M_PI + shape * row[is_abc ? "A_g" : "specular_g"];
                EXPECT_NEAR(brdf(Vec3f(wo), Vec3f(wi)).y, expected, 3e-3 * expected + 1e-9)
                    << published.file << " " << row.material;
            }
        }
    }
}

TEST(PublishedFits, ShowWhatTheSgdFitsShow) {
    if (!data_path("public/brdf_fits")) GTEST_SKIP() << "set BURNISH_DATA to the data folder for public/brdf_fits";
    const std::vector<FitRow> sgd = read_fits("sgd_bagher2012_bbm");
    for (const PublishedModel& published : kPublished) {
        std::vector<double> distances;
        for (const FitRow& row : read_fits(published.file)) {
            const auto known = std::ranges::find(sgd, row.material, &FitRow::material);
            ASSERT_NE(known, sgd.end()) << row.material;
            const MaterialBrdf brdf(published.material(row));
            std::vector<double> errors;
            for (const auto& [wo, wi] : views())
                errors.push_back(std::abs(std::log(brdf(Vec3f(wo), Vec3f(wi)).y / sgd_brdf(*known, "_g", wo, wi))));
            distances.push_back(median(errors));
        }
        EXPECT_LT(median(distances), published.closeness) << published.file << " over " << distances.size() << " materials";
        EXPECT_GE(distances.size(), 86u) << published.file;
    }
}

}  // namespace burnish
