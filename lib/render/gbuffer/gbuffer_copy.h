#pragma once

#include "render/gbuffer/gbuffer_targets.h"

#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// A G-buffer in the CPU's memory, for passes that run there. Each texture is read when it is first asked for
/// after `reset`: in place where it is mapped, else read back. Rows from the bottom. Pixels outside of the
/// rectangle that is read are undefined.
class GBufferCopy {
  public:
    enum class Mapped {
        inPlace,  ///< Mapped textures are not copied: what is drawn to the targets later is seen.
        copied,   ///< They are, so that the targets may be drawn to meanwhile.
    };

    explicit GBufferCopy(Mapped mapped = Mapped::inPlace) : mapped_(mapped) {}

    /// From the next `reset` on.
    void setMapped(Mapped mapped) { mapped_ = mapped; }

    /// Starts a copy of `targets`, which outlive its use: of all of them, or of a rectangle.
    void reset(const GBufferTargets& targets);
    void reset(const GBufferTargets& targets, const gl::PixelRectangle& rectangle);

    const gl::PixelRectangle& rectangle() const { return rectangle_; }

    std::span<const std::uint32_t> surfaces();  ///< Two words a pixel: `GBufferTexel`.
    std::span<const float> depth();             ///< Reversed.
    std::span<const std::uint32_t> shadowWords();
    std::span<const std::uint8_t> occlusion();
    std::span<const std::uint32_t> lobeWords();            ///< Four words a pixel.
    std::span<const std::uint32_t> diffuseTransmission();  ///< One word a pixel.

  private:
    /// `read` fills `values`, of which a pixel has `perPixel`, unless `mapping` has them.
    template <typename T, typename Read>
    std::span<const T> once(std::vector<T>& values, std::size_t perPixel, unsigned part,
                            const gl::TextureMapping& mapping, const Read& read);
    std::span<const std::uint32_t> words(std::vector<std::uint32_t>& values, std::size_t perPixel,
                                         unsigned part, int output);
    const gl::TextureMapping& mappingOf(int output) const;

    Mapped mapped_;
    const GBufferTargets* targets_ = nullptr;
    gl::PixelRectangle rectangle_;
    unsigned present_ = 0;  ///< A bit for each of the following.
    std::vector<std::uint32_t> surfaces_, shadowWords_, lobeWords_, diffuseTransmission_;
    std::vector<float> depth_;
    std::vector<std::uint8_t> occlusion_;
};

}  // namespace candela
