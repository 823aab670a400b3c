// What the error model is made from and judged on: lobes on a sphere under lights, all configurations against the exact integral.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/light/environment.h>
#include <burnish/plan/configuration.h>
#include <burnish/plan/truth.h>
#include <burnish/sampling/tuned_patterns.h>

#include <map>
#include <string>
#include <vector>

namespace burnish {

/// What the error model tells lobes apart by.
struct LobeClass {
    LobeTail tail;
    float aspect, m;  // max(mx, my) / min(mx, my), sqrt(mx my)

    bool operator==(const LobeClass&) const = default;
};

/// Both tails, round ones of seven widths, long ones of three.
std::vector<LobeClass> lobe_classes();
LobeParameters lobe_of(const LobeClass& lobe);

struct NamedLight {
    std::string name;
    Environment light;
};

/// `count` stress lights and as many room lights, seeds from `seed` on; then the files.
std::vector<NamedLight> named_lights(int count, uint32_t seed, const std::vector<std::string>& files);

/// One lobe under one light: display PSNR in dB of configurations, kProbe among them.
struct ErrorCase {
    std::string material, light;
    LobeParameters lobe;
    std::map<Configuration, double> psnr_db;

    double gain(const Configuration& configuration) const { return psnr_db.at(configuration) - psnr_db.at(kProbe); }
};

struct NamedLobe {
    std::string name;
    LobeParameters lobe;
};

/// Every lobe under every light, in this order. What cannot shade a lobe has 0 dB.
std::vector<ErrorCase> measure_errors(const std::vector<NamedLobe>& lobes, const std::vector<NamedLight>& lights,
                                      const std::vector<Configuration>& configurations, const Progress& progress);

}  // namespace burnish
