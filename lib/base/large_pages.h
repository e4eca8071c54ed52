#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

namespace candela {

/// Has the system back memory that is written next by large pages, cleared on all cores, where it is large
/// enough for them: the page faults of small pages, one after the other, take longer than the copy. Where the
/// system refuses large pages, small ones are touched; does nothing where it knows no such advice.
void requestLargePages(void* memory, std::size_t bytes);

/// Reserves room for an array of up to many millions of elements that is filled next.
template <class T>
void reserveLarge(std::vector<T>& array, std::size_t count) {
    array.clear();
    array.reserve(count);
    requestLargePages(array.data(), count * sizeof(T));
}

/// Copies numbers into `count` elements that each hold just these, in blocks, and calls `visit(numbers,
/// size)` for each block while it is in the cache.
template <class Number, class T, class Visit>
void copyInBlocks(const Number* from, std::size_t count, std::vector<T>& out, Visit visit) {
    static_assert(sizeof(T) % sizeof(Number) == 0);
    constexpr std::size_t blockSize = 8192, numbers = sizeof(T) / sizeof(Number);
    reserveLarge(out, count);
    for (std::size_t at = 0; at < count; at += blockSize) {
        const std::size_t size = std::min(blockSize, count - at);
        out.resize(at + size);
        std::memcpy(static_cast<void*>(out.data() + at), from + at * numbers, size * sizeof(T));
        visit(reinterpret_cast<const Number*>(out.data() + at), size * numbers);
    }
}

}  // namespace candela
