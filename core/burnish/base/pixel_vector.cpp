#include <burnish/base/pixel_vector.h>

#include <oneapi/tbb/scalable_allocator.h>

#include <sys/mman.h>

namespace burnish {
namespace {

constexpr size_t kHugePage = size_t{1} << 21;

}  // namespace

void* allocate_pixels(size_t bytes) {
    const bool is_large = bytes >= kHugePage / 2;
    const size_t alignment = is_large ? kHugePage : 64, rounded = (bytes + alignment - 1) / alignment * alignment;
    // oneTBB's allocator keeps large blocks for the next frame; the C library gives them back, to be faulted in anew.
    void* memory = scalable_aligned_malloc(rounded, alignment);
    if (!memory) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    if (is_large) madvise(memory, rounded, MADV_HUGEPAGE);  // advice: ordinary pages serve, too
#endif
    return memory;
}

void free_pixels(void* memory) noexcept { scalable_aligned_free(memory); }

}  // namespace burnish
