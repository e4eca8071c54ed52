#pragma once

#include <candela/material.h>

#include <cstddef>
#include <optional>
#include <span>

namespace candela {

/// What the texels of a texture hold: colours, which are sRGB-encoded unless they are floats, or numbers.
enum class TextureContent { color, data };

/// A texture that a material may have.
struct MaterialTexture {
    const char* name;  ///< As messages call its use: "base colour".
    TextureContent content;
    const std::optional<Texture>& (*of)(const Material& material);
};

/// How many of `materialTextures` belong to metallic and roughness, normals, emission and occlusion; those of
/// lobes and media follow.
inline constexpr std::size_t basicTextureCount = 5;

/// All textures that a material may have, in a fixed order: base colour, metallic-roughness, normal,
/// emission, occlusion, and those of lobes and media: that of `TextureSlot`.
std::span<const MaterialTexture> materialTextures();

/// The texture of a slot, which is one of `TextureSlot`.
std::optional<Texture>& textureOf(Material& material, TextureSlot slot);

}  // namespace candela
