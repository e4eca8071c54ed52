#pragma once

#include "base/range_pool.h"
#include "gl/buffer.h"
#include "render/gpu_scene/gpu_instances.h"

#include <candela/gpu_scene.h>
#include <candela/mesh.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// A run of indices.
struct IndexRange {
    std::uint32_t first = 0, count = 0;
};

/// Feeds the vertex attribute `location` with `components` floats from a vertex buffer binding.
void feedFloats(const gl::VertexArray& vertexArray, int location, int components, GLuint binding,
                std::size_t offset);

/// Feeds the draw attribute from `draws` (uvec2 an instance) through `binding`.
void feedDraws(const gl::VertexArray& vertexArray, GLuint binding, const gl::Buffer& draws);

/// One vertex that stands for all of a surface without tangents, texture coordinates and vertex colours: no
/// tangent, (0, 0) and white.
class DefaultDetail {
  public:
    DefaultDetail();

    /// Feeds these attributes through `binding`.
    void describe(const gl::VertexArray& vertexArray, GLuint binding) const;

  private:
    gl::Buffer vertex_;
};

/// Where a mesh lies in the shared buffers.
struct MeshPlace {
    std::uint32_t firstIndex = 0;
    std::int32_t baseVertex = 0;
    std::uint32_t vertexCount = 0;
    BoundingSphere sphere;
    std::uint32_t indexCount = 0;
};

/// The vertices of a deformed mesh, which replace those of the mesh: position and normal of each,
/// interleaved, and its tangent; nullptr where no draw reads tangents.
struct DeformedStreams {
    const gl::Buffer& surface;
    const gl::Buffer* tangents;
};

/// All meshes of a scene in one set of vertex and index buffers.
class GpuMeshes {
  public:
    /// Detail is tangents, texture coordinates and vertex colours, which are left out where no draw can come
    /// to read them (see `detailOf`). Throws `Error` (limit) when the scene has more vertices or indices than
    /// 32-bit draws can reach.
    enum class Detail { positionsAndNormals, everything };
    /// Who reads vertices and indices.
    enum class Access {
        device,
        deviceAndCpu,  ///< Also the CPU, through `mappedVertices` and `mappedIndices`.
    };
    GpuMeshes(std::span<const Mesh> meshes, Detail detail, Access access);

    /// Position and normal of each vertex.
    std::span<const float> mappedVertices() const { return surface_.mapped<float>(); }
    std::span<const std::uint32_t> mappedIndices() const { return indices_.mapped<std::uint32_t>(); }

    Access access() const { return access_; }
    /// Position and normal of each vertex, and the indices.
    const gl::Buffer& surface() const { return surface_; }
    const gl::Buffer& indices() const { return indices_; }

    const std::vector<MeshPlace>& places() const { return places_; }
    bool hasDetail() const { return detail_ == Detail::everything; }
    /// How often the vertices of a mesh have been set.
    std::uint64_t version(std::uint32_t mesh) const { return versions_[mesh]; }

    // Edits. Each leaves the rest where it is.

    enum class Buffers { same, replaced };
    /// Sets mesh `mesh`, which may be the next one; it has at most two sets of texture coordinates. Throws
    /// `Error` (limit) when the device has no room; nothing is changed then. Where the buffers have been
    /// replaced by larger ones, vertex arrays have to be described again.
    Buffers set(std::uint32_t mesh, const Mesh& from);
    /// Frees the place of a mesh, which is an empty one then.
    void remove(std::uint32_t mesh);
    /// Replaces positions and normals, which are as many; without normals the old ones are read back.
    void setSurface(std::uint32_t mesh, std::span<const glm::vec3> positions,
                    std::span<const glm::vec3> normals);
    /// Replaces both by those of a GL buffer, interleaved, within `sphere`.
    void copySurface(std::uint32_t mesh, const BufferRange& from, const BoundingSphere& sphere);
    /// The bytes of a vertex of the latter.
    static std::size_t surfaceBytes();

    // Read back from the device.

    std::vector<glm::vec3> readPositions(std::uint32_t mesh) const;
    /// The same of vertices that replace those of the mesh.
    std::vector<glm::vec3> readPositions(std::uint32_t mesh, const DeformedStreams& deformed) const;
    std::vector<std::uint32_t> readIndices(const IndexRange& range) const;
    /// What the alpha of a vertex is read with; the defaults where the scene has no detail.
    struct AlphaVertex {
        glm::vec2 uv0{0.0f}, uv1{0.0f};
        float alpha = 1.0f;  ///< Of the vertex colour.
    };
    std::vector<AlphaVertex> readAlphaVertices(std::uint32_t mesh) const;
    /// Set `set`, 2 or more, of the texture coordinates of a mesh that has it.
    std::vector<glm::vec2> readFurtherUvs(std::uint32_t mesh, std::uint32_t set) const;

    /// Binds the streams to a vertex array whose draw attribute reads `draws` (uvec2 an instance).
    void describe(const gl::VertexArray& vertexArray, const gl::Buffer& draws,
                  const DefaultDetail& defaultDetail) const;

    /// Adds the further sets of texture coordinates to a vertex array that `describe` has described. Vertices
    /// of meshes without them have none.
    void describeFurtherUvs(const gl::VertexArray& vertexArray) const;
    bool hasFurtherUvs() const { return furtherPairs_ != 0; }

    /// The same as `describe` for the deformed vertices of mesh `mesh`, whose draws have the base vertex 0.
    void describeDeformed(const gl::VertexArray& vertexArray, std::uint32_t mesh,
                          const DeformedStreams& deformed, const gl::Buffer& draws,
                          const DefaultDetail& defaultDetail) const;

  private:
    void describe(const gl::VertexArray& vertexArray, const gl::Buffer& surface, std::size_t firstDetail,
                  const gl::Buffer& draws, const DefaultDetail& defaultDetail) const;
    void place(std::span<const Mesh> meshes);
    Buffers reserve(std::uint64_t vertices, std::uint64_t indices, MeshPlace& place);
    void write(const MeshPlace& place, const Mesh& mesh);
    void settle() const;
    void describeFurtherUvs(const gl::VertexArray& vertexArray, std::size_t firstVertex) const;
    void uploadSurface(std::span<const Mesh> meshes);
    void uploadDetail(std::span<const Mesh> meshes);
    void uploadFurtherUvs(std::span<const Mesh> meshes);

    std::vector<MeshPlace> places_;
    std::vector<std::uint32_t> order_;  ///< The meshes as their vertices follow each other.
    /// Vertices of meshes with further sets of texture coordinates, which come first, and how many pairs of
    /// sets each has room for.
    std::size_t furtherVertices_ = 0, furtherPairs_ = 0;
    std::uint64_t vertexCount_ = 0, indexCount_ = 0;
    Detail detail_;
    Access access_;
    RangePool vertexPool_, indexPool_;
    std::vector<std::uint64_t> versions_;  ///< One a mesh.
    gl::Buffer indices_, surface_, details_, furtherUvs_;
};

}  // namespace candela
