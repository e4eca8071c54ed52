#pragma once

#include "base/error_context.h"
#include "gl/buffer.h"
#include "gl/context_binding.h"
#include "render/culling/mesh_clusters.h"
#include "render/deformation/gpu_deformations.h"
#include "render/frustum.h"
#include "render/gpu_scene/draw_list.h"
#include "render/gpu_scene/gpu_images.h"
#include "render/gpu_scene/gpu_instances.h"
#include "render/gpu_scene/gpu_lights.h"
#include "render/gpu_scene/gpu_materials.h"
#include "render/gpu_scene/gpu_meshes.h"
#include "render/gpu_scene/node_transforms.h"
#include "render/gpu_scene/property_tracks.h"
#include "render/gpu_scene/slots.h"
#include "render/subdivision/gpu_cages.h"

#include <candela/gpu_scene.h>

#include <array>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace candela {

class GpuEnvironment;
class OcclusionCuller;
class OcclusionScene;
class TriangleFilter;

/// What a `GpuScene` holds. Edits only mark what they change; `update` does the work, in proportion to that.
struct GpuScene::State {
    /// The pixels of `taken` are those of the scene's images, or there are none.
    State(const Context& context, const Scene& scene, std::span<Image> taken, const GpuSceneOptions& options);
    ~State();

    // Nodes, materials and the rest are named by their indices; those of handles come from the slots.

    void setTransform(std::uint32_t node, const glm::mat4& local);
    void setTransforms(std::span<const NodeTransform> nodeTransforms);
    void setVisibilities(std::span<const NodeVisibility> visibilities);
    NodeHandle addNode(const Node& node);
    void removeNode(std::uint32_t node);
    MeshHandle addMesh(const Mesh& mesh);
    void replaceMesh(std::uint32_t index, const Mesh& mesh);
    void removeMesh(std::uint32_t index);
    void setPositions(std::uint32_t index, std::span<const glm::vec3> positions,
                      std::span<const glm::vec3> normals);
    void setPositions(std::uint32_t index, const BufferRange& vertices, const Bounds& bounds);
    CageHandle addCage(const Cage& cage);
    void replaceCage(std::uint32_t index, const Cage& cage);
    void removeCage(std::uint32_t index);
    MaterialHandle addMaterial(const Material& material);
    void removeMaterial(std::uint32_t index);
    ImageHandle addImage(const Image& image);
    void replaceImage(std::uint32_t index, const Image& image);
    void removeImage(std::uint32_t index);
    void setPixels(std::uint32_t index, const ImageRegion& region, std::span<const std::byte> pixels);
    void setPixels(std::uint32_t index, const ImageRegion& region, const BufferRange& pixels);
    LightHandle addLight(const Light& light);
    void setLight(std::uint32_t index, const Light& light);
    void removeLight(std::uint32_t index);
    void setLights(const BufferRange& records, std::uint64_t count);
    void setTime(double seconds);
    void keepPoses();
    /// The vertices of a mesh that the frame callback had moved elsewhere at the last `keepPoses`; null: they
    /// are where they were.
    const SceneUpdate::MeshVertices* keptVertices(std::uint32_t mesh) const;
    void playAnimations(std::span<const std::uint32_t> animations);
    void setLights(std::span<const WorldLight> lights);
    void setCagePoints(std::uint32_t node, std::span<const glm::vec3> points);
    void setMaterial(std::uint32_t index, const Material& material);
    void setVisibility(std::uint32_t node, Visibility visibility);
    void setCastsShadow(std::uint32_t node, ShadowCasting casting);
    void setEnvironment(const std::optional<Environment>& environment);
    void setEnvironmentSettings(const EnvironmentSettings& settings);

    /// Is there an environment that lights surfaces?
    bool hasEnvironmentLight() const;
    /// And does a material have an occlusion texture that dims its light?
    bool usesOcclusionTextures() const;

    /// Brings the device's records to where the edits since the last call have put them.
    void update();
    /// Brings the cages to the levels for a frame of `width` × `height` pixels, and their vertices to their
    /// points. To be called after `update` and before `cull`; does nothing in a scene without cages.
    void updateCages(const CameraView& view, int width, int height, VertexScope scope);
    bool hasCages() const { return !cages.empty(); }
    /// Deforms the meshes in view whose vertices are not up to date. To be called after `update` and before
    /// `cull`; does nothing in a scene without deformed meshes.
    void updateDeformations(const Frustum& frustum, VertexScope scope);
    bool hasDeformations() const { return !deformations.empty(); }
    /// Brings `occlusion` in step with the scene. To be called after both, for vertices everywhere.
    void updateOcclusion();
    /// Selects the draws whose bounding spheres the frustum meets. To be called after `update`.
    void cull(const Frustum& frustum, DrawSelection& selection) const;
    /// The same without instances of meshes that opaque ones hide wholly (`OcclusionCuller`), for what is
    /// drawn with a depth test alone. All are selected on hardware devices.
    void cullOccluded(const Frustum& frustum, const layout::FrameUniforms& frame,
                      DrawSelection& selection) const;

    /// Binds the vertices of the meshes to a vertex array.
    void describeMeshes(const gl::VertexArray& array) const;
    /// The vertex array from which commands with such a key draw.
    GLuint vertexArrayOf(const PipelineKey& key) const;
    /// The level of the cage of an instance, 0 for polygons; none for a mesh.
    std::optional<std::uint32_t> levelOf(std::uint32_t instance) const;
    /// Lines of the cages of a selection.
    void appendLines(CageLineKind kind, const DrawSelection& selection, std::vector<CageLines>& lines);

    /// How many elements of each kind an update has recomputed.
    struct UpdateCounts {
        std::size_t nodes = 0, instances = 0, lights = 0, materials = 0;
        std::size_t cages = 0;         ///< Instances of cages posed.
        std::size_t deformations = 0;  ///< Deformed meshes posed.
        std::size_t deformed = 0;      ///< Meshes whose vertices were computed, by `updateDeformations`.
        std::size_t draws = 0;         ///< Regrouped.
    };
    UpdateCounts lastUpdate;

    std::shared_ptr<const gl::ContextBinding> binding;
    GpuSceneOptions options;
    /// What edits need of the scene: materials, lights, and which nodes are visible and cast shadows, as they
    /// are now; images without pixels; meshes without vertices. The nodes' transforms as they are now are in
    /// `transforms`.
    Scene sceneState;
    std::array<std::uint64_t, 3> elements;  ///< Drawn triangles, lines and points.
    Slots nodeSlots, meshSlots, cageSlots, materialSlots, imageSlots, lightSlots;
    std::vector<MeshParts> meshParts;  ///< One a mesh.
    /// Created by the first frame that traces rays.
    std::unique_ptr<OcclusionScene> occlusion;
    std::uint64_t alphaVersion = 1;   ///< Grows when a material that masks or blends by alpha changes.
    std::uint64_t imagesVersion = 1;  ///< Grows when an image changes.
    std::unique_ptr<GpuEnvironment> environment;  ///< Null without one.

    NodeTransforms transforms;
    /// Computed while the device's memory for `meshes` is allocated, on which one thread works as long.
    std::future<MeshClusters> clustersToCome;
    GpuMeshes meshes;
    MeshClusters clusters;
    GpuImages images;
    GpuMaterials materials;
    GpuLights lights;
    GpuCages cages;
    GpuDeformations deformations;
    GpuInstances instances;
    DrawList draws;
    gl::VertexArray vertexArray{"meshes"};
    gl::VertexArray furtherUvArray{"meshes with further texture coordinates"};  ///< For keys that read these.
    std::unique_ptr<TriangleFilter> triangleFilter;
    std::unique_ptr<OcclusionCuller> occlusionCuller;  ///< Null on hardware devices.

  private:
    void requireFreshImages(const Material& material, const ErrorContext& element) const;
    void requireDetail(const Material& material, const ErrorContext& element) const;
    void requireMesh(const Mesh& mesh, const ErrorContext& element) const;
    void requireRigid(std::uint32_t mesh, const ErrorContext& element) const;
    void moveVertices(std::uint32_t mesh, std::span<const glm::vec3> positions,
                      std::span<const glm::vec3> normals);
    void requireNode(const Node& node, std::uint32_t index, const ErrorContext& element) const;
    void appendNode(std::uint32_t index);
    void showMesh(std::uint32_t node, std::uint32_t mesh);
    void showCage(std::uint32_t node);
    void hideMesh(std::uint32_t node);
    void hideCage(std::uint32_t node);
    void requireCage(const Cage& cage, const ErrorContext& element) const;
    void requireStill(std::uint32_t cage, const ErrorContext& element) const;
    void takeCage(std::uint32_t index, const Cage& cage, std::unique_ptr<CageTables> tables);
    std::vector<std::uint32_t> nodesOfCage(std::uint32_t index) const;
    void prepareDraws(const CageMaterials& parts);
    void eraseNode(std::uint32_t node);
    void countElements(const MeshParts& parts, int sign);
    void takeMesh(std::uint32_t index, const Mesh& mesh);
    void redescribe();
    template <typename Visit>
    void forEachInstanceOf(std::uint32_t mesh, const Visit& visit);
    void updateCommonUvs(const MeshParts& parts);
    UvSets commonUvsOf(std::uint32_t material) const;
    bool isOfMesh(std::uint32_t material) const;
    void prepareDraws(const MeshParts& parts);
    void imageChanged(std::uint32_t index);
    void requireSceneLights() const;
    void resetLights();
    std::uint32_t lightPlace(std::uint32_t light) const {
        return lightPlaces_.empty() ? light : lightPlaces_[light];
    }
    static void requireIndex(const char* kind, std::uint32_t index, std::size_t count);
    bool takes(const PropertyChannel& channel) const;
    std::shared_ptr<const SceneUpdate> updateOf(double seconds) const;
    void takeUpdate();
    ErrorContext nodeContext(std::uint32_t node) const;
    void applyMaterial(std::uint32_t index, const Material& material);
    void reserveAnimatedLobes();
    void poseProperties();
    void updateLight(std::uint32_t index);
    void updateVisibility(std::uint32_t root);
    void applyVisibility(std::uint32_t node);
    void selectVisible(const Frustum& frustum, DrawSelection& selection) const;
    void createTriangleFilter(const Context& context);
    void addDraws(const Scene& scene);
    RangeRule rangeRule();
    void updateRanges();
    void addMeshDraws(std::uint32_t instance, std::uint32_t mesh, const Scene& scene);
    void listNodeLights();
    void moveNode(std::uint32_t node);
    void place(std::uint32_t instance, const glm::mat4& worldFromLocal, const BoundingSphere& sphere,
               std::optional<Winding> winding = {});
    void placeCage(std::uint32_t cageInstance);
    void placeDeformed(std::uint32_t index);

    DefaultDetail defaultDetail_;
    std::vector<std::uint32_t> stale_;  ///< Of the `updateDeformations` in progress.
    bool timeChanged_ = true;
    std::shared_ptr<const SceneUpdate> update_;  ///< Of the frame callback; null without one.
    std::shared_ptr<const SceneUpdate> kept_;    ///< The same at the last `keepPoses`.
    bool rangeRuleChanged_ = false;
    bool lightsEdited_ = false;                           ///< Lights were added, removed or replaced.
    std::vector<std::uint32_t> lightPlaces_;              ///< Of each light in `lights`; empty: its index.
    std::vector<std::uint32_t> meshUsers_;                ///< How many nodes show each mesh.
    bool lightsFollowNodes_ = false;                      ///< Until `setLights`.
    std::vector<std::vector<std::uint32_t>> nodeLights_;  ///< Lights of each node; empty without any.
    PropertyTracks<Material> materialTracks_;
    PropertyTracks<Light> lightTracks_;
    PropertyTracks<Node> nodeTracks_;
    std::vector<bool> isHidden_;   ///< By `setVisibility`.
    std::vector<bool> isVisible_;  ///< By `Node::visible` of the node and of all above it.
};

}  // namespace candela
