#pragma once

#include "gl/buffer.h"
#include "gl/context_binding.h"
#include "gl/texture.h"
#include "render/frustum.h"
#include "render/gpu_scene/draw_list.h"
#include "render/gpu_scene/gpu_images.h"
#include "render/gpu_scene/gpu_lights.h"
#include "render/gpu_scene/gpu_meshes.h"
#include "render/gpu_scene/surface_uvs.h"
#include "render/subdivision/cage_lines.h"
#include "render/subdivision/gpu_cages.h"

#include <candela/gpu_scene.h>

#include <memory>
#include <optional>
#include <vector>

namespace candela {

/// A mesh or a cage as a node shows it.
struct Instance {
    std::uint32_t node = 0;
    std::optional<std::uint32_t> mesh;  ///< Index into `Scene::meshes`; none: it is a cage.
    std::uint32_t shown = 0;            ///< Index into `GpuCages::shown` for a cage.
};

/// What a `GpuScene` holds. The only place where the scene layer's types meet OpenGL.
struct GpuScene::State {
    State(const Context& context, const Scene& scene, const GpuSceneOptions& options);

    /// Brings the instances and lights to where `setTransform` and `setTime` have put their nodes since the
    /// last call.
    void update();
    /// Brings the cages to the levels that a frame of `width` × `height` pixels asks for, and to where their
    /// points are. To be called after `update` and before `cull`; does nothing in a scene without cages.
    void updateCages(const CameraView& view, int width, int height);
    bool hasCages() const { return !cages.empty(); }
    /// Selects the draws whose bounding spheres the frustum meets. To be called after `update`.
    void cull(const Frustum& frustum, DrawSelection& selection) const;

    /// The vertex array from which the commands of a batch draw.
    GLuint vertexArrayOf(const DrawBatch& batch) const;
    /// The level to which the cage that instance shows is refined, 0 for polygons; none for a mesh.
    std::optional<std::uint32_t> levelOf(std::uint32_t instance) const;
    /// Lines of the cages of a selection, made on demand.
    void appendLines(CageLineKind kind, const DrawSelection& selection, std::vector<CageLines>& lines);

    void setCagePoints(std::uint32_t node, std::span<const glm::vec3> points);
    void setMaterial(std::uint32_t index, const Material& material);
    void setVisibility(std::uint32_t node, Visibility visibility);

    std::shared_ptr<const gl::ContextBinding> binding;
    GpuSceneOptions options;
    /// Nodes, animations, lights, cages and skins: what moves; and materials, which can be replaced. Images
    /// have lost their pixels, and meshes are not kept.
    Scene sceneState;
    double time = 0.0;
    bool moved = true;
    bool lightsReplaced = false;  ///< By `setLights`: nodes move them no longer.
    std::uint64_t triangles = 0;
    std::uint32_t materialCount = 0;
    SurfaceUvs surfaceUvs;

    GpuMeshes meshes;
    GpuImages images;
    GpuLights lights;
    GpuCages cages;
    std::vector<Instance> instances;
    std::vector<glm::vec4> instanceSpheres;  ///< World centre and radius.
    gl::BufferTexture instanceRecords, materialRecordTexture;
    DrawList draws;
    gl::VertexArray vertexArray;  ///< Of the meshes.

  private:
    void addDraws(const Scene& scene);
    void place();
    void uploadInstances(const std::vector<glm::mat4>& world);

    DefaultDetail defaultDetail_;
    std::vector<glm::vec4> records_;
    std::vector<bool> hidden_;  ///< One an instance.
};

}  // namespace candela
