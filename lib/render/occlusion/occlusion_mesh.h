#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace candela {

/// The alpha of the base colour of an image: rows from the top, as textures have them. Rays read it by
/// bilinear interpolation of level 0.
struct AlphaImage {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> alpha;  ///< width × height, 255 is 1.
};

/// Where a coordinate outside of 0 to 1 reads an image.
enum class AlphaWrap : std::uint32_t { repeat, clampToEdge, mirroredRepeat };

/// A triangle of a material that masks, blends or transmits. Through a mask a ray passes where the alpha is
/// below the cutoff, as fragments of the geometry pass are discarded there, and elsewhere what the material
/// transmits; what blends lets 1 - alpha of it through, and what transmits without a mask is taken as if it
/// blended.
struct CutoutTriangle {
    glm::vec2 uv[3];           ///< With the texture's coordinate transform applied.
    float alpha[3];            ///< The material's factor times the vertex colour's.
    float cutoff = 0.0f;       ///< As in the material record (MATERIAL_FACTORS).
    float transmitted = 0.0f;  ///< Of a mask: the share that passes where it covers.
    std::uint32_t image = 0;   ///< Index into the images of the mesh; `noImage`: alpha 1.
    AlphaWrap wrapS = AlphaWrap::repeat, wrapT = AlphaWrap::repeat;
    bool nearest = false;  ///< No interpolation between texels.
    bool blends = false;   ///< The cutoff is not read.

    /// May it let a part of a ray through?
    bool dims() const { return blends || transmitted > 0.0f; }

    static constexpr std::uint32_t noImage = 0xffffffffu;
};

/// The triangles of a mesh, of a deformed mesh or of a limit surface, as rays meet them.
struct OcclusionMesh {
    std::vector<glm::vec3> positions;   ///< Metres, in the space of the mesh.
    std::vector<glm::uvec3> triangles;  ///< Opaque ones first, then one for each of `cutouts`.
    std::vector<CutoutTriangle> cutouts;
    std::vector<std::shared_ptr<const AlphaImage>> images;  ///< Those that `cutouts` read.

    std::size_t opaqueCount() const { return triangles.size() - cutouts.size(); }
    /// Memory, without the images.
    std::size_t bytes() const;
};

/// The share of a ray, 0 to 1, that passes through a triangle of the mesh, `cutouts[cutout]`, at the point
/// that `weights` of its corners give. The sum of the weights is 1. Shaders compute the same with the same
/// arithmetic (shaders/shared/alpha_cutout.h).
float transmittance(const OcclusionMesh& mesh, std::uint32_t cutout, const glm::vec3& weights);

/// A mesh at a place of the world.
struct OcclusionInstance {
    std::uint32_t mesh = 0;  ///< Index into the meshes of the scene.
    glm::mat4 worldFromLocal{1.0f};
    bool castsShadow = true;  ///< False: hidden, or its node casts no shadow.
};

/// Can rays be taken into the space of an instance? Not where the matrix is singular or not finite.
bool isInvertible(const glm::mat4& worldFromLocal);

}  // namespace candela
