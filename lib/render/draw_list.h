#pragma once

#include "gl/buffer.h"
#include "render/gpu_images.h"
#include "render/gpu_meshes.h"

#include <candela/scene.h>

#include <array>
#include <compare>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace candela {

/// What the state of GL depends on: draws that agree in it go out together.
struct DrawState {
    enum class Program { plain, textured };

    bool emissive = false;  ///< Writes radiance; drawn after all that does not (see `GeometryPass`).
    Program program = Program::plain;
    bool doubleSided = false;
    bool mirrored = false;  ///< The instance's matrix turns the winding round.
    std::array<SampledTexture, 4>
        textures{};  ///< Base colour, metallic-roughness, normal, emission; unset for plain.

    auto operator<=>(const DrawState&) const = default;
};

/// The draws of one state among the commands of a frame.
struct DrawBatch {
    DrawState state;
    std::uint32_t firstCommand = 0, commandCount = 0;
};

/// A node that shows a mesh.
struct Instance {
    std::uint32_t node = 0, mesh = 0;
};

/// Every submesh of every instance, sorted by state, and the commands of those that are in view.
class DrawList {
  public:
    DrawList(const Scene& scene, std::span<const Instance> instances, const GpuMeshes& meshes,
             GpuImages& images);

    /// Says of each instance whether its matrix turns the winding round. To be called before the first
    /// `select`, and whenever it changes.
    void setMirrored(const std::vector<bool>& mirrored);

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
        DrawState state;
        std::uint32_t instance, material;
        Command command;
    };

    std::vector<Draw> draws_;
    std::vector<Command> commands_;
    std::vector<DrawBatch> batches_;
    gl::Buffer drawBuffer_, commandBuffer_;
};

/// Does any draw of the scene need more than positions and normals?
GpuMeshes::Detail detailOf(const Scene& scene);

}  // namespace candela
