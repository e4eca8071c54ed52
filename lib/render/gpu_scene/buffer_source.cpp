#include "render/gpu_scene/buffer_source.h"

#include <candela/error.h>

#include <epoxy/gl.h>

#include <string>

namespace candela {

void requireBytes(const BufferRange& range, std::uint64_t size, const char* what) {
    const std::string name = "buffer " + std::to_string(range.name);
    if (glIsBuffer(range.name) != GL_TRUE)
        throw Error(ErrorKind::badInput, "", name + " is no buffer of the current context");
    GLint64 bytes = 0;
    glGetNamedBufferParameteri64v(range.name, GL_BUFFER_SIZE, &bytes);
    const auto available = static_cast<std::uint64_t>(bytes);
    if (range.offset <= available && size <= available - range.offset) return;
    throw Error(ErrorKind::badInput, "",
                name + " has " + std::to_string(available) + " bytes, but " + std::to_string(size) +
                    " from byte " + std::to_string(range.offset) + " on were expected, for " + what);
}

std::vector<std::byte> readBytes(const BufferRange& range, std::uint64_t size, const char* what) {
    requireBytes(range, size, what);
    std::vector<std::byte> bytes(size);
    if (size > 0)
        glGetNamedBufferSubData(range.name, static_cast<GLintptr>(range.offset),
                                static_cast<GLsizeiptr>(size), bytes.data());
    return bytes;
}

}  // namespace candela
