#pragma once

#include "render/culling/filter_view.h"
#include "render/culling/occluder_mesh.h"
#include "render/culling/occluder_polygon.h"
#include "render/culling/occlusion_buffer.h"
#include "render/gpu_scene/draw_list.h"

#include <candela/gpu_scene.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// Finds what is hidden wholly before it is drawn: walls, floors and other large triangles go into a
/// low-resolution depth buffer, against which the boxes of all instances are tested, and large triangles one
/// by one. For software devices, whose meshes the CPU reads. What is drawn is the same bit for bit: only what
/// surely loses the depth test at every pixel is left out, and the order of the rest stays. A mesh hides
/// others from the second frame on in which it is in view and its vertices rest.
class OcclusionCuller {
  public:
    /// `scene` outlives the culler.
    explicit OcclusionCuller(const GpuScene::State& scene) : scene_(scene) {}

    struct Hidden {
        std::span<const std::uint32_t> instances;
        std::span<const HiddenTriangle> triangles;  ///< Of other instances, in order.
    };
    /// What is hidden of `visible`, the instances in view in their order; until the next call. Where that was
    /// nothing, the next frames are not searched.
    Hidden findHidden(const layout::FrameUniforms& frame, std::span<const std::uint32_t> visible);

  private:
    struct CachedMesh {
        std::uint64_t version = 0;
        std::uint32_t changes = 0;              ///< Versions seen.
        std::uint64_t since = 0;                ///< The search that has found the version.
        std::optional<Bounds> box;              ///< None: it has lines or points, or nothing.
        std::optional<OccluderMesh> triangles;  ///< None until they may hide others.
    };
    /// Triangles of an instance with one material, some of which look large.
    struct Candidate {
        std::uint32_t instance = 0;
        float facing = 0.0f;  ///< As in `FilterView`.
        TriangleRange drawn{};
        std::uint32_t first = 0, count = 0;        ///< Of `chosen_`.
        std::uint32_t firstBox = 0, boxCount = 0;  ///< Of `boxes_`.
    };

    std::span<const float> verticesOf(const MeshPlace& at) const;
    CachedMesh* meshOf(std::uint32_t instance);
    /// Null where the triangles of an instance are too many, or too small to hide others.
    const OccluderMesh* occluderOf(std::uint32_t instance, const glm::vec3& eye);
    bool drawOccluders(const layout::FrameUniforms& frame, const FilterCamera& camera,
                       std::span<const std::uint32_t> visible);
    void findHiddenInstances(const FilterCamera& camera, std::span<const std::uint32_t> visible);
    void findHiddenTriangles();
    void chooseTriangles(const glm::vec3& eye, std::uint32_t instance, const OccluderMesh& mesh);
    layout::FilterView viewOf(const FilterCamera& camera, std::uint32_t instance, float facing) const;

    const GpuScene::State& scene_;
    std::vector<CachedMesh> meshes_;
    OcclusionBuffer buffer_;
    unsigned framesToSkip_ = 0;
    std::uint64_t searches_ = 0;
    std::uint32_t trianglesRead_ = 0;  ///< In the call in progress.
    bool awaitsMeshes_ = false;        ///< Some may hide others in the next frame, which hide nothing yet.
    // Of the call in progress.
    std::vector<Candidate> candidates_;
    std::vector<std::uint32_t> chosen_;
    OccluderSetup setup_;
    std::vector<OccluderPolygon> polygons_;
    std::vector<TriangleBox> boxes_;
    std::vector<std::uint8_t> isHidden_;  ///< Of `visible`.
    std::vector<std::uint32_t> hidden_;
    std::vector<HiddenTriangle> hiddenTriangles_;
};

}  // namespace candela
