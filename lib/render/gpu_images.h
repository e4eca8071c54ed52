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

namespace candela {

/// A texture and the sampler it is read with, as GL names.
struct SampledTexture {
    GLuint texture = 0, sampler = 0;
    auto operator<=>(const SampledTexture&) const = default;
};

/// What a texture's texels mean, which decides the format an image is uploaded in.
enum class TextureUse {
    color,  ///< sRGB-encoded colour (linear when the image is rgba32f).
    data,   ///< Linear numbers.
};

/// The images of a scene on the GPU, each uploaded once for each use that materials make of it, with mipmaps.
class GpuImages {
  public:
    explicit GpuImages(std::span<const Image> images);

    /// The texture of a material's slot; a white one where the slot is empty. Throws `Error` (limit) naming
    /// an image that is too large.
    SampledTexture get(const std::optional<Texture>& texture, TextureUse use);

  private:
    GLuint upload(std::uint32_t image, TextureUse use);
    GLuint sampler(const Texture& texture);

    std::span<const Image> images_;  ///< The caller's, during upload.
    std::map<std::pair<std::uint32_t, TextureUse>, gl::Texture> textures_;
    std::map<std::tuple<Wrap, Wrap, Filter, Filter>, gl::Sampler> samplers_;
    gl::Texture white_;
};

}  // namespace candela
