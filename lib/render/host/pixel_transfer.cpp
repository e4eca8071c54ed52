#include "render/host/pixel_transfer.h"

#include <algorithm>

namespace candela {

PixelTransfer::~PixelTransfer() {
    if (fence_ != nullptr) glDeleteSync(fence_);
}

void PixelTransfer::start(std::span<const Source> sources) {
    offsets_.assign(1, 0);
    for (const Source& source : sources) {
        const std::size_t pixels =
            static_cast<std::size_t>(source.width) * static_cast<std::size_t>(source.height);
        offsets_.push_back(offsets_.back() + pixels * source.bytes);
    }
    buffer_.reserve(offsets_.back());
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.name());
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const Source& source = sources[i];
        // OpenGL takes the size as an int: textures of 2 GiB and more are read in bands.
        const std::size_t rowBytes = static_cast<std::size_t>(source.width) * source.bytes;
        const int rows = static_cast<int>(std::max<std::size_t>(1, (std::size_t{1} << 30) / rowBytes));
        for (int y = 0; y < source.height; y += rows) {
            const int count = std::min(rows, source.height - y);
            glGetTextureSubImage(
                source.texture.name(), 0, 0, y, 0, source.width, count, 1, source.format, source.type,
                static_cast<GLsizei>(rowBytes * static_cast<std::size_t>(count)),
                reinterpret_cast<void*>(offsets_[i] + rowBytes * static_cast<std::size_t>(y)));
        }
    }
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();  // Else the fence may never be reached while the host only asks for it.
}

bool PixelTransfer::isReady() const {
    return glClientWaitSync(fence_, 0, 0) != GL_TIMEOUT_EXPIRED;
}

std::vector<std::byte> PixelTransfer::read(std::size_t index) const {
    return buffer_.read<std::byte>(offsets_[index], offsets_[index + 1] - offsets_[index]);
}

}  // namespace candela
