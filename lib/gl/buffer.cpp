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

}  // namespace

Buffer::Buffer(const char* label, BufferUsage usage) : object_(createBuffer(label)), usage_(glUsage(usage)) {}

void Buffer::readBytes(std::size_t offset, std::span<std::byte> into) const {
    if (into.empty()) return;
    glGetNamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(into.size()),
                            into.data());
}

void Buffer::allocate(const char* label, std::span<const std::byte> bytes, GLbitfield access) {
    object_ = Object<deleteBuffer>(createBuffer(label));
    // OpenGL has no empty storage.
    capacity_ = bytes.empty() ? 4 : bytes.size();
    requireMemory(capacity_, [&] {
        glNamedBufferStorage(name(), static_cast<GLsizeiptr>(capacity_),
                             bytes.empty() ? nullptr : bytes.data(), access);
    });
}

Buffer Buffer::immutable(const char* label, std::span<const std::byte> bytes) {
    Buffer buffer;
    buffer.allocate(label, bytes, 0);
    return buffer;
}

Buffer Buffer::immutableMapped(const char* label, std::span<const std::byte> bytes) {
    constexpr GLbitfield access = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    Buffer buffer;
    buffer.allocate(label, bytes, access);
    buffer.memory_ =
        glMapNamedBufferRange(buffer.name(), 0, static_cast<GLsizeiptr>(buffer.capacity_), access);
    if (buffer.memory_ != nullptr) return buffer;
    throw Error(ErrorKind::limit, "",
                "the device can not map a buffer of " + std::to_string(bytes.size()) + " bytes");
}

Buffer Buffer::grown(const char* label, const Buffer& from, std::size_t size) {
    constexpr GLbitfield mapped = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    const GLbitfield access = from.memory_ != nullptr ? mapped : 0;
    Buffer buffer;
    buffer.object_ = Object<deleteBuffer>(createBuffer(label));
    buffer.capacity_ = std::max<std::size_t>(size, 4);
    requireMemory(buffer.capacity_, [&] {
        glNamedBufferStorage(buffer.name(), static_cast<GLsizeiptr>(buffer.capacity_), nullptr, access);
    });
    if (from.name() != 0) buffer.copyFrom(from.name(), 0, 0, std::min(from.capacity_, buffer.capacity_));
    if (access == 0) return buffer;
    buffer.memory_ =
        glMapNamedBufferRange(buffer.name(), 0, static_cast<GLsizeiptr>(buffer.capacity_), access);
    if (buffer.memory_ != nullptr) return buffer;
    throw Error(ErrorKind::limit, "",
                "the device can not map a buffer of " + std::to_string(size) + " bytes");
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
