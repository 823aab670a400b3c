#include <burnish/factor/averaged_start.h>

#include <burnish/factor/fill_texels.h>

namespace burnish {
Colors averaged_start(const Factors& layout, const SampleLookups& lookups, const Colors& values) {
    Colors texels = Colors::Zero(lookups.texels(), 4);
    Eigen::VectorXf weight = Eigen::VectorXf::Zero(lookups.texels());
    for (int s = 0; s < lookups.samples(); ++s)
        for (const BlendedTexels& blend : lookups.of(s))
            for (int i = 0; i < 4; ++i) {
                texels.row(blend.texel[i]) += values.row(s) * blend.weight[i];
                weight[blend.texel[i]] += blend.weight[i];
            }
    int first = 0;
    for (const FactorMap& map : layout.terms[0]) {
        const int count = map.layout.texels();
        std::vector<char> known(count);
        for (int i = 0; i < count; ++i)
            if ((known[i] = weight[first + i] > 0))
                texels.row(first + i) /= weight[first + i] * static_cast<float>(lookups.factors());
        fill_texels(map.layout, texels.middleRows(first, count), std::move(known));
        first += count;
    }
    return texels;
}

}  // namespace burnish
