#pragma once

#include <string>

#include "../common/host.h"
#include "host_material.h"
#include "images.h"
#include "texture_uses.h"
#include "uv_slots.h"

namespace candela_plugins::gltf {

/// Reads the textures of one material. All that is passed to the constructor has to outlive it.
class TextureReader {
  public:
    /// `element` names the material in notes.
    TextureReader(const Document& document, const AddedImages& images, const UvSlots& slots, const Host& host,
                  const std::string& element)
        : document_(document), images_(images), slots_(slots), host_(host), element_(element) {}

    /// None where there is none, and with a note where it cannot be read.
    candela_texture read(const TextureUse& use) const;

    /// The same for the roughness that replaces a specular-glossiness texture, see `AddedImages`.
    candela_texture readRoughness(const TextureUse& use, float glossinessFactor) const;

  private:
    candela_texture read(const TextureUse& use, std::int32_t image) const;
    const tinygltf::Texture& textureOf(const TextureUse& use) const;
    void requireImage(const tinygltf::Texture& texture, std::size_t index) const;

    const Document& document_;
    const AddedImages& images_;
    const UvSlots& slots_;
    const Host& host_;
    const std::string& element_;
};

}  // namespace candela_plugins::gltf
