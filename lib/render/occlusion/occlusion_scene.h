#pragma once

#include "render/gpu_scene/draw_list.h"
#include "render/occlusion/embree_scene.h"
#include "render/occlusion/gpu_occlusion.h"
#include "render/occlusion/instance_tree.h"
#include "render/occlusion/mesh_readback.h"
#include "render/occlusion/occlusion_view.h"
#include "render/occlusion/wide_tree.h"

#include <candela/gpu_scene.h>

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace candela {

/// What occlusion rays meet of a `GpuScene`, kept in step with it: instances that move, hide or cast no
/// shadow, deforming meshes, refined cages and alpha masks. Meshes are read back from the device when they
/// are first needed and when they change.
class OcclusionScene {
  public:
    OcclusionScene() = default;
    OcclusionScene(const OcclusionScene&) = delete;
    OcclusionScene& operator=(const OcclusionScene&) = delete;

    /// Brings the structure in step with `scene`, whose cages and deformed meshes are up to date, those out
    /// of view included. The work is in proportion to what has changed since the last call.
    void update(GpuScene::State& scene);
    /// Brings the form for shaders in step with the last `update`. Needs the current context.
    void updateShaderForm();

    const EmbreeScene& rays() const { return embree_; }
    /// Valid until the next `update`.
    const OcclusionView& view() const { return view_; }
    /// As of the last `updateShaderForm`; null before.
    const GpuOcclusion* shaderForm() const { return shaderForm_ ? &*shaderForm_ : nullptr; }
    /// Over the instances that cast shadows.
    const InstanceTree& instanceTree() const { return top_; }
    OcclusionReport report() const;

  private:
    /// What instances share: a mesh of the scene, a deformed mesh or a limit surface.
    struct MeshEntry {
        DrawGeometry geometry;
        std::uint32_t sceneMesh = 0;     ///< Where the geometry is that of meshes.
        std::uint32_t instance = 0;      ///< One that shows it.
        std::uint32_t users = 0;         ///< Instances that show it.
        std::uint64_t version = 0;       ///< Of the vertices.
        std::uint64_t alphaVersion = 0;  ///< Of the materials that mask or blend.
        bool readsAlpha = false;         ///< A part has such a material.
        bool blends = false;             ///< A part has one that lets a part of a ray through.
        bool isNew = false;              ///< Has changed by the `update` in progress.
        bool isNewToShaders = true;      ///< Has changed since `updateShaderForm`.
        double buildMilliseconds = 0.0;
        std::shared_ptr<const OcclusionMesh> mesh;
        WideTree tree;
        std::vector<TriangleBlock> blocks;  ///< One for each leaf of the tree.
    };
    using MeshKey = std::pair<DrawGeometry, std::uint32_t>;

    static constexpr std::uint32_t noMesh = 0xffffffffu;

    struct InstanceEntry {
        std::uint32_t mesh = noMesh;  ///< None yet, or the instance has been removed.
        glm::mat4 worldFromLocal{1.0f};
        bool casts = false;
        bool blends = false;          ///< It casts a shadow that lets a part of the light through.
        bool isNewToShaders = false;  ///< As of `MeshEntry`.
    };

    std::uint32_t meshOf(const GpuScene::State& scene, std::uint32_t instance);
    void updateUsers(const GpuScene::State& scene, std::uint32_t instance);
    void release(std::uint32_t mesh);
    void updateMeshes(const GpuScene::State& scene);
    void build(const GpuScene::State& scene, std::uint32_t index);
    void updateInstance(const GpuScene::State& scene, std::uint32_t index);
    void listUsersOfNewMeshes(std::vector<std::uint32_t>& instances);
    void placeInstances(std::span<const std::uint32_t> instances);
    Bounds placeInstance(std::uint32_t index);
    void updateShaderInstances();

    EmbreeScene embree_;
    std::vector<MeshEntry> meshes_;
    std::map<MeshKey, std::uint32_t> meshIndices_;
    std::vector<InstanceEntry> instances_;              ///< All of the scene.
    std::vector<OcclusionInstanceView> instanceViews_;  ///< Of all; those that cast shadows are filled.
    InstanceTree top_;                                  ///< Over those that cast shadows.
    std::size_t blending_ = 0;                          ///< Instances that blend.
    OcclusionView view_{};
    std::optional<GpuOcclusion> shaderForm_;
    std::vector<std::uint32_t> newToShaders_;  ///< Instances.
    AlphaImages alphaImages_;
    std::uint64_t imagesVersion_ = 0;  ///< Of the scene's, to which `alphaImages_` belong.
    bool meshesChanged_ = false;       ///< By the last `updateMeshes`.
    double updateMilliseconds_ = 0.0;
};

}  // namespace candela
