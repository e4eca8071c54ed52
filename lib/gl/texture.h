#pragma once

#include "gl/buffer.h"
#include "gl/object.h"

namespace candela::gl {

void deleteTexture(GLuint name);
void deleteSampler(GLuint name);

/// A texture with immutable storage.
class Texture {
  public:
    Texture() = default;
    Texture(GLenum target, const char* label);
    /// A single-level 2D texture, sampled nearest and clamped: a render target. Throws `Error` (limit) when
    /// it does not fit the device.
    static Texture target2d(GLenum format, int width, int height, const char* label);

    /// Sampled nearest and clamped.
    void sampleNearest() const;

    GLuint name() const { return object_.name(); }

  private:
    Object<deleteTexture> object_;
};

/// Of a format of `BufferTexture`: R32, RG32 and RGBA32, of floats or unsigned integers.
std::size_t bytesPerTexel(GLenum format);

/// A buffer that shaders read with `texelFetch`.
class BufferTexture {
  public:
    BufferTexture() = default;
    BufferTexture(GLenum format, const char* label);

    /// Replaces the content; there is always at least one texel. Throws `Error` (limit) beyond
    /// GL_MAX_TEXTURE_BUFFER_SIZE texels.
    void upload(std::span<const std::byte> bytes);
    template <typename T>
    void upload(std::span<const T> values) {
        upload(std::as_bytes(values));
    }

    /// Makes room for `size` bytes of undefined content. Throws as `upload` does.
    void reserve(std::size_t size);
    /// Throws `Error` (limit) where the device's buffer textures hold fewer.
    static void requireTexels(std::size_t texels);

    GLuint name() const { return texture_.name(); }
    GLuint buffer() const { return buffer_.name(); }

  private:
    Buffer buffer_;
    Texture texture_;
    GLenum format_ = 0;
};

class Sampler {
  public:
    Sampler() = default;
    explicit Sampler(const char* label);

    GLuint name() const { return object_.name(); }

  private:
    Object<deleteSampler> object_;
};

}  // namespace candela::gl
