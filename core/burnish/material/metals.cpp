// The numbers were fitted once: for each metal the unpolarised reflectance of the measured spectra eta(lambda), k(lambda)
// (Palik and SOPRA tables, as distributed with Mitsuba) was turned into linear Rec.709 under D65 with the CIE 1931 observer
// at 13 angles from 0 to 89 degrees; eta and k of a channel are the index whose exact conductor Fresnel comes nearest. Largest
// error at any angle: 0.003 (copper), gold's red 0.024, because its true red is 1.02, out of any conductor's reach.
#include <burnish/material/metals.h>

namespace burnish {

std::span<const Metal> metals() {
    static const Metal all[] = {
        {"silver", "silver", {0.1289f, 0.1244f, 0.1512f}, {4.0860f, 3.3409f, 2.4124f}},
        {"aluminium", "aluminum", {1.4127f, 0.9313f, 0.5894f}, {7.6986f, 6.6090f, 5.3529f}},
        {"gold", "gold", {0.1249f, 0.4064f, 1.5622f}, {10.6374f, 2.3583f, 1.7146f}},
        {"copper", "copper", {0.1514f, 0.9731f, 1.2093f}, {3.3046f, 2.6232f, 2.3634f}},
        {"chromium", "chrome", {3.6766f, 3.0826f, 1.8670f}, {4.2912f, 4.4503f, 4.1304f}},
        {"tungsten", "tungsten", {3.6349f, 3.4824f, 3.3004f}, {2.9158f, 2.7477f, 2.5100f}},
    };
    return all;
}

}  // namespace burnish
