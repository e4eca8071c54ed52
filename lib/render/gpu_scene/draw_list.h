#pragma once

#include "gl/buffer.h"
#include "render/gpu_scene/gpu_images.h"
#include "render/gpu_scene/gpu_meshes.h"
#include "render/gpu_scene/index_range.h"

#include <candela/scene.h>

#include <array>
#include <compare>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace candela {

/// What the state of GL depends on: draws that agree in it go out together.
struct PipelineKey {
    enum class Program { plain, textured };

    bool emissive = false;  ///< Writes radiance; drawn after all that does not (see `GeometryPass`).
    Program program = Program::plain;
    bool doubleSided = false;
    bool mirrored = false;  ///< The instance's matrix turns the winding round.
    std::array<SampledTexture, 4>
        textures{};              ///< Base colour, metallic-roughness, normal, emission; unset for plain.
    std::uint32_t geometry = 0;  ///< 0: the meshes; 1 + i: shape i of the cages.

    auto operator<=>(const PipelineKey&) const = default;
};

/// The draws of one state among the commands of a frame.
struct DrawBatch {
    PipelineKey state;
    std::uint32_t firstCommand = 0, commandCount = 0;
};

/// Every submesh of every instance, sorted by state, and the commands of those that are in view. A surface is
/// a submesh, or the part of a cage that wears one material. Between changes and the next `select`,
/// `batches` are those of the last.
class DrawList {
  public:
    DrawList() : drawBuffer_("draws"), commandBuffer_("draw commands") {}

    /// Adds all submeshes of a mesh. `materials` are those of the scene.
    void addMesh(std::uint32_t instance, const Mesh& mesh, const MeshPlace& place,
                 std::span<const Material> materials, GpuImages& images);
    /// Adds a cage whose part i wears material `parts[i]` (the number of materials: none), of `geometry` as
    /// `PipelineKey` counts it. Nothing of it is drawn before `setRanges`.
    void addCage(std::uint32_t instance, std::uint32_t geometry, std::span<const std::uint32_t> parts,
                 std::span<const Material> materials, GpuImages& images);

    /// Says of each instance whether its matrix turns the winding round. To be called before the first
    /// `select`, and whenever it changes.
    void setMirrored(const std::vector<bool>& mirrored);
    /// Brings the draws that wear material `index` to how it is drawn now.
    void setMaterial(std::uint32_t index, const Material& material, GpuImages& images);
    /// Lets a cage's instance show another geometry of equal parts. Nothing of it is drawn before
    /// `setRanges`.
    void setGeometry(std::uint32_t instance, std::uint32_t geometry);
    /// Says which indices the parts of a cage's geometry are.
    void setRanges(std::uint32_t geometry, std::span<const IndexRange> ranges);

    /// Writes and uploads the commands of the instances that `visible` accepts.
    void select(const std::function<bool(std::uint32_t instance)>& visible);

    std::span<const DrawBatch> batches() const { return batches_; }
    /// Is any selected draw emissive?
    bool emits() const { return !batches_.empty() && batches_.back().state.emissive; }
    const gl::Buffer& commands() const { return commandBuffer_; }
    const gl::Buffer& draws() const { return drawBuffer_; }

  private:
    /// The layout that glMultiDrawElementsIndirect reads.
    struct Command {
        std::uint32_t count, instanceCount, firstIndex;
        std::int32_t baseVertex;
        std::uint32_t baseInstance;
    };
    struct Draw {
        PipelineKey state;
        std::uint32_t order;  ///< In which draws of one state go out.
        std::uint32_t instance, material, part;
        bool hasColors;  ///< The mesh has vertex colours.
        Command command;
    };

    void add(Draw draw, std::span<const Material> materials, GpuImages& images);
    void sort();

    std::vector<Draw> draws_;
    bool sorted_ = false;
    std::vector<Command> commands_;
    std::vector<DrawBatch> batches_;
    gl::Buffer drawBuffer_, commandBuffer_;
};

/// Can any draw of the scene come to need more than positions and normals? One may without asking for it now
/// where there are images and meshes that could wear them: `GpuScene::setMaterial` may bring the two
/// together.
GpuMeshes::Detail detailOf(const Scene& scene);

}  // namespace candela
