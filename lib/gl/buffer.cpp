#include "gl/buffer.h"

#include <candela/error.h>

#include <algorithm>
#include <string>

namespace candela::gl {

void deleteBuffer(GLuint name) {
    glDeleteBuffers(1, &name);
}
void deleteVertexArray(GLuint name) {
    glDeleteVertexArrays(1, &name);
}

namespace {

GLuint createBuffer(const char* label) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    glObjectLabel(GL_BUFFER, name, -1, label);
    return name;
}

GLuint createVertexArray(const char* label) {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    glObjectLabel(GL_VERTEX_ARRAY, name, -1, label);
    return name;
}

GLenum glUsage(BufferUsage usage) {
    switch (usage) {
        case BufferUsage::device:
            return GL_DYNAMIC_COPY;
        case BufferUsage::readback:
            return GL_STREAM_READ;
        default:
            return GL_DYNAMIC_DRAW;
    }
}

/// Calls `allocate`, which gives a buffer its storage of `size` bytes.
template <typename Allocate>
void requireMemory(std::size_t size, const Allocate& allocate) {
    while (glGetError() != GL_NO_ERROR) {
    }
    allocate();
    if (glGetError() != GL_OUT_OF_MEMORY) return;
    throw Error(ErrorKind::limit, "",
                "the device has no memory for a buffer of " + std::to_string(size) + " bytes");
}

constexpr GLbitfield mapping =
    GL_MAP_READ_BIT | GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;

/// Large enough that a copy takes longer than to start it.
constexpr std::size_t stagingSize = std::size_t{32} << 20;

/// Memory that the CPU writes and the device copies from, again and again.
class StagingBuffer {
  public:
    explicit StagingBuffer(std::size_t size) : object_(createBuffer("staging")) {
        requireMemory(
            size, [&] { glNamedBufferData(name(), static_cast<GLsizeiptr>(size), nullptr, GL_STREAM_DRAW); });
    }

    GLuint name() const { return object_.name(); }

    /// The driver keeps what commands still copy from the buffer.
    template <typename Fill>
    void write(std::size_t size, const Fill& fill) const {
        constexpr GLbitfield access = GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT;
        do {
            void* const memory = glMapNamedBufferRange(name(), 0, static_cast<GLsizeiptr>(size), access);
            if (memory == nullptr)
                throw Error(ErrorKind::limit, "",
                            "the device can not map a buffer of " + std::to_string(size) + " bytes");
            fill(std::span(static_cast<std::byte*>(memory), size));
            // False where the memory was lost meanwhile, such as to a change of the display mode.
        } while (glUnmapNamedBuffer(name()) == GL_FALSE);
    }

  private:
    Object<deleteBuffer> object_;
};

}  // namespace

Buffer::Buffer(const char* label, BufferUsage usage) : object_(createBuffer(label)), usage_(glUsage(usage)) {}

void Buffer::readBytes(std::size_t offset, std::span<std::byte> into) const {
    if (into.empty()) return;
    glGetNamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(into.size()),
                            into.data());
}

void Buffer::allocate(const char* label, std::size_t size, const void* data, GLbitfield access) {
    object_ = Object<deleteBuffer>(createBuffer(label));
    // OpenGL has no empty storage.
    capacity_ = std::max<std::size_t>(size, 4);
    requireMemory(capacity_, [&] {
        glNamedBufferStorage(name(), static_cast<GLsizeiptr>(capacity_), size == 0 ? nullptr : data, access);
    });
}

Buffer Buffer::immutable(const char* label, std::span<const std::byte> bytes) {
    Buffer buffer;
    buffer.allocate(label, bytes.size(), bytes.data(), 0);
    return buffer;
}

std::byte* Buffer::map() {
    void* const memory = glMapNamedBufferRange(name(), 0, static_cast<GLsizeiptr>(capacity_), mapping);
    memory_ = memory;
    if (memory != nullptr) return static_cast<std::byte*>(memory);
    throw Error(ErrorKind::limit, "",
                "the device can not map a buffer of " + std::to_string(capacity_) + " bytes");
}

Buffer Buffer::filledMapped(const char* label, const Layout& layout, const Fill& fill) {
    const std::size_t size = layout.count * layout.elementSize;
    Buffer buffer;
    buffer.allocate(label, size, nullptr, mapping);
    std::byte* const memory = buffer.map();
    fill(0, {memory, size});
    return buffer;
}

Buffer Buffer::filled(const char* label, const Layout& layout, const Fill& fill) {
    const std::size_t size = layout.count * layout.elementSize;
    Buffer buffer;
    buffer.allocate(label, size, nullptr, 0);
    if (size == 0) return buffer;
    const std::size_t part =
        std::min(size, std::max<std::size_t>(stagingSize / layout.elementSize, 1) * layout.elementSize);
    const StagingBuffer staging(part);
    for (std::size_t offset = 0; offset < size; offset += part) {
        const std::size_t bytes = std::min(part, size - offset);
        staging.write(bytes, [&](std::span<std::byte> to) { fill(offset, to); });
        buffer.copyFrom(staging.name(), 0, offset, bytes);
        glFlush();  // Copies while the next part is written, and lets go of memory that drivers rename.
    }
    return buffer;
}

Buffer Buffer::grown(const char* label, const Buffer& from, std::size_t size) {
    Buffer buffer;
    buffer.allocate(label, size, nullptr, from.memory_ != nullptr ? mapping : 0);
    if (from.name() != 0) buffer.copyFrom(from.name(), 0, 0, std::min(from.capacity_, buffer.capacity_));
    if (from.memory_ != nullptr) buffer.map();
    return buffer;
}

void Buffer::write(std::size_t offset, std::span<const std::byte> bytes) {
    if (bytes.empty()) return;
    const Buffer staging = immutable("staging", bytes);
    copyFrom(staging.name(), 0, offset, bytes.size());
}

void Buffer::copyFrom(GLuint source, std::size_t sourceOffset, std::size_t offset, std::size_t size) {
    if (size == 0) return;
    glCopyNamedBufferSubData(source, name(), static_cast<GLintptr>(sourceOffset),
                             static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size));
}

void Buffer::reserve(std::size_t size) {
    if (size <= capacity_) return;
    requireMemory(size, [&] { glNamedBufferData(name(), static_cast<GLsizeiptr>(size), nullptr, usage_); });
    capacity_ = size;
}

void Buffer::upload(std::span<const std::byte> bytes) {
    reserve(bytes.size());
    if (bytes.empty()) return;
    glInvalidateBufferData(name());
    glNamedBufferSubData(name(), 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

VertexArray::VertexArray(const char* label) : object_(createVertexArray(label)) {}

}  // namespace candela::gl
