#pragma once

#include "gl/texel_heap.h"
#include "render/gpu_scene/record_buffer.h"
#include "render/occlusion/instance_tree.h"
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

    /// Sets mesh `index`; meshes in between are empty. `tree` is of its triangles. Calls of `setInstance` for
    /// those that show it have to follow before rays are traced. Throws `Error` (limit) beyond what the
    /// device holds: the mesh is empty then.
    void setMesh(std::uint32_t index, const OcclusionMesh& mesh, const WideTree& tree);
    /// Sets an instance, which `setTree` uploads. One whose matrix is singular or not finite, or whose mesh
    /// is empty, casts no shadow. Throws `Error` (limit) where the device does not hold as many.
    void setInstance(std::uint32_t index, const OcclusionInstance& instance);
    /// Sets the tree over the instances' world-space boxes, `InstanceTree::nodes`, and uploads what has
    /// changed of it since the last call and the instances that were set. What is not in the tree, such as a
    /// hidden instance, casts no shadow. Throws as `setMesh` does: there are no instances then.
    void setTree(std::span<const WideNode> nodes, unsigned depth, const InstanceTree::Changes& changes);

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
    void setRoot(std::uint32_t node);
    void writeNodes(std::span<const WideNode> nodes, std::uint32_t first);

    gl::TexelHeap nodes_, triangles_, cutouts_, alphas_;
    RecordBuffer<glm::uvec4> instances_;  ///< The first record has the root; then one an instance.
    std::vector<Mesh> meshes_;
    std::map<const AlphaImage*, Image> images_;
    gl::TexelRange upper_;  ///< Nodes of the tree over instances, with room for more.
};

}  // namespace candela
