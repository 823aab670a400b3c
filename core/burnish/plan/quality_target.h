// What the user asks of a frame in place of knobs; zero: nothing is asked.
#pragma once

namespace burnish {

struct QualityTarget {
    float psnr = 0;       // dB: display PSNR of every material's overlay to the exact integral, at the material's own exposure
    float max_error = 0;  // of white: what the display signal of no pixel may miss by, as far as checked pixels tell
    float seconds = 0;    // by the clock a frame may take from surfaces to composite, light and tables included, files not

    bool is_set() const { return psnr > 0 || max_error > 0 || seconds > 0; }
};

}  // namespace burnish
