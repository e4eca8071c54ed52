#pragma once

#include "gl/texture.h"

#include <candela/image.h>
#include <candela/material.h>

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace candela {

/// A texture and the sampler it is read with, as GL names.
struct SampledTexture {
    GLuint texture = 0, sampler = 0;
    auto operator<=>(const SampledTexture&) const = default;
};

/// What a texture's texels mean, which decides the format an image is uploaded in.
enum class TextureInfo {
    color,  ///< sRGB-encoded colour (linear when the image is rgba32f).
    data,   ///< Linear numbers.
};

/// The images of a scene on the GPU, each uploaded once for each use that materials make of it, with mipmaps.
class GpuImages {
  public:
    explicit GpuImages(std::span<const Image> images);

    /// The texture of a material's slot; a white one where the slot is empty. Throws `Error` (limit) naming
    /// an image that is too large.
    SampledTexture get(const std::optional<Texture>& texture, TextureInfo use);

    /// From now on the constructor's images are not needed: pixels that no material has asked for yet are
    /// copied, others can be read back.
    void forgetSources();

  private:
    void restorePixels(std::uint32_t index);
    GLuint upload(std::uint32_t image, TextureInfo use);
    GLuint sampler(const Texture& texture);

    std::span<const Image> images_;  ///< The caller's until `forgetSources`, then `kept_`.
    std::vector<Image> kept_;        ///< Without pixels where these are in a texture.
    std::map<std::pair<std::uint32_t, TextureInfo>, gl::Texture> textures_;
    std::map<std::tuple<Wrap, Wrap, Filter, Filter>, gl::Sampler> samplers_;
    gl::Texture white_;
};

}  // namespace candela
