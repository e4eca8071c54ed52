#include "render/gpu_scene/slots.h"

#include <algorithm>

namespace candela {

std::optional<std::uint64_t> RangePool::take(std::uint64_t count) {
    if (count == 0) return 0;
    for (auto range = free_.begin(); range != free_.end(); ++range) {
        if (range->second < count) continue;
        const std::uint64_t first = range->first;
        range->first += count;
        range->second -= count;
        if (range->second == 0) free_.erase(range);
        return first;
    }
    return std::nullopt;
}

void RangePool::free(std::uint64_t first, std::uint64_t count) {
    if (count == 0) return;
    auto next = std::ranges::lower_bound(free_, first, {}, &std::pair<std::uint64_t, std::uint64_t>::first);
    next = free_.insert(next, {first, count});
    if (next + 1 != free_.end() && first + count == (next + 1)->first) {
        next->second += (next + 1)->second;
        free_.erase(next + 1);
    }
    if (next == free_.begin()) return;
    const auto previous = next - 1;
    if (previous->first + previous->second != first) return;
    previous->second += next->second;
    free_.erase(next);
}

void RangePool::growTo(std::uint64_t capacity) {
    free(capacity_, capacity - capacity_);
    capacity_ = capacity;
}

}  // namespace candela
