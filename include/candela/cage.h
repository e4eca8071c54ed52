#pragma once

#include <candela/deformation.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace candela {

enum class SubdivisionScheme {
    catmullClark,
    loop,  ///< Triangles only.
    bilinear,
};

/// How the surface ends where the cage does.
enum class BoundaryInterpolation {
    none,             ///< Faces at a boundary have no surface.
    edges,            ///< The boundary is a smooth curve.
    edgesAndCorners,  ///< And it passes through the vertices that belong to one face only.
};

/// Where face-varying values are interpolated linearly, by OpenSubdiv's names (Sdc::Options).
enum class FaceVaryingInterpolation {
    none,  ///< Nowhere: smooth everywhere.
    cornersOnly,
    cornersPlus1,
    cornersPlus2,
    boundaries,
    all,  ///< Everywhere.
};

enum class CreaseMethod { uniform, chaikin };
enum class TriangleSubdivision { catmullClark, smooth };

/// From this sharpness on an edge or a vertex is infinitely sharp.
constexpr float infiniteSharpness = 10.0f;

/// The maximum level that a cage can be refined to.
constexpr std::uint32_t maxSubdivisionLevel = 8;

/// A sharp edge of a cage. Sharpness is 0 or more; it falls by one per level.
struct Crease {
    std::uint32_t vertex0 = 0, vertex1 = 0;  ///< Both ends of an edge of the cage.
    float sharpness = infiniteSharpness;
};

/// A sharp vertex of a cage.
struct Corner {
    std::uint32_t vertex = 0;
    float sharpness = infiniteSharpness;
};

/// The materials of a cage's faces in a variant of the scene; see `selectVariant`.
struct CageVariant {
    std::optional<std::uint32_t> variant = {};  ///< Index into `Scene::variants`; none: without a variant.
    std::vector<std::optional<std::uint32_t>> faceMaterials = {};  ///< As `Cage::faceMaterials`.

    bool operator==(const CageVariant&) const = default;
};

/// The control polyhedron of a subdivision surface. A corner of a face is one of its vertices; arrays "a
/// corner" count them face after face. Faces go counter-clockwise seen from outside.
struct Cage {
    std::string name = {};
    SubdivisionScheme scheme = SubdivisionScheme::catmullClark;
    BoundaryInterpolation boundaryInterpolation = BoundaryInterpolation::edgesAndCorners;
    FaceVaryingInterpolation faceVaryingInterpolation = FaceVaryingInterpolation::cornersOnly;
    CreaseMethod creaseMethod = CreaseMethod::uniform;
    TriangleSubdivision triangleSubdivision = TriangleSubdivision::catmullClark;

    std::vector<glm::vec3> positions = {};         ///< Metres, one per vertex.
    std::vector<std::uint32_t> faceSizes = {};     ///< Corners of each face, 3 or more.
    std::vector<std::uint32_t> faceVertices = {};  ///< Index into `positions`, one per corner.
    std::vector<glm::vec2> uvs = {};               ///< Face-varying texture coordinates; empty: none.
    std::vector<std::uint32_t> faceUvs = {};  ///< Index into `uvs`, one per corner; empty where `uvs` is.
    std::vector<Crease> creases = {};
    std::vector<Corner> corners = {};
    /// Faces without a surface, which shape that of their neighbours.
    std::vector<std::uint32_t> holes = {};
    /// Index into `Scene::materials` a face, none for the default material; empty: none for all.
    std::vector<std::optional<std::uint32_t>> faceMaterials = {};
    /// Where faces have other materials in variants: those of all faces in each of them, and also without a
    /// variant.
    std::vector<CageVariant> variants = {};
    /// Refine to this level, 1 to `maxSubdivisionLevel`; none: by the size on the screen.
    std::optional<std::uint32_t> level = {};

    std::uint32_t influenceCount = 0;        ///< Joints per vertex; 0: no skin moves it.
    std::vector<std::uint32_t> joints = {};  ///< `influenceCount` per vertex: indices into `Skin::joints`.
    /// `influenceCount` per vertex, 0 or more, of sum 1 for each vertex.
    std::vector<float> jointWeights = {};
    std::vector<MorphTarget> morphTargets = {};
};

}  // namespace candela
