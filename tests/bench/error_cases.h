// What the error model is made from and judged on: lobes on a sphere under lights, all configurations against the exact integral.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/light/environment.h>
#include <burnish/plan/truth.h>
#include <burnish/sampling/tuned_patterns.h>

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

/// One lobe under one light: display PSNR in dB of every one of configurations().
struct ErrorCase {
    std::string material, light;
    LobeParameters lobe;
    std::vector<double> psnr_db;

    double probe_db() const;
};

struct NamedLobe {
    std::string name;
    LobeParameters lobe;
};

/// Every lobe under every light, in this order.
std::vector<ErrorCase> measure_errors(const std::vector<NamedLobe>& lobes, const std::vector<NamedLight>& lights,
                                      const Progress& progress);

}  // namespace burnish
