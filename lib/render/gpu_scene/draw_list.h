#pragma once

#include "gl/buffer.h"
#include "render/gpu_scene/gpu_images.h"
#include "render/gpu_scene/gpu_meshes.h"
#include "render/gpu_scene/lobe_records.h"
#include "scene/model/uv_sets.h"

#include <candela/gpu_scene.h>
#include <candela/mesh.h>

#include <array>
#include <compare>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace candela {

/// Which vertices a draw reads.
struct DrawGeometry {
    enum class Kind {
        meshes,        ///< Those of all meshes that are not deformed.
        deformedMesh,  ///< `index` counts the meshes of `GpuDeformations`.
        cage,          ///< `index` counts the limit surfaces of `GpuCages`.
    };
    Kind kind = Kind::meshes;
    std::uint32_t index = 0;

    auto operator<=>(const DrawGeometry&) const = default;
};

/// Whether draws read the occlusion textures of their materials: where there is an environment.
enum class OcclusionTextures { ignored, read };

/// Which surfaces a pass draws.
enum class SurfaceSet {
    opaque,       ///< Those that hide what is behind them.
    transparent,  ///< Those that are drawn in layers (docs/layers.md).
    all,          ///< Both.
};

/// How surfaces that transmit show the picture behind them. Each can do what those before it can.
enum class Backdrop {
    none,       ///< Nothing transmits.
    sharp,      ///< As it is.
    blurred,    ///< With prefiltered levels.
    dispersed,  ///< At places that differ by colour.
};

/// What draws need of a mesh: its submeshes with indices.
struct MeshParts {
    struct Part {
        IndexRange indices;  ///< Within the mesh.
        std::optional<std::uint32_t> material;
        Topology topology = Topology::triangles;
        bool unlit = false;  ///< Lines and points without normals.
    };
    std::vector<Part> parts;
    bool hasColors = false;      ///< Of vertices.
    bool hasFurtherUvs = false;  ///< More than two sets of texture coordinates.
    UvSets uvs = 0;
    std::uint32_t jointCount = 0;  ///< That the mesh needs of a skin; 0: no skin moves it.
    std::uint32_t morphTargetCount = 0;
    /// Indices of triangles, lines and points.
    std::uint64_t elements(Topology topology) const;
    bool hasOnlyTriangles() const { return elements(Topology::lines) + elements(Topology::points) == 0; }
};

/// A mesh without submeshes is one submesh with the default material.
MeshParts partsOf(const Mesh& mesh);

/// The OpenGL state that a draw needs. Draws with equal keys are issued together.
struct PipelineKey {
    enum class Program {
        plain,
        textured,
        extended,  ///< `textured` with the lobes of `isExtended`.
    };

    bool emissive = false;  ///< Writes radiance; drawn after all that does not (see `GeometryPass`).
    bool transparent = false;
    Backdrop backdrop = Backdrop::none;
    Program program = Program::plain;
    bool doubleSided = false;
    bool mirrored = false;                    ///< The instance's matrix reverses the winding.
    Topology topology = Topology::triangles;  ///< Lines and points are double-sided and not mirrored.
    bool unlit = false;                       ///< Lines and points without normals.
    /// Base colour, metallic-roughness, normal, emission; unset for plain. Then occlusion, unset where no
    /// material has it or nothing reads it.
    std::array<SampledTexture, 5> textures{};
    /// Pairs of the sets of texture coordinates from 2 on that textures read.
    std::uint32_t furtherUvPairs = 0;
    std::uint32_t lobeTextures = 0;  ///< Of `extended`: index for `DrawList::lobeTextures`.
    DrawGeometry geometry{};

    auto operator<=>(const PipelineKey&) const = default;

    bool isIn(SurfaceSet set) const {
        return set == SurfaceSet::all || transparent == (set == SurfaceSet::transparent);
    }
};

/// What shaders of a key with further sets of texture coordinates are compiled with.
inline std::string furtherUvDefinition(const PipelineKey& key) {
    return "FURTHER_UVS " + std::to_string(key.furtherUvPairs);
}

/// The commands of a selection that share a pipeline key.
struct DrawBatch {
    PipelineKey key;
    std::uint32_t firstCommand = 0, commandCount = 0;
};

/// The layout that glMultiDrawElementsIndirect reads.
struct DrawCommand {
    std::uint32_t count = 0, instanceCount = 1, firstIndex = 0;
    std::int32_t baseVertex = 0;
    std::uint32_t baseInstance = 0;  ///< The first draw, whose record the vertex array feeds to shaders.
};

/// Triangles of an instance that have one material.
struct DrawnPart {
    IndexRange indices;
    std::uint32_t material = 0;  ///< Index into `Scene::materials`; their number: none.
};

/// A triangle of an instance's mesh that others hide; counted from the first of the mesh.
struct HiddenTriangle {
    std::uint32_t instance, triangle;

    auto operator<=>(const HiddenTriangle&) const = default;
};

/// What culling has left for one view: the draw commands, and the cages among the instances. A selection is
/// filled by `GpuScene::State::cull` as often as needed and keeps its storage. It holds for the scene as of
/// that call: cull again after an update of the scene.
class DrawSelection {
  public:
    DrawSelection() = default;

    /// Sorted by key, so that batches that emit come last.
    std::span<const DrawBatch> batches() const { return batches_; }
    std::span<const DrawCommand> commands(const DrawBatch& batch) const {
        return std::span(commands_).subspan(batch.firstCommand, batch.commandCount);
    }
    /// Does any draw have more lobes than metallic and roughness describe?
    bool isExtended() const;
    bool emits(SurfaceSet set = SurfaceSet::opaque) const;
    /// Instances with transparent surfaces. An instance may be listed more than once.
    std::span<const std::uint32_t> transparentInstances() const { return transparentInstances_; }
    bool hasTransparent() const { return !transparentInstances_.empty(); }
    /// Of all draws together.
    Backdrop backdrop() const;
    /// Instances that show cages.
    std::span<const std::uint32_t> cageInstances() const { return cageInstances_; }
    /// Those of the instances left which a triangle filter need not draw, in order.
    std::span<const HiddenTriangle> hiddenTriangles() const { return hiddenTriangles_; }
    std::size_t commandCount() const { return commands_.size(); }
    /// Draws of one instance each.
    std::size_t drawCount() const;

    /// Binds the commands for `draw`.
    void bind() const { glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commandBuffer_.name()); }
    /// Issues the commands of a batch. The selection is bound.
    static void draw(const DrawBatch& batch);

  private:
    friend class DrawList;
    friend struct GpuScene::State;

    /// Commands of one distance class keep their order; half an octave each.
    using DistanceClass = std::uint16_t;
    static constexpr DistanceClass hidden = 0;

    // Scratch of the culling.
    std::vector<DistanceClass> distances_;  ///< Of an instance's farthest point, or `hidden`.
    std::vector<std::uint32_t> occluded_;   ///< Instances in view that others hide, in order.
    std::vector<std::pair<DistanceClass, DrawCommand>> ordered_;

    std::vector<DrawCommand> commands_;
    std::vector<DrawBatch> batches_;
    std::vector<HiddenTriangle> hiddenTriangles_;
    std::vector<std::uint32_t> meshInstances_, cageInstances_, transparentInstances_;
    gl::Buffer commandBuffer_{"draw commands", gl::BufferUsage::dynamic};
};

/// A draw for every submesh of every instance, and for every part of a cage that has one material, grouped by
/// pipeline key. The record of a draw stays at its place until instances are added or removed: else only the
/// grouping changes.
class DrawList {
  public:
    /// `materials` is the number of materials: it stays the index of the default material.
    explicit DrawList(std::size_t materials)
        : noMaterial_(static_cast<std::uint32_t>(materials)),
          drawsOfMaterial_(materials + 1),
          materialKeys_(materials + 1) {}

    /// The index that surfaces without a material have.
    std::uint32_t noMaterial() const { return noMaterial_; }

    /// Adds all submeshes of mesh `mesh`. `place` is where its indices and vertices are within `geometry`.
    /// `materials` are those of the scene. The instance has no draws. Throws `Error` (limit) when a texture
    /// does not fit the device; nothing is changed then.
    void addMesh(std::uint32_t instance, const DrawGeometry& geometry, std::uint32_t mesh,
                 const MeshParts& parts, const MeshPlace& place, std::span<const Material> materials,
                 GpuImages& images);
    /// Would `prepare` load any?
    bool isPrepared(const MeshParts& parts) const;
    /// Loads the textures of a mesh's materials, so that `addMesh` does not throw. Throws as it does.
    void prepare(const MeshParts& parts, std::span<const Material> materials, GpuImages& images);
    /// The same of the materials of a cage.
    void prepare(std::span<const std::uint32_t> parts, std::span<const Material> materials,
                 GpuImages& images);
    bool isPrepared(std::span<const std::uint32_t> parts) const;
    /// To be called when a material is removed, which nothing has.
    void removeMaterial(std::uint32_t index) { materialKeys_[index] = {}; }
    /// Removes the draws of an instance.
    void remove(std::uint32_t instance);
    /// Makes room for materials up to `count`.
    void growMaterials(std::size_t count) {
        if (count > materialKeys_.size()) materialKeys_.resize(count);
        if (count > drawsOfMaterial_.size()) drawsOfMaterial_.resize(count);
    }
    /// Adds a cage that shows a limit surface and whose part i has material `parts[i]` (the number of
    /// materials: none). Nothing of it is drawn before `setRanges`.
    void addCage(std::uint32_t instance, std::uint32_t surface, std::span<const std::uint32_t> parts,
                 std::span<const Material> materials, GpuImages& images);
    /// Have instances been added or removed since the last `placeRecords`?
    bool isUnplaced() const { return unplaced_; }
    /// Uploads the records: draws of the same indices and material one after the other, so that one command
    /// draws them. `instances` are those with draws, in the order in which a new scene has them. To be called
    /// before `group`.
    void placeRecords(std::span<const std::uint32_t> instances);

    void setWinding(std::uint32_t instance, Winding winding);
    /// Brings the draws of all materials to it. Throws as `setMaterial` does.
    void setOcclusionTextures(OcclusionTextures textures, std::span<const Material> materials,
                              GpuImages& images);
    /// Brings the draws of material `index` to its new pipeline state. Throws `Error` (limit) when a texture
    /// does not fit the device; nothing is changed then.
    void setMaterial(std::uint32_t index, const Material& material, GpuImages& images);
    /// Lets a cage's instance show another limit surface of equal parts. Nothing of it is drawn before
    /// `setRanges`.
    void setSurface(std::uint32_t instance, std::uint32_t surface);
    /// Sets the indices of the parts of a cage's instance.
    void setRanges(std::uint32_t instance, std::span<const IndexRange> ranges);

    /// What an instance draws.
    DrawGeometry geometryOf(std::uint32_t instance) const;
    /// Its triangles.
    std::vector<DrawnPart> partsOf(std::uint32_t instance) const;
    /// Calls `visit(key, material, indices)` for each of its draws.
    template <typename Visit>
    void visitDraws(std::uint32_t instance, const Visit& visit) const {
        for (const Draw& draw : drawsOf(instance))
            visit(keyOf(draw), draw.material, IndexRange{draw.command.firstIndex, draw.command.count});
    }

    /// The textures of the further lobes of draws with a key.
    const LobeTextures& lobeTextures(const PipelineKey& key) const { return lobeSets_[key.lobeTextures]; }

    /// The instance that a record is of: those of a command are its `baseInstance` and the ones that follow.
    std::uint32_t instanceOfRecord(std::uint32_t record) const {
        return draws_[drawOfRecord_[record]].instance;
    }
    /// The place of its draw among all, in the order of instances.
    std::uint32_t numberOfRecord(std::uint32_t record) const { return numberOfRecord_[record]; }

    /// Groups the draws whose keys have changed since the last call; to be called before `cull`. Returns how
    /// many those are.
    std::size_t group();

    /// Whether any draw is transparent, in view or not; as of the last `group`.
    bool hasTransparent() const;

    /// Writes and uploads the commands of the visible instances: one for all consecutive draws of the same
    /// indices. Opaque ones of a key are in order of the distance of the farthest point of what they draw, so
    /// that floors and walls around the camera are tested against the depth of what stands before them. Those
    /// that others hide have no command; else all is as if they were seen.
    void cull(DrawSelection& selection) const;

    /// The records: uvec3 a draw, see DRAW_ATTRIBUTE.
    const gl::Buffer& records() const { return recordBuffer_; }

  private:
    struct Group {
        std::vector<std::uint32_t> draws;  ///< By their records.
        std::vector<std::uint32_t> added;  ///< By the `group` in progress.
        bool changed = false;
    };
    using Groups = std::map<PipelineKey, Group>;
    struct Draw {
        DrawCommand command;
        std::uint32_t instance, material, part = 0;
        /// Those of different meshes do not follow each other by where these lie: a new scene has another
        /// order there.
        std::uint32_t meshOrder = 0, indexInMesh = 0;
        DrawGeometry geometry;
        bool hasColors = false;  ///< The mesh has vertex colours.
        Topology topology = Topology::triangles;
        bool unlit = false;
        bool mirrored = false;
        bool pending = false;  ///< Waits for `group`.
        bool removed = false;
        bool placed = false;  ///< Has a record.
        Group* group = nullptr;
    };
    /// What of a draw's vertices its key depends on, and the index of its `MaterialKeys`.
    struct VertexKind {
        bool hasColors, unlit;
        std::size_t index() const { return (hasColors ? 1u : 0u) + (unlit ? 2u : 0u); }
    };
    static constexpr VertexKind vertexKinds[] = {{false, false}, {true, false}, {false, true}, {true, true}};
    /// The keys of a material's draws, but for winding, topology and geometry. None where there is no such
    /// draw.
    using MaterialKeys = std::array<std::optional<PipelineKey>, std::size(vertexKinds)>;

    struct DrawSpan {
        std::uint32_t first = 0, count = 0;
    };

    void addCommand(DrawSelection& selection, const DrawCommand& command) const;
    void requireKey(std::uint32_t material, const VertexKind& vertices, std::span<const Material> materials,
                    GpuImages& images);
    /// Makes room for the draws of an instance that has none.
    std::span<Draw> takeDraws(std::uint32_t instance, std::size_t count);
    void finishDraw(Draw& draw);
    void forgetOfMaterial(std::uint32_t material);
    struct Place {
        std::uint32_t draw, number;
    };
    std::vector<Place> sortedPlaces(std::span<const std::uint32_t> instances);
    void sortGroups();
    PipelineKey materialKey(const Material& material, const VertexKind& vertices, GpuImages& images);
    std::uint32_t lobeSet(const LobeTextures& textures);
    std::span<Draw> drawsOf(std::uint32_t instance);
    std::span<const Draw> drawsOf(std::uint32_t instance) const;
    void mark(Draw& draw);
    PipelineKey keyOf(const Draw& draw) const;

    std::uint32_t noMaterial_;
    std::vector<Draw> draws_;
    std::vector<DrawSpan> spans_;                                    ///< One an instance.
    std::map<std::uint32_t, std::vector<std::uint32_t>> freeDraws_;  ///< First ones of unused runs, by count.
    struct MaterialDraws {
        std::vector<std::uint32_t> draws;  ///< Some of them have been removed.
        std::size_t removed = 0;           ///< About how many.
    };
    std::vector<MaterialDraws> drawsOfMaterial_;
    OcclusionTextures occlusionTextures_ = OcclusionTextures::ignored;
    std::vector<MaterialKeys> materialKeys_;  ///< One a material, and one for draws without.
    std::vector<LobeTextures> lobeSets_;
    std::map<LobeTextures, std::uint32_t> lobeSetOf_;
    Groups groups_;
    std::vector<std::uint32_t> pending_;
    bool unplaced_ = true, hasRemoved_ = false;
    std::vector<std::uint32_t> numberOfRecord_, drawOfRecord_;
    gl::Buffer recordBuffer_{"draw records", gl::BufferUsage::dynamic};
};

/// Can any draw of the scene come to need more than positions and normals? One may without asking for it now
/// where there are images and meshes that can read them: `GpuScene::setMaterial` may bring the two together.
GpuMeshes::Detail detailOf(const Scene& scene);

}  // namespace candela
