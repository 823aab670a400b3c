#include <burnish/light/cube_stack.h>

namespace burnish {

CubeStack::CubeStack(std::span<const int> sizes) {
    size_t total = 0;
    for (const int size : sizes) total += CubeLevel::float_count(size);
    const auto block = std::make_shared_for_overwrite<float[]>(total);
    float* begin = block.get();
    for (const int size : sizes) {
        m_levels.emplace_back(size, std::shared_ptr<float[]>(block, begin));
        begin += CubeLevel::float_count(size);
    }
}

}  // namespace burnish
