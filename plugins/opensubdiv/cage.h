#pragma once

#include <candela/plugin.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace candela_plugins::opensubdiv {

/// The host's cage as spans whose sizes and indices have been checked. Valid as long as the host's arrays.
struct CheckedCage {
    candela_scheme scheme;
    candela_boundary_interpolation boundaryInterpolation;
    candela_face_varying_interpolation faceVaryingInterpolation;
    candela_crease_method creaseMethod;
    candela_triangle_subdivision triangleSubdivision;
    std::uint32_t vertexCount, uvCount;
    std::span<const float> positions;             ///< 3 a vertex.
    std::span<const std::uint32_t> faceSizes;     ///< 3 or more each; 3 with the Loop scheme.
    std::span<const std::uint32_t> faceVertices;  ///< One a corner.
    std::span<const std::uint32_t> faceUvs;       ///< One a corner; empty where `uvCount` is 0.
    std::span<const std::uint32_t> creaseEdges;   ///< 2 a crease; not checked to be edges.
    std::vector<float> creaseSharpness;           ///< 0 to OpenSubdiv's infinite sharpness.
    std::span<const std::uint32_t> cornerVertices;
    std::vector<float> cornerSharpness;
    std::span<const std::uint32_t> holes;
    std::vector<std::uint32_t> faceStarts;  ///< The first corner of each face, and the number of all corners.

    std::uint32_t faceCount() const { return static_cast<std::uint32_t>(faceSizes.size()); }
};

/// "edge 3-8"
std::string edgeName(std::uint32_t vertex0, std::uint32_t vertex1);

/// Checks the sizes and indices, which OpenSubdiv trusts. Throws `Failure`.
CheckedCage checkCage(const candela_cage& cage);

}  // namespace candela_plugins::opensubdiv
