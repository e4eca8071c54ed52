#pragma once

#include "gl/texture.h"
#include "render/occlusion/occlusion_mesh.h"
#include "scene/model/material_textures.h"

#include <candela/gpu_scene.h>
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

/// What decodes sRGB-encoded colour of 8 bits.
enum class ColorDecoding {
    device,  ///< The device's sampler, which is exact on GPUs.
    exact,   ///< The CPU, into half floats: software rasterisers only approximate the curve (llvmpipe misses
             ///< one code in six).
};

/// The images of a scene on the device, each uploaded once for each content that materials read it in, with
/// mipmaps.
class GpuImages {
  public:
    /// `maxTransferBytes`: larger images are transferred in several runs of rows.
    GpuImages(std::span<const Image> images, ColorDecoding decoding,
              std::size_t maxTransferBytes = std::size_t{1} << 28);

    /// The texture of a material's slot; a white one where the slot is empty. Throws `Error` (limit) naming
    /// an image that does not fit the device.
    SampledTexture get(const std::optional<Texture>& texture, TextureContent content);

    // Edits, after `releaseSources`.

    /// Sets an image that no material reads, which may be the next one; its pixels are kept until one does.
    void set(std::uint32_t index, const Image& image);
    /// Replaces an image whose textures materials have: those have other names then. Throws `Error` (limit)
    /// when it does not fit the device; nothing is changed then.
    void replace(std::uint32_t index, const Image& image);
    /// Frees an image that no material reads.
    void remove(std::uint32_t index);
    /// Replaces the texels of a region, which lies in the image.
    void setPixels(std::uint32_t index, const ImageRegion& region, std::span<const std::byte> pixels);

    /// The alpha of an image, read back from the device where it has been uploaded.
    AlphaImage readAlpha(std::uint32_t index) const;

    /// Takes the pixels of the constructor's images, which are `images`, and frees each of them once it is
    /// uploaded. To be called before anything else.
    void takeSources(std::span<Image> images);
    /// Ends the use of the constructor's images: pixels that no material has read yet are copied, others can
    /// be read back.
    void releaseSources();

  private:
    using Key = std::pair<std::uint32_t, TextureContent>;

    void restorePixels(std::uint32_t index);
    std::optional<std::vector<std::byte>> uploadedPixels(std::uint32_t index) const;
    std::vector<std::byte> readPixels(GLuint texture, TextureContent content, const Image& image) const;
    void writePixels(GLuint texture, TextureContent content, const Image& image) const;
    void writeRegion(GLuint texture, TextureContent content, PixelFormat format, const ImageRegion& region,
                     std::span<const std::byte> pixels) const;
    gl::Texture makeTexture(const Image& image, std::uint32_t index, TextureContent content) const;
    GLuint upload(std::uint32_t image, TextureContent content);
    GLuint sampler(const Texture& texture);

    ColorDecoding decoding_;
    std::size_t maxTransferBytes_;
    std::span<const Image> images_;  ///< The caller's until `takeSources` or `releaseSources`, then `kept_`.
    std::vector<Image> kept_;        ///< Without pixels where these are in a texture.
    std::map<Key, gl::Texture> textures_;
    std::map<std::tuple<Wrap, Wrap, Filter, Filter>, gl::Sampler> samplers_;
    gl::Texture white_;
};

}  // namespace candela
