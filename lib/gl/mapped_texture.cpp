#include "gl/mapped_texture.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

namespace candela::gl {

void deleteMemoryObject(GLuint name) {
    glDeleteMemoryObjectsEXT(1, &name);
}

namespace {

void clearErrors() {
    while (glGetError() != GL_NO_ERROR) {
    }
}

std::size_t roundedUp(int size, int to) {
    return static_cast<std::size_t>((size + to - 1) / to * to);
}

/// Bytes of which each row has others. As floats they are in [0, 1], where depth is not clamped.
std::vector<std::byte> testRow(std::size_t bytes, int row) {
    std::vector<std::byte> values(bytes);
    for (std::size_t i = 0; i < bytes; ++i) {
        const std::size_t mixed = i / 4 * 7 + i % 4 * 41 + static_cast<std::size_t>(row) * 13;
        // Little-endian: the highest byte of each word.
        values[i] = i % 4 == 3 ? std::byte{0x3e} : static_cast<std::byte>(mixed & 0x7f);
    }
    return values;
}

/// Whether what the driver writes to a row is where a layout without gaps has it.
bool hasPackedRows(const MappedTexture& mapped, const TexelFormat& format, int width, int height) {
    const std::size_t rowBytes = static_cast<std::size_t>(width) * format.bytes;
    const std::array rows{0, std::min(1, height - 1), height / 2, height - 1};
    for (const int row : rows) {
        glTextureSubImage2D(mapped.texture.name(), 0, 0, row, width, 1, format.format, format.type,
                            testRow(rowBytes, row).data());
    }
    glFinish();
    return glGetError() == GL_NO_ERROR && std::ranges::all_of(rows, [&](int row) {
               const std::byte* data = mapped.mapping.data() + static_cast<std::size_t>(row) * rowBytes;
               return std::memcmp(data, testRow(rowBytes, row).data(), rowBytes) == 0;
           });
}

}  // namespace

TextureMapping::TextureMapping(std::unique_ptr<ExternalMemory> memory) : memory_(std::move(memory)) {
    GLuint name = 0;
    glCreateMemoryObjectsEXT(1, &name);
    object_ = Object<deleteMemoryObject>(name);
    glImportMemoryFdEXT(name, memory_->size(), GL_HANDLE_TYPE_OPAQUE_FD_EXT, memory_->exportDescriptor());
}

TextureMapping::~TextureMapping() {
    // Drivers need not keep the memory for what they still have to draw.
    if (memory_) glFinish();
}

std::optional<DeviceUuids> importingDevice() {
    if (!epoxy_has_gl_extension("GL_EXT_memory_object_fd")) return std::nullopt;
    clearErrors();
    DeviceUuids uuids;
    glGetUnsignedBytei_vEXT(GL_DEVICE_UUID_EXT, 0, uuids.device.data());
    glGetUnsignedBytevEXT(GL_DRIVER_UUID_EXT, uuids.driver.data());
    return glGetError() == GL_NO_ERROR ? std::optional(uuids) : std::nullopt;
}

std::optional<MappedTexture> mappedTarget2d(const ExternalMemoryDevice& device, const TexelFormat& format,
                                            int width, int height, const char* label) {
    // Room for drivers that round sizes up to blocks, and more for what they keep besides.
    constexpr int block = 64;
    constexpr std::size_t extra = 4096;
    auto memory = device.allocate(roundedUp(width, block) * roundedUp(height, block) * format.bytes + extra);
    if (!memory) return std::nullopt;
    clearErrors();
    MappedTexture mapped{TextureMapping(std::move(memory)), Texture(GL_TEXTURE_2D, label)};
    const GLuint name = mapped.texture.name();
    glTextureParameteri(name, GL_TEXTURE_TILING_EXT, GL_LINEAR_TILING_EXT);
    if (glGetError() != GL_NO_ERROR) return std::nullopt;
    glTextureStorageMem2DEXT(name, 1, format.internalFormat, width, height, mapped.mapping.memoryObject(), 0);
    if (glGetError() != GL_NO_ERROR || !hasPackedRows(mapped, format, width, height)) {
        clearErrors();
        return std::nullopt;
    }
    mapped.texture.sampleNearest();
    return mapped;
}

}  // namespace candela::gl
