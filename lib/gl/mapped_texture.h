#pragma once

#include "gl/external_memory.h"
#include "gl/texture.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace candela::gl {

void deleteMemoryObject(GLuint name);

/// The memory of a texture, which the program reads in place: rows from the bottom, without gaps. It outlives
/// the texture. Content is what was drawn before a glFinish.
class TextureMapping {
  public:
    TextureMapping() = default;
    /// Imports the memory, for textures that glTextureStorageMem2DEXT makes.
    explicit TextureMapping(std::unique_ptr<ExternalMemory> memory);
    TextureMapping(TextureMapping&&) noexcept = default;
    TextureMapping& operator=(TextureMapping&&) noexcept = default;
    ~TextureMapping();

    /// Null where the driver keeps the texture's memory to itself.
    const std::byte* data() const { return memory_ ? memory_->data() : nullptr; }
    GLuint memoryObject() const { return object_.name(); }

  private:
    std::unique_ptr<ExternalMemory> memory_;
    Object<deleteMemoryObject> object_;
};

struct MappedTexture {
    TextureMapping mapping;  ///< First, so that the texture is destroyed before.
    Texture texture;
};

/// The form of a texture's pixels.
struct TexelFormat {
    GLenum internalFormat, format, type;
    std::size_t bytes;  ///< A pixel, which `format` and `type` take as well.
};

/// The UUIDs of the current context's device, where the driver imports memory by file descriptors.
std::optional<DeviceUuids> importingDevice();

/// As `Texture::target2d`, in memory of a device that `importingDevice` has found. Nothing where the driver
/// refuses it or does not lay its rows out one after the other, which is tested by writing some.
std::optional<MappedTexture> mappedTarget2d(const ExternalMemoryDevice& device, const TexelFormat& format,
                                            int width, int height, const char* label);

}  // namespace candela::gl
