#include <burnish/fit/search/lobe_basis.h>
#include <burnish/fit/search/lobe_transfer.h>

namespace burnish {

void lobe_basis(const LobeParameters& lobe, const NumberRange& r0, const TransferSamples& samples, size_t begin, size_t end,
                LobeBasis& basis) {
    LobeParameters both = lobe;
    both.fresnel.eta = {static_cast<float>(r0.min), static_cast<float>(r0.max), 0};
    basis.low.resize(end - begin);
    basis.high.resize(end - begin);
    for_each_transfer(both, samples, begin, end, [&](size_t j, const Color3f& p) {
        basis.low[j - begin] = p.x;
        basis.high[j - begin] = p.y;
    });
}

void set_weights(float low, float high, const LobeSpace& space, LobeParameters& lobe) {
    lobe.strength = low + high;
    if (!space.has_fresnel) return;
    const double share = lobe.strength > 0 ? high / lobe.strength : 0;
    lobe.fresnel.eta = Color3f(static_cast<float>(space.r0.min + share * (space.r0.max - space.r0.min)));
}

}  // namespace burnish
