// The gold of Cook & Torrance 1982 as the fourth source factors it: Beckmann's D, the V-shaped grooves' G and Fresnel of gold, with a
// diffuse share beside them.
#pragma once

#include <burnish/factor/parametrization.h>
#include <burnish/material/fresnel.h>
#include <burnish/material/metals.h>

#include <algorithm>
#include <cmath>

namespace burnish {

struct CookTorrance {
    float m;            // root mean square slope
    float diffuse = 0;  // albedo of what is reflected evenly, in the metal's colour

    Color3f operator()(const DirectionPair& pair) const {
        const Metal& gold = *std::ranges::find(metals(), "gold", &Metal::name);
        const Vec3f h = (pair.a + pair.b).normalized();
        const float nh2 = h.z * h.z, vh = h.dot(pair.b), least = std::min(pair.a.z, pair.b.z);
        const float D = std::exp((nh2 - 1) / (nh2 * m * m)) / (m * m * nh2 * nh2);
        const float G = std::min(1.0f, 2 * h.z * least / vh), specular = D * G / (kPi * pair.a.z * pair.b.z);
        Color3f f;
        for (int channel = 0; channel < 3; ++channel)
            f[channel] = conductor_fresnel(gold.eta[channel], gold.k[channel], vh) * specular +
                         conductor_fresnel(gold.eta[channel], gold.k[channel], 1) * diffuse / kPi;
        return f;
    }
};

}  // namespace burnish
