#include "gl/texel_heap.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace candela::gl {

TexelHeap::TexelHeap(GLenum format, const char* label)
    : format_(format), label_(label), texture_(format, label) {}

std::size_t TexelHeap::bytes() const {
    return pool_.capacity() * bytesPerTexel(format_);
}

TexelRange TexelHeap::allocate(std::uint32_t count) {
    std::optional<std::uint64_t> first = pool_.take(count);
    if (!first) {
        const std::uint64_t needed = pool_.capacity() + count - pool_.freeAtEnd();
        const std::uint64_t roomy = std::max(needed, pool_.capacity() + pool_.capacity() / 2);
        grow(std::min<std::uint64_t>(roomy, std::numeric_limits<std::uint32_t>::max()));
        first = pool_.take(count);
    }
    return {static_cast<std::uint32_t>(*first), count};
}

void TexelHeap::release(TexelRange range) {
    pool_.free(range.first, range.count);
}

void TexelHeap::write(TexelRange range, std::span<const std::byte> bytes) {
    if (bytes.empty()) return;
    glNamedBufferSubData(texture_.buffer(), static_cast<GLintptr>(range.first * bytesPerTexel(format_)),
                         static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void TexelHeap::grow(std::uint64_t capacity) {
    BufferTexture larger(format_, label_);
    larger.reserve(capacity * bytesPerTexel(format_));
    if (pool_.capacity() > 0) {
        glCopyNamedBufferSubData(texture_.buffer(), larger.buffer(), 0, 0, static_cast<GLsizeiptr>(bytes()));
    }
    texture_ = std::move(larger);
    pool_.growTo(capacity);
}

}  // namespace candela::gl
