#pragma once

#include <candela/mesh.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace candela {

// The vertices of meshes as the shared buffers hold them.

struct SurfaceVertex {
    glm::vec3 position, normal;
};

struct DetailVertex {
    glm::vec4 tangent{0.0f};
    glm::vec2 uv0{0.0f}, uv1{0.0f};
    glm::vec4 color{1.0f};
};

// Each writes the vertices of a mesh from `first` on, as many as `to` has room for. Memory is only written,
// in ascending order: it may be that of a device.

void writeSurface(const Mesh& mesh, std::size_t first, std::span<SurfaceVertex> to);
void writeDetails(const Mesh& mesh, std::size_t first, std::span<DetailVertex> to);
/// `pairs` pairs of the sets from 2 on a vertex; (0, 0) for those that the mesh does not have.
void writeFurtherUvs(const Mesh& mesh, std::size_t first, std::size_t pairs, std::span<glm::vec2> to);
void writeIndices(const Mesh& mesh, std::size_t first, std::span<std::uint32_t> to);

/// Elements of meshes, vertices or indices, that follow each other in a buffer.
class MeshElements {
  public:
    /// `count` elements of a mesh behind those so far.
    void append(std::uint32_t mesh, std::size_t count);
    std::size_t count() const { return count_; }

    /// Elements of one mesh: the first of the mesh's own, the first in the buffer, and how many.
    struct Run {
        std::uint32_t mesh = 0;
        std::size_t firstOfMesh = 0, first = 0, count = 0;
    };
    /// Calls `visit` for the elements from `first` to before `end` of the buffer, in runs, on all cores.
    void visit(std::size_t first, std::size_t end, const std::function<void(const Run&)>& visit) const;

  private:
    std::vector<Run> runs_;
    std::size_t count_ = 0;
};

}  // namespace candela
