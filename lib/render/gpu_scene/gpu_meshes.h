#pragma once

#include "render/gpu_scene/vertex_streams.h"

#include <candela/mesh.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// Where a mesh lies in the shared buffers, and the sphere around it.
struct MeshPlace {
    std::uint32_t firstIndex = 0;
    std::int32_t baseVertex = 0;
    glm::vec3 center{0.0f};
    float radius = 0.0f;
};

/// All meshes of a scene in one set of vertex and index buffers.
class GpuMeshes {
  public:
    /// Detail is tangents, texture coordinates and vertex colours, which are left out where no draw can come
    /// to read them (see `detailOf`). Throws `Error` (limit) when the scene has more vertices or indices than
    /// 32-bit draws can reach.
    enum class Detail { positionsAndNormals, everything };
    GpuMeshes(std::span<const Mesh> meshes, Detail detail);

    const std::vector<MeshPlace>& places() const { return places_; }

    /// Binds the streams to a vertex array whose draw attribute reads `draws` (uvec2 an instance).
    void describe(const gl::VertexArray& vertexArray, const gl::Buffer& draws,
                  const DefaultDetail& defaultDetail) const;

  private:
    void place(std::span<const Mesh> meshes);
    void uploadSurface(std::span<const Mesh> meshes);
    void uploadDetail(std::span<const Mesh> meshes);

    std::vector<MeshPlace> places_;
    std::uint64_t vertexCount_ = 0, indexCount_ = 0;
    Detail detail_;
    gl::Buffer indices_, surface_, detailStream_;
};

}  // namespace candela
