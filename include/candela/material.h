#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <limits>
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
    std::uint32_t uvSet = 0;  ///< Of `Mesh`: 0 is `uv0`, 1 `uv1`, 2 the first of `furtherUvs`; 0 for cages.
    Wrap wrapS = Wrap::repeat, wrapT = Wrap::repeat;
    Filter minFilter = Filter::linearMipmapLinear;
    Filter magFilter = Filter::linear;  ///< nearest or linear.
    glm::vec2 offset{0.0f};
    float rotation = 0.0f;  ///< Radians, counter-clockwise.
    glm::vec2 scale{1.0f};

    bool operator==(const Texture&) const = default;
};

enum class AlphaMode {
    opaque,
    mask,  ///< A fragment whose alpha is below `alphaCutoff` is not drawn.
    /// Covers the share alpha of what is behind (docs/layers.md), and lets 1 - alpha of each light through to
    /// what it shadows.
    blend,
};

// The lobes and media that a material may have besides metallic and roughness, as the glTF extensions define
// them. Each texture multiplies its factor; the letters name the channels that are read. Colours are linear
// Rec.709, 0 to 1; textures of colours are sRGB-encoded (linear when rgba32f), others are linear.

/// Strength and colour of the dielectric reflection (KHR_materials_specular).
struct Specular {
    float factor = 1.0f;                       ///< 0 to 1; also the reflectance at grazing angles.
    glm::vec3 color{1.0f};                     ///< Factor on the reflectance at normal incidence, 0 or more.
    std::optional<Texture> texture = {};       ///< A: the factor.
    std::optional<Texture> colorTexture = {};  ///< RGB.

    bool operator==(const Specular&) const = default;
};

/// A smooth dielectric layer on top, of index of refraction 1.5 (KHR_materials_clearcoat).
struct Clearcoat {
    float factor = 0.0f;                           ///< 0 to 1; 0: there is none.
    float roughness = 0.0f;                        ///< Perceptual roughness, 0 to 1.
    float normalScale = 1.0f;                      ///< Multiplies x and y of the normal texture.
    std::optional<Texture> texture = {};           ///< R: the factor.
    std::optional<Texture> roughnessTexture = {};  ///< G.
    std::optional<Texture> normalTexture = {};     ///< Tangent space; none: the normal of the mesh.

    bool operator==(const Clearcoat&) const = default;
};

/// The fibres of cloth (KHR_materials_sheen).
struct Sheen {
    glm::vec3 color{0.0f};                         ///< 0: there is none.
    float roughness = 0.0f;                        ///< Perceptual roughness, 0 to 1.
    std::optional<Texture> colorTexture = {};      ///< RGB.
    std::optional<Texture> roughnessTexture = {};  ///< A.

    bool operator==(const Sheen&) const = default;
};

/// A specular lobe that is wider along one direction of the surface (KHR_materials_anisotropy).
struct Anisotropy {
    float strength = 0.0f;  ///< 0 to 1.
    float rotation = 0.0f;  ///< Of the wide direction, radians, counter-clockwise from the tangent.
    std::optional<Texture> texture = {};  ///< RG: direction, -1 to 1; B: the strength.

    bool operator==(const Anisotropy&) const = default;
};

/// A thin film, whose colour depends on the angle (KHR_materials_iridescence).
struct Iridescence {
    float factor = 0.0f;                  ///< 0 to 1; 0: there is none.
    float ior = 1.3f;                     ///< Index of refraction of the film, 1 or more.
    float minThickness = 100.0f;          ///< Nanometres, 0 or more: where the texture is 0.
    float maxThickness = 400.0f;          ///< Nanometres, 0 or more: where it is 1, or there is none.
    std::optional<Texture> texture = {};  ///< R: the factor.
    std::optional<Texture> thicknessTexture = {};  ///< G.

    bool operator==(const Iridescence&) const = default;
};

/// Light that passes through the surface and is refracted (KHR_materials_transmission).
struct Transmission {
    float factor = 0.0f;  ///< 0 to 1: of the light that is not reflected, the share that passes.
    std::optional<Texture> texture = {};  ///< R.

    bool operator==(const Transmission&) const = default;
};

/// What lies behind a surface that transmits (KHR_materials_volume, KHR_materials_dispersion).
struct Volume {
    float thickness = 0.0f;  ///< Metres in the space of the mesh, 0 or more; 0: a thin wall.
    float attenuationDistance = std::numeric_limits<float>::infinity();  ///< Metres, over 0.
    glm::vec3 attenuationColor{1.0f};              ///< What is left of white light after that distance.
    float dispersion = 0.0f;                       ///< 20 / Abbe number, 0 or more.
    std::optional<Texture> thicknessTexture = {};  ///< G.

    bool operator==(const Volume&) const = default;
};

/// Light that passes through the surface and is scattered, as through a leaf
/// (KHR_materials_diffuse_transmission).
struct DiffuseTransmission {
    float factor = 0.0f;  ///< 0 to 1: the share of the diffuse reflection that passes instead.
    glm::vec3 color{1.0f};
    std::optional<Texture> texture = {};       ///< A: the factor.
    std::optional<Texture> colorTexture = {};  ///< RGB.

    bool operator==(const DiffuseTransmission&) const = default;
};

/// A metallic-roughness material as in glTF 2.0; each texture multiplies its factor. Colours are linear
/// Rec.709.
struct Material {
    std::string name = {};
    glm::vec4 baseColor{1.0f};      ///< And alpha; 0 to 1.
    float metallic = 0.0f;          ///< 0 to 1.
    float roughness = 1.0f;         ///< Perceptual roughness, 0 to 1.
    glm::vec3 emission{0.0f};       ///< Radiance, 0 or more.
    float emissionStrength = 1.0f;  ///< Multiplies `emission`; 0 or more (KHR_materials_emissive_strength).
    std::optional<Texture> baseColorTexture = {};  ///< RGB sRGB-encoded (linear when rgba32f), A linear.
    std::optional<Texture> metallicRoughnessTexture = {};  ///< G roughness, B metallic, linear.
    std::optional<Texture> normalTexture = {};             ///< Tangent space, linear.
    /// R, linear: dims the environment's light (glTF 2.0, 3.9.3).
    std::optional<Texture> occlusionTexture = {};
    std::optional<Texture> emissionTexture = {};  ///< RGB sRGB-encoded (linear when rgba32f).
    float normalScale = 1.0f;                     ///< Multiplies x and y of the normal texture.
    float occlusionStrength = 1.0f;               ///< 0 to 1.
    AlphaMode alphaMode = AlphaMode::opaque;
    float alphaCutoff = 0.5f;  ///< Of `mask`; 0 or more.
    bool doubleSided = false;
    bool unlit = false;  ///< Radiance is the base colour, and no light falls on it (KHR_materials_unlit).
    /// Index of refraction, 1 or more (KHR_materials_ior); infinity: all light is reflected, but for what
    /// `specular` takes.
    float ior = 1.5f;
    Specular specular = {};
    Clearcoat clearcoat = {};
    Sheen sheen = {};
    Anisotropy anisotropy = {};
    Iridescence iridescence = {};
    Transmission transmission = {};
    Volume volume = {};
    DiffuseTransmission diffuseTransmission = {};
};

/// The textures of a `Material`, in the order of its members.
enum class TextureSlot {
    baseColor,
    metallicRoughness,
    normal,
    emission,
    occlusion,
    specular,
    specularColor,
    clearcoat,
    clearcoatRoughness,
    clearcoatNormal,
    sheenColor,
    sheenRoughness,
    anisotropy,
    iridescence,
    iridescenceThickness,
    transmission,
    thickness,
    diffuseTransmission,
    diffuseTransmissionColor,
};

}  // namespace candela
