#pragma once

#include "gl/buffer.h"
#include "gl/texture.h"
#include "render/draw_list.h"
#include "render/frustum.h"
#include "render/gpu_images.h"
#include "render/gpu_lights.h"
#include "render/gpu_meshes.h"

#include <candela/gpu_scene.h>

#include <memory>
#include <vector>

namespace candela {

/// What a `GpuScene` holds. The only place where the scene layer's types meet OpenGL.
struct GpuScene::State {
    State(const Scene& scene, const GpuSceneOptions& options);

    /// Brings the instances and lights to where `setTransform` and `setTime` have put their nodes since the
    /// last call.
    void update();
    /// Picks the draws that the frustum meets. To be called after `update`.
    void select(const Frustum& frustum);

    GpuSceneOptions options;
    Scene skeleton;  ///< Nodes, animations and lights: what moves. Meshes and images are not kept.
    double time = 0.0;
    bool moved = true;
    bool lightsReplaced = false;  ///< By `setLights`: nodes move them no longer.
    std::uint64_t triangles = 0;
    std::uint32_t materialCount = 0;

    std::vector<Instance> instances;
    std::vector<glm::vec4> instanceSpheres;  ///< World centre and radius.
    GpuMeshes meshes;
    GpuImages images;
    GpuLights lights;
    gl::BufferTexture instanceRecords, materialRecordTexture;
    DrawList draws;
    gl::VertexArray vertexArray;

  private:
    void uploadInstances(const std::vector<glm::mat4>& world);

    std::vector<glm::vec4> records_;
    std::vector<bool> mirrored_;
};

}  // namespace candela
