#include "base/range_pool.h"

#include <algorithm>
#include <iterator>

namespace candela {

std::optional<std::uint64_t> RangePool::take(std::uint64_t count) {
    if (count == 0) return 0;
    const auto found = std::ranges::find_if(free_, [&](const auto& range) { return range.second >= count; });
    if (found == free_.end()) return std::nullopt;
    const auto [first, size] = *found;
    free_.erase(found);
    if (size > count) free_.emplace(first + count, size - count);
    return first;
}

void RangePool::free(std::uint64_t first, std::uint64_t count) {
    if (count == 0) return;
    auto next = free_.upper_bound(first);
    if (next != free_.begin()) {
        const auto before = std::prev(next);
        if (before->first + before->second == first) {
            first = before->first;
            count += before->second;
            free_.erase(before);
        }
    }
    if (next != free_.end() && first + count == next->first) {
        count += next->second;
        free_.erase(next);
    }
    free_.emplace(first, count);
}

void RangePool::growTo(std::uint64_t capacity) {
    free(capacity_, capacity - capacity_);
    capacity_ = capacity;
}

std::uint64_t RangePool::freeAtEnd() const {
    if (free_.empty()) return 0;
    const auto& [first, count] = *free_.rbegin();
    return first + count == capacity_ ? count : 0;
}

}  // namespace candela
