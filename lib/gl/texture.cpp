#include "gl/texture.h"

#include <candela/error.h>

#include <algorithm>
#include <string>

namespace candela::gl {

void deleteTexture(GLuint name) {
    glDeleteTextures(1, &name);
}
void deleteSampler(GLuint name) {
    glDeleteSamplers(1, &name);
}

namespace {

GLuint createTexture(GLenum target, const char* label) {
    GLuint name = 0;
    glCreateTextures(target, 1, &name);
    glObjectLabel(GL_TEXTURE, name, -1, label);
    return name;
}

GLuint createSampler(const char* label) {
    GLuint name = 0;
    glCreateSamplers(1, &name);
    glObjectLabel(GL_SAMPLER, name, -1, label);
    return name;
}

}  // namespace

std::size_t bytesPerTexel(GLenum format) {
    switch (format) {
        case GL_R32F:
        case GL_R32UI:
            return 4;
        case GL_RG32F:
        case GL_RG32UI:
            return 8;
        default:
            return 16;  // GL_RGBA32F and GL_RGBA32UI.
    }
}

Texture::Texture(GLenum target, const char* label) : object_(createTexture(target, label)) {}

Texture Texture::target2d(GLenum format, int width, int height, const char* label) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (width > largest || height > largest) {
        throw Error(ErrorKind::limit, "",
                    "a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                        " pixels is asked for, but this device holds " + std::to_string(largest) + "x" +
                        std::to_string(largest) + " at most");
    }
    while (glGetError() != GL_NO_ERROR) {
    }
    Texture texture(GL_TEXTURE_2D, label);
    glTextureStorage2D(texture.name(), 1, format, width, height);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        throw Error(ErrorKind::limit, "",
                    "the device has no memory for a picture of " + std::to_string(width) + "x" +
                        std::to_string(height) + " pixels");
    }
    texture.sampleNearest();
    return texture;
}

void Texture::sampleNearest() const {
    glTextureParameteri(name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTextureParameteri(name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

BufferTexture::BufferTexture(GLenum format, const char* label)
    : buffer_(label, BufferUsage::dynamic), texture_(GL_TEXTURE_BUFFER, label), format_(format) {
    upload(std::span<const std::byte>{});
}

void BufferTexture::requireTexels(std::size_t texels) {
    GLint maxTexels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &maxTexels);
    if (texels <= static_cast<std::size_t>(maxTexels)) return;
    throw Error(ErrorKind::limit, "",
                std::to_string(texels) +
                    " texels of scene data are asked for, but this device's buffer textures hold " +
                    std::to_string(maxTexels) + " at most");
}

void BufferTexture::reserve(std::size_t size) {
    requireTexels(size / bytesPerTexel(format_));
    const std::size_t before = buffer_.capacity();
    buffer_.reserve(std::max<std::size_t>(size, bytesPerTexel(format_)));
    if (buffer_.capacity() != before) glTextureBuffer(texture_.name(), format_, buffer_.name());
}

void BufferTexture::upload(std::span<const std::byte> bytes) {
    reserve(bytes.size());
    buffer_.upload(bytes);
}

Sampler::Sampler(const char* label) : object_(createSampler(label)) {}

}  // namespace candela::gl
