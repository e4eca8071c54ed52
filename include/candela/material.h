#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace candela {

enum class Wrap { repeat, clampToEdge, mirroredRepeat };

enum class Filter {
    linearMipmapLinear,
    nearest,
    linear,
    nearestMipmapNearest,
    linearMipmapNearest,
    nearestMipmapLinear,
};

/// A use of an image. The coordinate is offset + rotate(rotation) × (scale × uv), as KHR_texture_transform
/// defines it.
struct Texture {
    std::uint32_t image = 0;  ///< Index into `Scene::images`.
    std::uint32_t uvSet = 0;  ///< 0 or 1.
    Wrap wrapS = Wrap::repeat, wrapT = Wrap::repeat;
    Filter minFilter = Filter::linearMipmapLinear;
    Filter magFilter = Filter::linear;  ///< nearest or linear.
    glm::vec2 offset{0.0f};
    float rotation = 0.0f;  ///< Radians, counter-clockwise.
    glm::vec2 scale{1.0f};
};

enum class AlphaMode {
    opaque,
    mask,  ///< A fragment whose alpha is below `alphaCutoff` is not drawn.
    /// Lets 1 - alpha of each light through to what it shadows. It is drawn as `mask`: pictures have one
    /// layer.
    blend,
};

/// A metallic-roughness material as in glTF 2.0; each texture multiplies its factor. Colours are linear
/// Rec.709.
struct Material {
    std::string name;
    glm::vec4 baseColor{1.0f};                        ///< And alpha; 0 to 1.
    float metallic = 0.0f;                            ///< 0 to 1.
    float roughness = 1.0f;                           ///< Perceptual roughness, 0 to 1.
    glm::vec3 emission{0.0f};                         ///< Radiance, 0 or more.
    std::optional<Texture> baseColorTexture;          ///< RGB sRGB-encoded (linear when rgba32f), A linear.
    std::optional<Texture> metallicRoughnessTexture;  ///< G roughness, B metallic, linear.
    std::optional<Texture> normalTexture;             ///< Tangent space, linear.
    std::optional<Texture>
        occlusionTexture;                    ///< R, linear: dims the environment's light (glTF 2.0, 3.9.3).
    std::optional<Texture> emissionTexture;  ///< RGB sRGB-encoded (linear when rgba32f).
    float normalScale = 1.0f;                ///< Multiplies x and y of the normal texture.
    float occlusionStrength = 1.0f;          ///< 0 to 1.
    AlphaMode alphaMode = AlphaMode::opaque;
    float alphaCutoff = 0.5f;  ///< Of `mask` and `blend`; 0 or more.
    bool doubleSided = false;
    bool unlit = false;  ///< Radiance is the base colour, and no light falls on it (KHR_materials_unlit).
};

}  // namespace candela
