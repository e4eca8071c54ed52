#pragma once

#include "gl/texel_heap.h"
#include "render/occlusion/occlusion_mesh.h"
#include "render/occlusion/wide_tree.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace candela {

/// Meshes and their instances as shaders trace them (shaders/lib/occlusion.glsl): a tree a mesh, and one over
/// the instances. Nodes have the boxes of their children in 8 bits a side, rounded outwards.
class GpuOcclusion {
  public:
    GpuOcclusion();
    GpuOcclusion(const GpuOcclusion&) = delete;
    GpuOcclusion& operator=(const GpuOcclusion&) = delete;

    /// Sets mesh `index`; meshes in between are empty. `tree` is of its triangles. A call of `setInstances`
    /// has to follow before rays are traced. Throws `Error` (limit) beyond what the device holds: the mesh is
    /// empty then.
    void setMesh(std::uint32_t index, const OcclusionMesh& mesh, const WideTree& tree);
    /// Sets all instances. `tree` is of their world-space boxes, one a leaf, and `tree.primitives` are
    /// indices of `instances`; what is not in the tree, such as a hidden instance, casts no shadow. Nor does
    /// an instance whose matrix is singular or not finite, or whose mesh is empty. Throws as `setMesh` does:
    /// there are no instances then.
    void setInstances(std::span<const OcclusionInstance> instances, const WideTree& tree);

    /// Binds the textures of shaders/lib/occlusion.glsl.
    void bind() const;
    /// Memory on the device.
    std::uint64_t bytes() const;

  private:
    struct Mesh {
        gl::TexelRange nodes, triangles, cutouts;
        std::vector<std::shared_ptr<const AlphaImage>> images;
    };
    struct Image {
        gl::TexelRange words;
        std::uint32_t users = 0;  ///< Meshes, each as often as it lists the image.
    };

    void release(Mesh& mesh);
    void addImage(const std::shared_ptr<const AlphaImage>& image);
    void writeTriangles(const Mesh& mesh, const OcclusionMesh& from, const WideTree& tree);
    void writeCutouts(const Mesh& mesh, const OcclusionMesh& from);

    gl::TexelHeap nodes_, triangles_, cutouts_, alphas_;
    gl::BufferTexture instances_;
    std::size_t instanceBytes_ = 0;
    std::vector<Mesh> meshes_;
    std::map<const AlphaImage*, Image> images_;
    gl::TexelRange upper_;  ///< Nodes of the tree over instances.
};

}  // namespace candela
