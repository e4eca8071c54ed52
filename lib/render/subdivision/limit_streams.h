#pragma once

#include "gl/buffer.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <span>

namespace candela {

class GpuStencilTable;

/// The moving vertices of a limit surface: all positions, then all normals, in one buffer; and tangents in
/// another where they are wanted.
struct LimitStreams {
    gl::Buffer surface{"cage positions and normals"};
    gl::Buffer tangents{"cage tangents"};

    static std::size_t surfaceBytes(std::size_t vertices) { return 2 * vertices * sizeof(glm::vec3); }
};

/// An evaluation of a limit surface: the table is applied to the points, and the result goes to the streams,
/// which have room for it.
struct LimitRequest {
    GpuStencilTable& table;
    std::span<const glm::vec3> points;
    const gl::Buffer& pointBuffer;  ///< The same points.
    /// Derivatives of the texture coordinates, one a vertex; empty where no tangents are wanted.
    std::span<const glm::vec4> uvDerivatives;
    const LimitStreams& streams;
};

}  // namespace candela
