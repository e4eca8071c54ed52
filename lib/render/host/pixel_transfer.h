#pragma once

#include "gl/buffer.h"
#include "gl/texture.h"

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

namespace candela {

/// Pixels of textures on their way into a buffer that the CPU reads.
class PixelTransfer {
  public:
    PixelTransfer() : buffer_("pixel transfer", gl::BufferUsage::readback) {}
    PixelTransfer(const PixelTransfer&) = delete;
    PixelTransfer& operator=(const PixelTransfer&) = delete;
    ~PixelTransfer();

    /// A texture to read, all of it.
    struct Source {
        const gl::Texture& texture;
        GLenum format, type;
        int width, height;
        std::size_t bytes;  ///< Of a pixel.
    };
    /// Begins to copy the sources, one behind the other. Does not wait.
    void start(std::span<const Source> sources);
    /// Whether the copy has ended. Does not wait.
    bool isReady() const;
    /// Waits for its end. The bytes of source `index`.
    std::vector<std::byte> read(std::size_t index) const;

  private:
    gl::Buffer buffer_;
    std::vector<std::size_t> offsets_;  ///< Of the sources, and the end.
    GLsync fence_ = nullptr;
};

/// The bytes of a source as numbers.
template <typename T>
std::vector<T> elementsOf(const std::vector<std::byte>& bytes) {
    std::vector<T> elements(bytes.size() / sizeof(T));
    std::memcpy(elements.data(), bytes.data(), bytes.size());
    return elements;
}

}  // namespace candela
