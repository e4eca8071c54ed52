#include "render/display/memory_display.h"

#include "base/thread_pool.h"
#include "render/instruction_sets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace candela {

namespace {

constexpr int rowsPerShare = 8;

std::size_t pixelCount(const MemoryPicture& picture) {
    return static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
}

/// `codes` is that of the first pixel of the lowest row.
void writeCodes(const DisplayKernel& kernel, const MemoryPicture& picture, const DisplayTransform& transform,
                std::uint32_t* codes, std::ptrdiff_t rowStep) {
    const std::span<const DisplayStep> steps = displaySteps(transform);
    const DisplayJob job{picture.radiance.data(),
                         static_cast<float>(std::exp2(transform.options().exposure)),
                         picture.width,
                         steps.data(),
                         steps.size(),
                         codes,
                         rowStep,
                         static_cast<std::uint32_t>(picture.place.x),
                         static_cast<std::uint32_t>(picture.place.y)};
    const auto shares = static_cast<std::size_t>((picture.height + rowsPerShare - 1) / rowsPerShare);
    ThreadPool::shared()->run(shares, [&](std::size_t share, unsigned) {
        const int first = static_cast<int>(share) * rowsPerShare;
        kernel.display(job, first, std::min(first + rowsPerShare, picture.height));
    });
}

/// The attachment that the first output of the framebuffer bound for drawing goes to.
GLenum firstAttachment() {
    GLint buffer = GL_NONE;
    glGetIntegerv(GL_DRAW_BUFFER0, &buffer);
    return static_cast<GLenum>(buffer == GL_BACK ? GL_BACK_LEFT : buffer);
}

/// A level of a texture.
struct TextureLevel {
    GLuint texture;
    GLint level;
};

/// What a framebuffer shows codes of, where it is an RGBA8 texture that has all of their pixels.
std::optional<TextureLevel> levelUnder(const FrameTarget& target, int width, int height) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
    const auto attached = [&target, attachment = firstAttachment()](GLenum parameter) {
        GLint value = 0;
        glGetNamedFramebufferAttachmentParameteriv(target.framebuffer, attachment, parameter, &value);
        return value;
    };
    if (attached(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_TEXTURE) return std::nullopt;
    const TextureLevel found{static_cast<GLuint>(attached(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)),
                             attached(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL)};
    GLint form = GL_NONE;
    glGetTextureParameteriv(found.texture, GL_TEXTURE_TARGET, &form);
    if (form != GL_TEXTURE_2D) return std::nullopt;
    const auto valueOf = [&found](GLenum parameter) {
        GLint value = 0;
        glGetTextureLevelParameteriv(found.texture, found.level, parameter, &value);
        return value;
    };
    const bool isInside = target.x >= 0 && target.y >= 0 && width <= valueOf(GL_TEXTURE_WIDTH) - target.x &&
                          height <= valueOf(GL_TEXTURE_HEIGHT) - target.y;
    return isInside && valueOf(GL_TEXTURE_INTERNAL_FORMAT) == GL_RGBA8 ? std::optional(found) : std::nullopt;
}

}  // namespace

extern const DisplayKernel displayKernelBaseline;
#if defined(__x86_64__)
extern const DisplayKernel displayKernelAvx2, displayKernelAvx512;
#endif

std::vector<const DisplayKernel*> displayKernels() {
    std::vector<const DisplayKernel*> kernels;
#if defined(__x86_64__)
    if (widestInstructionSet() >= InstructionSet::avx512) kernels.push_back(&displayKernelAvx512);
    if (widestInstructionSet() >= InstructionSet::avx2) kernels.push_back(&displayKernelAvx2);
#endif
    kernels.push_back(&displayKernelBaseline);
    return kernels;
}

MemoryDisplay::MemoryDisplay(const DisplayKernel& kernel) : kernel_(&kernel) {}

std::vector<std::uint8_t> MemoryDisplay::codes(const MemoryPicture& picture,
                                               const DisplayTransform& transform) const {
    std::vector<std::uint8_t> bytes(4 * pixelCount(picture));
    auto* top = reinterpret_cast<std::uint32_t*>(bytes.data());
    const std::ptrdiff_t width = picture.width;
    writeCodes(*kernel_, picture, transform, top + (picture.height - 1) * width, -width);
    return bytes;
}

bool MemoryDisplay::suits(const FrameTarget& target) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
    GLint samples = 0, buffers = 0, first = GL_NONE;
    glGetIntegerv(GL_SAMPLES, &samples);
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &buffers);
    glGetIntegerv(GL_DRAW_BUFFER0, &first);
    if (samples > 0 || first == GL_NONE) return false;
    for (GLint i = 1; i < buffers; ++i) {
        GLint other = GL_NONE;
        glGetIntegerv(static_cast<GLenum>(GL_DRAW_BUFFER0 + i), &other);
        if (other != GL_NONE) return false;
    }
    const GLenum attachment = firstAttachment();
    for (const GLenum channel : {GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE,
                                 GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE}) {
        GLint bits = 0;
        glGetNamedFramebufferAttachmentParameteriv(target.framebuffer, attachment, channel, &bits);
        if (bits > 8) return false;
    }
    return true;
}

void MemoryDisplay::render(const MemoryPicture& picture, const DisplayTransform& transform,
                           const FrameTarget& target) {
    const int width = picture.width, height = picture.height;
    codes_.resize(pixelCount(picture));
    writeCodes(*kernel_, picture, transform, codes_.data(), width);
    if (const auto shown = levelUnder(target, width, height)) {
        glTextureSubImage2D(shown->texture, shown->level, target.x, target.y, width, height, GL_RGBA,
                            GL_UNSIGNED_BYTE, codes_.data());
        return;
    }
    if (!source_ || source_->width != width || source_->height != height) source_.emplace(width, height);
    // A copy takes a tenth of what llvmpipe needs to draw the same through a shader.
    glTextureSubImage2D(source_->texture.name(), 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE,
                        codes_.data());
    glBlitNamedFramebuffer(source_->framebuffer.name(), target.framebuffer, 0, 0, width, height, target.x,
                           target.y, target.x + width, target.y + height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace candela
