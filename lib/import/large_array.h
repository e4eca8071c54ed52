#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace candela {

/// Asks the system to back memory that was not yet touched with large pages, where it is large enough for
/// them: touching the pages one by one takes longer than copying into them. Does nothing where the system has
/// none.
void adviseLargePages(void* memory, std::size_t bytes) noexcept;

/// Makes room for an array that is filled next, which may have many millions of elements.
template <class T>
void reserveLarge(std::vector<T>& array, std::size_t count) {
    array.clear();
    array.reserve(count);
    adviseLargePages(array.data(), count * sizeof(T));
}

/// Copies an array, and calls `see(block, size)` for each run of what was copied while the processor's cache
/// still holds it.
template <class T, class See>
void copyInBlocks(const T* from, std::size_t count, std::vector<T>& out, See see) {
    constexpr std::size_t blockSize = 8192;
    reserveLarge(out, count);
    for (std::size_t at = 0; at < count; at += blockSize) {
        const std::size_t size = std::min(blockSize, count - at);
        out.insert(out.end(), from + at, from + at + size);
        see(out.data() + at, size);
    }
}

}  // namespace candela
