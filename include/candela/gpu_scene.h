#pragma once

#include <candela/color.h>
#include <candela/context.h>
#include <candela/export.h>
#include <candela/handle.h>
#include <candela/scene.h>
#include <candela/subdivider.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace candela {

/// How far cages are refined.
struct SubdivisionSettings {
    /// The level of all cages, 1 to `maxSubdivisionLevel`. None: a cage that states a level has that one, the
    /// level of every other follows its size on the screen.
    std::optional<std::uint32_t> level = {};
    float edgePixels = 8.0f;     ///< By size: the length of edges on the screen to aim for, pixels, over 0.
    std::uint32_t maxLevel = 5;  ///< By size: the maximum level, 1 to `maxSubdivisionLevel`.
    /// By size: the maximum number of vertices of a refined cage, 1 or more. Level 1 may exceed it.
    std::uint64_t maxVertices = 2'000'000;
};

/// What computes the vertices of refined cages and of deformed meshes.
enum class VertexEvaluator {
    automatic,  ///< `cpu` on a software rasteriser, `compute` on a GPU.
    cpu,        ///< The threads of the CPU (see candela/threads.h).
    compute,    ///< A compute shader; the CPU for what does not fit the device's storage blocks.
};

/// The evaluator's name on the command line: "auto", "cpu", "compute".
CANDELA_API const char* toString(VertexEvaluator evaluator);

/// Which attributes of vertices are on the device besides positions and normals: tangents, texture
/// coordinates and colours.
enum class VertexDetail {
    asNeeded,  ///< Those that a material of the scene, or one made from its images, can read.
    always,    ///< All. For scenes that get their first image, or their first such mesh, later.
};

struct GpuSceneOptions {
    /// From linear Rec.709, in which scenes give colours, to the working space
    /// (`ColorConfig::workingFromRec709`).
    glm::dmat3 workingFromRec709{1.0};
    /// What point and spot lights without a range may lose together at any point, as a share of the light
    /// that they give there; over 0 and under 1. Each gets a range (docs/lighting.md). A highlight counts
    /// with the height of its lobe over diffuse white, so that a scene of sharper materials gets longer
    /// ranges.
    float rangeLoss = 0.01f;
    /// Refines the cages (`PluginRegistry::subdivider`); none: their polygons are drawn.
    std::optional<Subdivider> subdivider = {};
    SubdivisionSettings subdivision = {};
    VertexEvaluator vertexEvaluator = VertexEvaluator::automatic;
    VertexDetail vertexDetail = VertexDetail::asNeeded;
};

/// A rectangle of an image, texels from the first one of the first row.
struct ImageRegion {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

/// Bytes of a buffer of the current OpenGL context, from `offset` on.
struct BufferRange {
    std::uint32_t name = 0;  ///< The GL name.
    std::uint64_t offset = 0;
};

/// A light in a buffer (`GpuScene::setLights`): four vec4, as std430 lays them out.
struct LightRecord {
    float position[3] = {};   ///< As `WorldLight`, likewise the others.
    float range = {};         ///< 0: none given.
    float direction[3] = {};  ///< Unit length.
    float type = {};          ///< The number of the `LightType`: 0, 1 or 2.
    float intensity[3] = {};
    float castsShadow = {};  ///< 0 or 1.
    float innerConeAngle = {}, outerConeAngle = {};
    float radius = {};
    float unused = {};
};

/// The lights of a `GpuScene` as of the last frame, upload or `setLights`.
struct LightReport {
    std::uint64_t lights = 0;
    std::uint64_t rangesAssigned = 0;  ///< Lights without a range of their own.
    /// An assigned range ends where the light gives this irradiance, in lux; 0 without such lights, or where
    /// they have nothing to light.
    double rangeIrradiance = 0.0;
    float minRange = 0.0f, maxRange = 0.0f;  ///< Of the assigned ranges, metres; 0 without any.
};

/// The cages of a `GpuScene` as of the last frame (before the first, as of the upload).
struct CageReport {
    std::uint64_t cages = 0;                   ///< Nodes that show a cage.
    bool subdivided = false;                   ///< False without a subdivider: polygons are drawn.
    std::uint64_t triangles = 0;               ///< Of all nodes that show a cage, together.
    std::uint64_t tableBytes = 0;              ///< Memory of all stencil tables created so far.
    std::uint32_t minLevel = 0, maxLevel = 0;  ///< Levels drawn; 0 without a subdivider or a frame.
    std::uint64_t lodClamped = 0;  ///< Nodes whose cage has a lower level than `edgePixels` requests, because
                                   ///< of `maxLevel` or `maxVertices`.
    std::string evaluator = {};    ///< What has computed the vertices: "cpu" or "compute"; empty before.
};

/// The meshes of a `GpuScene` that skins or morph targets move.
struct DeformationReport {
    std::uint64_t meshes = 0;    ///< Nodes that show such a mesh.
    std::uint64_t vertices = 0;  ///< Of all of these together.
    /// What has deformed them last: "cpu" or "compute"; empty before the first frame.
    std::string evaluator = {};
};

/// The structure that occlusion rays are traced in, as of the last frame with shadows; all 0 before.
struct OcclusionReport {
    std::uint64_t triangles = 0;      ///< Of all meshes, each counted once.
    std::uint64_t instances = 0;      ///< That cast shadows.
    std::uint64_t bytes = 0;          ///< Memory of the structure, on the CPU and on the device.
    double buildMilliseconds = 0.0;   ///< Of the trees of all meshes, when each was built last.
    double updateMilliseconds = 0.0;  ///< Of what the last frame brought up to date.
};

/// A `Scene` on the device. The scene given to the constructor is not kept; what edits need of it is copied.
///
/// Edits mark what they change, and the next frame brings the device up to date, at a cost in proportion to
/// the change. They check their arguments, throw `Error` (badInput) that names the element or says that its
/// handle is stale, and change nothing then. `setLights`, edits of cages, meshes, images, materials and the
/// environment, and nodes that are added or removed throw `Error` (environment) while the context is not
/// current on this thread. Every function throws `Error` (badInput) on an object that has been moved from.
///
/// Elements are added, removed and replaced while the scene is on the device, and nothing else is uploaded
/// again; the next frame sorts the draws anew. In elements that are added, indices of parents, meshes,
/// materials and images are those of their handles. What is drawn after any edits is what a `GpuScene` made
/// from the edited scene draws, but where surfaces lie in exactly the same place.
class CANDELA_API GpuScene {
  public:
    /// Uploads. Throws `Error`: badInput when the scene breaks a rule of `validate`, an option is out of its
    /// range or the subdivider rejects a cage; limit that names what does not fit the device; environment as
    /// the constructor of `Renderer` does.
    GpuScene(const Context& context, const Scene& scene, const GpuSceneOptions& options = {});
    /// The same, and frees the pixels of each image of the scene as soon as they are uploaded, so that pixels
    /// and textures of all images are not in memory together. The images of `scene` have no pixels then, also
    /// where an error is thrown; the rest of it stays.
    static GpuScene takingPixels(const Context& context, Scene& scene, const GpuSceneOptions& options = {});
    GpuScene(GpuScene&&) noexcept;
    GpuScene& operator=(GpuScene&&) noexcept;
    ~GpuScene();

    /// Replaces all lights, those of the scene included: one upload. Nodes and animations change lights no
    /// longer. Throws `Error`: badInput naming a light whose numbers break what `WorldLight` states, limit
    /// when the device can not hold as many.
    void setLights(std::span<const WorldLight> lights);
    /// The same with `count` lights of a GL buffer of `LightRecord`s. They are read back, which waits for who
    /// writes the buffer, and costs 64 bytes a light from the device.
    void setLights(const BufferRange& records, std::uint64_t count);
    /// Sets a node's local matrix, which moves the node and all below it. Animations of translation, rotation
    /// and scale do not move the node any more; those of morph weights go on. Throws `Error` (badInput) when
    /// there is no such node, a number is not finite or the last row is not 0, 0, 0, 1.
    void setTransform(NodeHandle node, const glm::mat4& local);
    struct NodeTransform {
        NodeHandle node = {};
        glm::mat4 local{1.0f};
    };
    /// The same of many nodes. Of one that is listed twice the later matrix counts. All are checked before
    /// any is changed.
    void setTransforms(std::span<const NodeTransform> transforms);
    /// Poses all animated nodes, what is below them, and the animated properties of nodes, materials and
    /// lights, as at `seconds`, a finite number; so does the scene's frame callback with what it moves. What
    /// is drawn depends on `seconds` alone, and not on the times before. Cameras are posed by `cameraView`.
    /// Throws what the frame callback does; the scene stays at the time before then.
    void setTime(double seconds);
    /// Remembers where all nodes are, as set so far, for the AOV `motion`: it shows the way from there. So it
    /// does for what moves vertices within a node: skins, morph targets, points of cages and the scene's
    /// frame callback, but not `setPositions`. Before the first call nothing moves but the camera.
    void keepPoses();
    /// Lets the animations of these indices play (`Animation::plays`), and no other. What only others change
    /// returns to what it is in the scene. Throws `Error` (badInput) when there is no such animation.
    void playAnimations(std::span<const std::uint32_t> animations);
    /// Replaces the points of the cage of a node (one per vertex of the cage, in the node's frame). Morph
    /// targets and skin do not move it any more. Throws `Error` (badInput) when there is no such node, it
    /// shows no cage, the number of points differs or one of them is not finite.
    void setCagePoints(NodeHandle node, std::span<const glm::vec3> points);
    /// Throws `Error` (badInput) when a setting is out of its range.
    void setSubdivision(const SubdivisionSettings& settings);
    /// Replaces a material, textures and pipeline state included. Throws `Error`: badInput when there is no
    /// such material, the new one breaks what `Material` states or a surface lacks texture coordinates that
    /// it reads; limit when an image does not fit the device. Animations do not change the material any more.
    void setMaterial(MaterialHandle handle, const Material& material);
    enum class Visibility { shown, hidden };
    /// Shows or hides the mesh and the cage of the node itself; its children are not affected. What is not
    /// visible in the scene (`Node::visible`) stays so. Throws `Error` (badInput) when there is no such node.
    void setVisibility(NodeHandle node, Visibility visibility);
    struct NodeVisibility {
        NodeHandle node = {};
        Visibility visibility = Visibility::shown;
    };
    /// The same of many nodes. All are checked before any is changed.
    void setVisibilities(std::span<const NodeVisibility> visibilities);
    enum class ShadowCasting { on, off };
    /// Whether the mesh and the cage of the node itself cast shadows (`Node::castsShadow`); its children are
    /// not affected. A hidden node casts none. Throws `Error` (badInput) when there is no such node.
    void setCastsShadow(NodeHandle node, ShadowCasting casting);

    /// Adds a node below a node that is there, or a root. A skin and morph targets may move its mesh where
    /// that has been added, or was shown deformed by the scene, but not its cage. Throws `Error` (badInput)
    /// when it breaks what `Node` states or names an element that is not there; unsupported for what it can
    /// not show.
    NodeHandle addNode(const Node& node);
    /// Removes a node, all nodes below it, and their lights. Animations do not name it any more. Throws
    /// `Error` (badInput) when it, or a node below it, is a joint of a skin.
    void removeNode(NodeHandle node);

    /// Uploads a mesh, which nodes added later may show. Of `Mesh::variantMaterials` nothing is used. Throws
    /// `Error`: badInput when it breaks what `Mesh` states or names a material that is not there; limit when
    /// the device has no room; unsupported for more than two sets of texture coordinates, and for attributes
    /// beside positions and normals in a scene that has none (`GpuSceneOptions::vertexDetail`).
    MeshHandle addMesh(const Mesh& mesh);
    /// Replaces a mesh at all nodes that show it. Throws as `addMesh` does, and badInput for a deformed mesh.
    void replaceMesh(MeshHandle handle, const Mesh& mesh);
    /// Throws `Error` (badInput) while a node shows the mesh.
    void removeMesh(MeshHandle handle);
    /// Moves the vertices of a mesh, which no node added later shows deformed then. `normals` may be
    /// empty: they stay. Throws `Error` (badInput) when their numbers are not those of the mesh, one is not
    /// finite, or the mesh is deformed.
    void setPositions(MeshHandle handle, std::span<const glm::vec3> positions,
                      std::span<const glm::vec3> normals = {});
    /// The same with vertices of a GL buffer: position and normal of each, six floats, in `bounds`, what is
    /// beyond which may be missing from the picture. They do not leave the device, but where the CPU reads
    /// meshes (software devices) this waits for it. Throws besides when the buffer is too small.
    void setPositions(MeshHandle handle, const BufferRange& vertices, const Bounds& bounds);

    /// Adds a cage, which nodes added later may show. Throws `Error` (badInput) when it breaks what `Cage`
    /// states, names a material that is not there, or the subdivider rejects it.
    CageHandle addCage(const Cage& cage);
    /// Replaces a cage at all nodes that show it, where points of `setCagePoints` hold no longer. Throws as
    /// `addCage` does, and badInput while a skin or morph targets deform it.
    void replaceCage(CageHandle handle, const Cage& cage);
    /// Throws `Error` (badInput) while a node shows the cage.
    void removeCage(CageHandle handle);

    /// Adds a material. Throws as `setMaterial` does.
    MaterialHandle addMaterial(const Material& material);
    /// Throws `Error` (badInput) while a mesh or a cage has the material.
    void removeMaterial(MaterialHandle handle);

    /// Adds an image, whose pixels are copied and uploaded when a material first reads them. Throws `Error`
    /// (badInput) when it breaks what `Image` states.
    ImageHandle addImage(const Image& image);
    /// Replaces an image in all materials. Throws `Error`: badInput as `addImage`, limit when it does not fit
    /// the device.
    void replaceImage(ImageHandle handle, const Image& image);
    /// Throws `Error` (badInput) while a material reads the image.
    void removeImage(ImageHandle handle);
    /// Replaces texels of an image: rows from the top, tightly packed, in the image's format. Mipmaps are
    /// computed anew. Throws `Error` (badInput) when the region leaves the image, `pixels` have another size
    /// or a float is not finite.
    void setPixels(ImageHandle handle, const ImageRegion& region, std::span<const std::byte> pixels);
    /// The same with pixels of a GL buffer, of which floats are not checked. They pass through the memory of
    /// the CPU. Throws besides when the buffer is too small.
    void setPixels(ImageHandle handle, const ImageRegion& region, const BufferRange& pixels);

    /// Adds a light to those of the scene. Throws `Error` (badInput) when it breaks what `Light` states, or
    /// after `setLights`, which has replaced them.
    LightHandle addLight(const Light& light);
    /// Replaces a light of the scene. Animations do not change it any more.
    void setLight(LightHandle handle, const Light& light);
    void removeLight(LightHandle handle);

    /// Replaces the environment. Filters its picture, which takes some tenths of a second. Throws `Error`:
    /// badInput when it breaks what `Environment` states, limit when its picture does not fit the device.
    void setEnvironment(const std::optional<Environment>& environment);
    /// Turns, dims or shows the environment: costs nothing. Throws `Error` (badInput) when the scene has
    /// none, or a setting breaks what `Environment` states.
    void setEnvironmentSettings(const EnvironmentSettings& settings);

    const LightReport& lightReport() const;
    CageReport cageReport() const;
    DeformationReport deformationReport() const;
    OcclusionReport occlusionReport() const;
    /// Triangles of the meshes, times the nodes that show them; hidden ones included.
    std::uint64_t triangleCount() const;
    /// The same of lines or points.
    std::uint64_t elementCount(Topology topology) const;
    std::uint32_t materialCount() const;

    struct State;  ///< Private to the library.
    State& state();
    const State& state() const;

  private:
    friend class Accumulator;
    friend class Renderer;
    GpuScene(const Context& context, const Scene& scene, std::span<Image> taken,
             const GpuSceneOptions& options);
    void requireContext() const;

    std::shared_ptr<State> state_;
};

}  // namespace candela
