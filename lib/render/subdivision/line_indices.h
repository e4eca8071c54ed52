#pragma once

#include "gl/buffer.h"
#include "render/subdivision/cage_edges.h"

#include <span>

namespace candela {

/// Edges as indices of GL_LINES.
struct LineIndices {
    explicit LineIndices(std::span<const CageEdge> edges) : count(static_cast<GLsizei>(2 * edges.size())) {
        buffer.upload(edges);
    }

    gl::Buffer buffer{"cage lines"};
    GLsizei count;
};

}  // namespace candela
