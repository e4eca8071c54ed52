#include "gl/texel_heap.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace candela::gl {

TexelHeap::TexelHeap(GLenum format, const char* label)
    : format_(format), label_(label), texture_(format, label) {}

std::size_t TexelHeap::bytes() const {
    return capacity_ * bytesPerTexel(format_);
}

TexelRange TexelHeap::allocate(std::uint32_t count) {
    if (count == 0) return {};
    auto found = std::ranges::find_if(free_, [&](const auto& range) { return range.second >= count; });
    if (found == free_.end()) {
        const std::uint64_t atEnd =
            !free_.empty() && free_.rbegin()->first + free_.rbegin()->second == capacity_
                ? free_.rbegin()->second
                : 0;
        const std::uint64_t needed = capacity_ + count - atEnd;
        const std::uint64_t roomy = std::max<std::uint64_t>(needed, capacity_ + capacity_ / 2);
        grow(static_cast<std::uint32_t>(
            std::min<std::uint64_t>(roomy, std::numeric_limits<std::uint32_t>::max())));
        found = std::prev(free_.end());
    }
    const TexelRange range{found->first, count};
    const std::uint32_t rest = found->second - count;
    free_.erase(found);
    if (rest > 0) free_.emplace(range.first + count, rest);
    return range;
}

void TexelHeap::release(TexelRange range) {
    if (range.count == 0) return;
    auto next = free_.upper_bound(range.first);
    if (next != free_.begin()) {
        const auto before = std::prev(next);
        if (before->first + before->second == range.first) {
            range = {before->first, before->second + range.count};
            free_.erase(before);
        }
    }
    if (next != free_.end() && range.first + range.count == next->first) {
        range.count += next->second;
        free_.erase(next);
    }
    free_.emplace(range.first, range.count);
}

void TexelHeap::write(TexelRange range, std::span<const std::byte> bytes) {
    if (bytes.empty()) return;
    glNamedBufferSubData(texture_.buffer(), static_cast<GLintptr>(range.first * bytesPerTexel(format_)),
                         static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void TexelHeap::grow(std::uint32_t capacity) {
    BufferTexture larger(format_, label_);
    larger.reserve(capacity * bytesPerTexel(format_));
    if (capacity_ > 0) {
        glCopyNamedBufferSubData(texture_.buffer(), larger.buffer(), 0, 0,
                                 static_cast<GLsizeiptr>(capacity_ * bytesPerTexel(format_)));
    }
    texture_ = std::move(larger);
    const TexelRange added{capacity_, capacity - capacity_};
    capacity_ = capacity;
    release(added);
}

}  // namespace candela::gl
