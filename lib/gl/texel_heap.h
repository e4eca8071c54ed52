#pragma once

#include "base/range_pool.h"
#include "gl/texture.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace candela::gl {

/// A run of texels of a `TexelHeap`.
struct TexelRange {
    std::uint32_t first = 0, count = 0;
};

/// A buffer texture of which ranges are allocated and released. It grows; ranges keep their place.
class TexelHeap {
  public:
    TexelHeap(GLenum format, const char* label);

    /// Content is undefined. Throws `Error` (limit) beyond what the device holds; nothing is changed then.
    TexelRange allocate(std::uint32_t count);
    void release(TexelRange range);
    /// Replaces as much of a range as there are bytes.
    void write(TexelRange range, std::span<const std::byte> bytes);

    GLuint texture() const { return texture_.name(); }
    std::size_t bytes() const;

  private:
    void grow(std::uint64_t capacity);

    GLenum format_;
    const char* label_;
    BufferTexture texture_;
    RangePool pool_;  ///< Of texels.
};

}  // namespace candela::gl
