#pragma once

#include "render/culling/triangle_filter_kernel.h"

#include <candela/mesh.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// Consecutive clusters.
struct ClusterRange {
    std::uint32_t first = 0, count = 0;
};

/// The vertices of a mesh, and all its indices.
struct MeshTriangles {
    std::span<const glm::vec3> positions;
    std::span<const std::uint32_t> indices;
};

/// The clusters of a scene's meshes: runs of consecutive triangles with bounds, by which the triangle filter
/// drops them together. The order of triangles stays, since it decides between surfaces of equal depth.
/// Computed on all cores by vector code, about 8 ns a triangle and core.
class MeshClusters {
  public:
    explicit MeshClusters(std::span<const Mesh> meshes,
                          const TriangleFilterKernel& kernel = *triangleFilterKernels().front());

    /// The clusters of the triangles of a mesh from index `firstIndex` of its own on: of a submesh, or of all
    /// of a mesh without submeshes. None where these are fewer than `minIndices`: one command draws many such
    /// meshes.
    std::optional<ClusterRange> of(std::uint32_t mesh, std::uint32_t firstIndex,
                                   std::uint32_t indexCount) const;
    static constexpr std::uint32_t minIndices = 3 * 64;

    std::span<const layout::TriangleCluster> clusters() const { return clusters_; }
    /// Grows with each `move` and `replace`.
    std::uint64_t version() const { return version_; }

    /// Recomputes those of a mesh whose vertices have moved.
    void move(std::uint32_t mesh, const MeshTriangles& moved);
    /// The same of a mesh that is another one now, an empty one for instance, or a new one behind the others.
    void replace(std::uint32_t mesh, const Mesh& content);
    /// Those of a mesh whose vertices are only known to the device from now on: nothing is dropped with its
    /// clusters.
    void forget(std::uint32_t mesh);

  private:
    /// Triangles of one draw.
    struct Part {
        std::uint32_t firstIndex, indexCount, firstCluster;
    };
    struct Task;
    /// The parts of a mesh, with clusters from `end` on, which is moved behind them.
    static std::vector<Part> partsOf(std::span<const Submesh> submeshes, std::size_t indexCount,
                                     std::uint32_t& end);
    static void addTasks(std::span<const Part> parts, const MeshTriangles& mesh, std::vector<Task>& tasks);
    void compute(std::span<const Task> tasks);

    const TriangleFilterKernel* kernel_;
    std::vector<std::vector<Part>> parts_;  ///< Of each mesh.
    std::vector<layout::TriangleCluster> clusters_;
    std::uint64_t version_ = 0;
};

}  // namespace candela
