#include <burnish/factor/fill_texels.h>

namespace burnish {

void fill_texels(const DirectionMap& layout, Eigen::Ref<Colors> texels, std::vector<char> known) {
    for (bool is_filling = true; is_filling;) {
        is_filling = false;
        const std::vector<char> before = known;
        for (int texel = 0; texel < layout.texels(); ++texel) {
            if (before[texel]) continue;
            ColorRow sum = ColorRow::Zero();
            int count = 0;
            for (const int other : layout.neighbours(texel))
                if (before[other]) sum += texels.row(other).array(), ++count;
            if (count == 0) continue;
            texels.row(texel) = sum / static_cast<float>(count);
            known[texel] = is_filling = true;
        }
    }
}

}  // namespace burnish
