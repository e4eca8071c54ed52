#pragma once

#include <candela/cage.h>
#include <candela/export.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// Stencils: a sparse matrix with a stencil per vertex, and for each entry a weight for the value and one for
/// each of its two derivatives. Stencil i has the entries offsets[i] to offsets[i + 1] - 1.
struct StencilTable {
    std::vector<std::uint32_t> offsets = {};         ///< One more than stencils; empty where there are none.
    std::vector<std::uint32_t> controlIndices = {};  ///< One an entry, as are the weights.
    std::vector<float> weights = {}, duWeights = {}, dvWeights = {};

    std::size_t stencilCount() const { return offsets.empty() ? 0 : offsets.size() - 1; }
};

/// A cage refined to one level: its topology, and the stencils that give the limit surface of any pose of the
/// cage. It has `pointCount` distinct limit points, and `vertexCount()` vertices to draw: vertex i lies at
/// point i for i < pointCount; those after them are seam vertices, which share the position of a point but
/// not its tangents or texture coordinates: they lie on the other side of a crease or of a texture seam.
struct RefinedCage {
    std::uint32_t level = 0;  ///< Each edge of the cage is 2^level edges long; 0: the cage's own polygons.
    std::uint32_t pointCount = 0;
    std::vector<std::uint32_t> seamPoints = {};  ///< The point of each seam vertex.
    StencilTable positions = {};  ///< One stencil per vertex, of the cage's points. The value weights of a
                                  ///< seam vertex are not used, only those of its derivatives.
    /// One stencil per vertex, of the cage's texture coordinates; none without those.
    StencilTable uvs = {};
    std::uint32_t faceSize = 4;                    ///< 3 or 4.
    std::vector<std::uint32_t> faceVertices = {};  ///< `faceSize` per face, counter-clockwise.
    std::vector<std::uint32_t> cageFaces = {};     ///< The face of the cage that each face belongs to.

    std::size_t vertexCount() const { return pointCount + seamPoints.size(); }
    /// The point at which a vertex lies. Throws `Error` (badInput) when there is no such vertex.
    CANDELA_API std::uint32_t pointOf(std::uint32_t vertex) const;
};

/// What `evaluateLimit` writes, one element per vertex. `du` and `dv` may be empty: they are not written
/// then.
struct LimitVertices {
    /// Metres. All vertices of a point have the same position, bit for bit.
    std::span<glm::vec3> positions = {};
    std::span<glm::vec3> normals = {};      ///< du × dv at unit length; (0, 0, 0) where that vanishes.
    std::span<glm::vec3> du = {}, dv = {};  ///< Derivatives along the parameters of the face, not normalised.
};

/// Applies the stencils to the points of the cage, in parallel. The result does not depend on the number of
/// threads. Throws `Error` (badInput) when a size or an index of `refined` does not fit, a stencil reads a
/// point that `cagePoints` does not have, or an array of `out` does not have one element per vertex.
CANDELA_API void evaluateLimit(const RefinedCage& refined, std::span<const glm::vec3> cagePoints,
                               const LimitVertices& out);

/// The texture coordinates of all vertices, and their derivatives along the parameters of the face; empty
/// for a cage without texture coordinates.
struct LimitUvs {
    std::vector<glm::vec2> uvs = {}, du = {}, dv = {};
};

/// Applies the stencils to the texture coordinates of the cage, in parallel. Throws `Error` (badInput) when
/// the table of `refined` is not whole or reads a texture coordinate that `cageUvs` does not have.
CANDELA_API LimitUvs evaluateLimitUvs(const RefinedCage& refined, std::span<const glm::vec2> cageUvs);

/// The polygons of a cage, cut into triangles, as a refined cage of level 0: what is drawn without a
/// subdivider. One vertex per corner; holes are left out. The derivatives span the plane that fits the
/// polygon best in `cage.positions` (with more than 64 corners: the plane of three that are far
/// apart), and follow it where it moves. Throws `Error`: badInput when faces, texture coordinates or holes
/// break a rule of `validate`, limit when 32 bits cannot count the weights.
CANDELA_API RefinedCage cagePolygons(const Cage& cage);

}  // namespace candela
