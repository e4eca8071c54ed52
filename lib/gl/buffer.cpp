#include "gl/buffer.h"

#include <candela/error.h>

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

}  // namespace

Buffer::Buffer(const char* label) : object_(createBuffer(label)) {}

void Buffer::reserve(std::size_t size) {
    if (size <= capacity_) return;
    while (glGetError() != GL_NO_ERROR) {
    }
    glNamedBufferData(name(), static_cast<GLsizeiptr>(size), nullptr, GL_DYNAMIC_DRAW);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        throw Error(ErrorKind::limit, "",
                    "the device has no memory for a buffer of " + std::to_string(size) + " bytes");
    }
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
