#pragma once

#include "gl/buffer.h"

#include <candela/error.h>

#include <cstddef>
#include <span>
#include <string>

namespace candela::gl {

/// What a mapping of a buffer is used for.
enum class MappingAccess : GLbitfield {
    overwrite = GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT,  ///< What the buffer held is lost.
    readWrite = GL_MAP_READ_BIT | GL_MAP_WRITE_BIT,
};

/// The first `bytes` of a buffer, mapped until the end of its scope. Throws `Error` (limit) where the device
/// can not map them.
class BufferMapping {
  public:
    BufferMapping(const Buffer& buffer, std::size_t bytes, MappingAccess access)
        : name_(buffer.name()),
          memory_(glMapNamedBufferRange(name_, 0, static_cast<GLsizeiptr>(bytes),
                                        static_cast<GLbitfield>(access))) {
        if (memory_ != nullptr) return;
        throw Error(ErrorKind::limit, "",
                    "the device can not map a buffer of " + std::to_string(bytes) + " bytes");
    }
    BufferMapping(const BufferMapping&) = delete;
    BufferMapping& operator=(const BufferMapping&) = delete;
    ~BufferMapping() { glUnmapNamedBuffer(name_); }

    template <typename T>
    std::span<T> elements(std::size_t first, std::size_t count) const {
        return {static_cast<T*>(memory_) + first, count};
    }
    float* floats() const { return static_cast<float*>(memory_); }

  private:
    GLuint name_;
    void* memory_;
};

}  // namespace candela::gl
