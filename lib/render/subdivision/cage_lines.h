#pragma once

#include <epoxy/gl.h>

#include <cstdint>

namespace candela {

enum class CageLineKind {
    faceEdges,  ///< Edges of the faces that are drawn: of the refined cage, or of its polygons' triangles.
    cageEdges,  ///< Edges of the control polyhedron.
};

/// Lines of a cage as one node shows it: GL_LINES of 32-bit indices from offset 0. The vertex array feeds
/// POSITION_ATTRIBUTE alone.
struct CageLines {
    GLuint vertexArray = 0;
    GLsizei indexCount = 0;
    std::uint32_t instance = 0;  ///< Whose record places the points, see shaders/lib/instance.glsl.
};

}  // namespace candela
