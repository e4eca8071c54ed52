#pragma once

#include "gl/buffer.h"

#include <cstddef>

namespace candela {

/// Feeds the vertex attribute `location` with `components` floats from a vertex buffer binding.
void feedFloats(const gl::VertexArray& vertexArray, int location, int components, GLuint binding,
                std::size_t offset);

/// Feeds the draw attribute from `draws` (uvec2 an instance) through `binding`.
void feedDraws(const gl::VertexArray& vertexArray, GLuint binding, const gl::Buffer& draws);

/// What a surface has that lacks tangents, texture coordinates and vertex colours: no tangent, (0, 0) and
/// white, at all vertices.
class DefaultDetail {
  public:
    DefaultDetail();

    /// Feeds these attributes through `binding`.
    void describe(const gl::VertexArray& vertexArray, GLuint binding) const;

  private:
    gl::Buffer vertex_;
};

}  // namespace candela
