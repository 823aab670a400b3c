#include <burnish/light/filter/cube_stack.h>

#include <burnish/base/error.h>

#include <limits>
#include <string>

namespace burnish {

CubeStack::CubeStack(std::span<const int> sizes) {
    size_t total = 0;
    for (const int size : sizes) {
        m_layout.sizes.push_back(static_cast<float>(size));
        m_layout.begins.push_back(static_cast<int32_t>(total / 4));
        total += CubeLevel::float_count(size);
        if (total / 4 > static_cast<size_t>(std::numeric_limits<int32_t>::max()))
            throw Error(ErrorCode::bad_argument,
                        "cube map: expected at most 2^31 texels in all levels, found more at a face size of " +
                            std::to_string(size) + ". Use smaller faces.");
    }
    const auto block = std::make_shared_for_overwrite<float[]>(total);
    for (size_t k = 0; k < sizes.size(); ++k)
        m_levels.emplace_back(sizes[k], std::shared_ptr<float[]>(block, &block[4 * static_cast<size_t>(m_layout.begins[k])]));
    m_layout.rgba = block.get();
    m_layout.last_level = static_cast<float>(level_count() - 1);
    const size_t entries = std::max<size_t>(sizes.size() + 1, kShortTable);
    if (!sizes.empty())
        m_layout.sizes.resize(entries, m_layout.sizes.back()), m_layout.begins.resize(entries, m_layout.begins.back());
}

}  // namespace burnish
