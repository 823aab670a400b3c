// Vectors for as many values as a frame has pixels: what they hold is left unset unless a value is given, and large ones lie in
// huge pages, where the system has them, and are used again. Zeroes that are overwritten at once and thousands of page faults
// take longer than what is done with the pixels.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace burnish {

/// Memory of unset values. Throws std::bad_alloc.
void* allocate_pixels(size_t bytes);
void free_pixels(void* memory) noexcept;

template <class T>
struct PixelAllocator {
    using value_type = T;

    PixelAllocator() = default;
    template <class U>
    PixelAllocator(const PixelAllocator<U>&) {}

    T* allocate(size_t count) { return static_cast<T*>(allocate_pixels(count * sizeof(T))); }
    void deallocate(T* values, size_t) noexcept { free_pixels(values); }
    template <class U, class... Values>
    void construct(U* at, Values&&... values) {
        if constexpr (sizeof...(Values) == 0)
            ::new (static_cast<void*>(at)) U;
        else
            ::new (static_cast<void*>(at)) U(std::forward<Values>(values)...);
    }
    bool operator==(const PixelAllocator&) const { return true; }
};

/// `resize` leaves new values unset; `assign` and constructors that take a value set them.
template <class T>
using PixelVector = std::vector<T, PixelAllocator<T>>;

}  // namespace burnish
