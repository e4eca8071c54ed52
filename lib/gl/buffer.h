#pragma once

#include "gl/object.h"

#include <epoxy/gl.h>

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace candela::gl {

void deleteBuffer(GLuint name);
void deleteVertexArray(GLuint name);

/// Who writes a buffer and how often: where a driver keeps it follows from that.
enum class BufferUsage {
    dynamic,   ///< The CPU, when the scene or the frame changes.
    device,    ///< Shaders or copies on the device.
    readback,  ///< The device, and the CPU reads it.
};

/// A buffer that grows to what is uploaded and keeps its storage while that suffices, or an immutable one.
class Buffer {
  public:
    Buffer() = default;
    Buffer(const char* label, BufferUsage usage);
    /// A buffer whose content never changes. Throws `Error` (limit) when the device has no memory for it.
    static Buffer immutable(const char* label, std::span<const std::byte> bytes);
    template <typename T>
    static Buffer immutable(const char* label, std::span<const T> values) {
        return immutable(label, std::as_bytes(values));
    }

    /// How many elements of how many bytes a buffer has.
    struct Layout {
        std::size_t count = 0, elementSize = 1;
    };
    /// Writes whole elements, those from byte `offset` of the buffer on, to memory that is not to be read.
    using Fill = std::function<void(std::size_t offset, std::span<std::byte> bytes)>;
    /// A buffer whose content never changes, written part after part into memory that the device copies it
    /// from. Throws `Error` (limit) when the device has no memory for it.
    static Buffer filled(const char* label, const Layout& layout, const Fill& fill);
    /// The same, and the CPU reads it through `mapped`: written at once to where it stays. For devices that
    /// keep buffers in the CPU's memory.
    static Buffer filledMapped(const char* label, const Layout& layout, const Fill& fill);
    /// The content of a buffer of `filledMapped`.
    template <typename T>
    std::span<const T> mapped() const {
        return {static_cast<const T*>(memory_), capacity_ / sizeof(T)};
    }

    /// An immutable buffer of `size` bytes, mapped as `from` is, with the content of `from` and nothing
    /// defined behind it. Throws `Error` (limit) when the device has no memory for it.
    static Buffer grown(const char* label, const Buffer& from, std::size_t size);
    /// Replaces bytes of an immutable buffer from `offset` on: by a copy on the device, in the order of
    /// commands.
    void write(std::size_t offset, std::span<const std::byte> bytes);
    template <typename T>
    void write(std::size_t first, std::span<const T> values) {
        write(first * sizeof(T), std::as_bytes(values));
    }
    /// The same from another buffer.
    void copyFrom(GLuint source, std::size_t sourceOffset, std::size_t offset, std::size_t size);

    /// Replaces the content. Throws `Error` (limit) when the device has no memory for it. Not for an
    /// immutable buffer.
    void upload(std::span<const std::byte> bytes);
    template <typename T>
    void upload(std::span<const T> values) {
        upload(std::as_bytes(values));
    }
    /// Makes room for `size` bytes of undefined content.
    void reserve(std::size_t size);

    /// Reads back `count` elements of type T, from element `first` on. Waits for what writes them.
    template <typename T>
    std::vector<T> read(std::size_t first, std::size_t count) const {
        std::vector<T> elements(count);
        readBytes(first * sizeof(T), std::as_writable_bytes(std::span(elements)));
        return elements;
    }

    GLuint name() const { return object_.name(); }
    std::size_t capacity() const { return capacity_; }

  private:
    /// `data` are `size` bytes of content, or null.
    void allocate(const char* label, std::size_t size, const void* data, GLbitfield access);
    std::byte* map();
    void readBytes(std::size_t offset, std::span<std::byte> into) const;

    Object<deleteBuffer> object_;
    GLenum usage_ = GL_DYNAMIC_DRAW;
    std::size_t capacity_ = 0;
    const void* memory_ = nullptr;
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
