#pragma once

#include "gl/object.h"

#include <cstddef>
#include <span>

namespace candela::gl {

void deleteBuffer(GLuint name);
void deleteVertexArray(GLuint name);

/// A buffer that grows to what is uploaded and keeps its storage while that suffices.
class Buffer {
  public:
    Buffer() = default;
    explicit Buffer(const char* label);

    /// Replaces the content. Throws `Error` (limit) when the device has no memory for it.
    void upload(std::span<const std::byte> bytes);
    template <typename T>
    void upload(std::span<const T> values) {
        upload(std::as_bytes(values));
    }
    /// Makes room for `size` bytes of undefined content.
    void reserve(std::size_t size);

    GLuint name() const { return object_.name(); }
    std::size_t capacity() const { return capacity_; }

  private:
    Object<deleteBuffer> object_;
    std::size_t capacity_ = 0;
};

/// The vertex layout of a draw.
class VertexArray {
  public:
    VertexArray() = default;
    explicit VertexArray(const char* label);

    GLuint name() const { return object_.name(); }

  private:
    Object<deleteVertexArray> object_;
};

}  // namespace candela::gl
