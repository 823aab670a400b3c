#include <burnish/base/pixel_vector.h>

#include <sys/mman.h>

#include <cstdlib>

namespace burnish {
namespace {

constexpr size_t kHugePage = size_t{1} << 21;

}  // namespace

void* allocate_pixels(size_t bytes) {
    const bool is_large = bytes >= kHugePage / 2;
    const size_t alignment = is_large ? kHugePage : 64, rounded = (bytes + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, rounded);
    if (!memory) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    if (is_large) madvise(memory, rounded, MADV_HUGEPAGE);  // advice: ordinary pages serve, too
#endif
    return memory;
}

void free_pixels(void* memory) noexcept { std::free(memory); }

}  // namespace burnish
