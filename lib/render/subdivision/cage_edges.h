#pragma once

#include "gl/buffer.h"

#include <candela/cage.h>
#include <candela/refined_cage.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// The two vertices of an edge, the smaller index first.
using CageEdge = std::array<std::uint32_t, 2>;

/// Every edge of the cage's faces once, in ascending order.
std::vector<CageEdge> edgesOf(const Cage& cage);

/// Every edge of the refined faces once. Its ends are points, not seam vertices: both sides of a seam share
/// it.
std::vector<CageEdge> edgesOf(const RefinedCage& refined);

/// Edges as an index buffer for GL_LINES.
struct EdgeIndices {
    explicit EdgeIndices(std::span<const CageEdge> edges)
        : buffer(gl::Buffer::immutable("cage edges", edges)), count(static_cast<GLsizei>(2 * edges.size())) {}

    gl::Buffer buffer;
    GLsizei count;
};

enum class CageLineKind {
    faceEdges,  ///< Edges of the faces that are drawn: of the refined cage, or of its polygons' triangles.
    cageEdges,  ///< Edges of the control polyhedron.
};

/// Lines of a cage instance: GL_LINES of 32-bit indices from offset 0. The vertex array feeds
/// POSITION_ATTRIBUTE alone.
struct CageLines {
    GLuint vertexArray = 0;
    GLsizei indexCount = 0;
    std::uint32_t instance = 0;  ///< Whose record places the points, see shaders/lib/instance.glsl.
};

}  // namespace candela
