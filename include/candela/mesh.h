#pragma once

#include <candela/deformation.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// How many sets of texture coordinates a mesh may have.
inline constexpr std::uint32_t maxUvSets = 18;

/// What the indices of a submesh are.
enum class Topology {
    triangles,  ///< Three indices each.
    lines,      ///< Two each: `FrameSettings::lineWidth` pixels wide.
    points,     ///< One each: squares of `FrameSettings::pointSize` pixels.
};

/// A range of a mesh's indices drawn with one material.
struct Submesh {
    /// Whole triangles, lines or points. In a mesh of triangles alone the first index is a multiple of 3 too.
    std::uint32_t firstIndex = 0, indexCount = 0;
    /// Index into `Scene::materials`; none: a default `Material`.
    std::optional<std::uint32_t> material = {};
    Topology topology = Topology::triangles;
};

/// The material of a submesh in a variant of the scene; see `selectVariant`.
struct VariantMaterial {
    std::uint32_t submesh = 0;                   ///< Index into `Mesh::submeshes`.
    std::optional<std::uint32_t> variant = {};   ///< Index into `Scene::variants`; none: without a variant.
    std::optional<std::uint32_t> material = {};  ///< As `Submesh::material`.

    bool operator==(const VariantMaterial&) const = default;
};

/// Indexed triangles, counter-clockwise from the front, lines and points. `positions` and `normals` have one
/// element per vertex; every other vertex array has as many or is empty. Joints that mirror a vertex turn its
/// triangles: where most joints of a skin do, clockwise is the front.
///
/// Lines and points are seen from all sides and cast no shadows. Those with normals are lit as surfaces are,
/// those without show their base colour and emission.
struct Mesh {
    std::string name = {};
    std::vector<glm::vec3> positions = {};  ///< Metres.
    /// Unit length. (0, 0, 0) for vertices of lines and points without normals: all vertices of a submesh
    /// have normals, or none.
    std::vector<glm::vec3> normals = {};
    std::vector<glm::vec4> tangents = {};  ///< Unit direction, and the bitangent's sign (-1 or 1) in w.
    std::vector<glm::vec2> uv0 = {}, uv1 = {};
    /// Sets of texture coordinates from 2 on, `maxUvSets` - 2 at most. Meshes without them cost nothing.
    std::vector<std::vector<glm::vec2>> furtherUvs = {};
    std::vector<glm::vec4> colors = {};  ///< Linear Rec.709 and alpha: multiplies the base colour.
    std::vector<std::uint32_t> indices = {};
    std::vector<Submesh> submeshes = {};  ///< Empty: all indices are triangles with the default material.
    /// Those of submeshes that have other materials in variants: for each of them also the one without a
    /// variant.
    std::vector<VariantMaterial> variantMaterials = {};

    std::uint32_t influenceCount = 0;        ///< Joints per vertex; 0: no skin moves it.
    std::vector<std::uint32_t> joints = {};  ///< `influenceCount` per vertex: indices into `Skin::joints`.
    /// `influenceCount` per vertex, 0 or more, of sum 1 for each vertex.
    std::vector<float> jointWeights = {};
    std::vector<MorphTarget> morphTargets = {};
};

}  // namespace candela
