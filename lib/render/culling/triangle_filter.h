#pragma once

#include "gl/buffer.h"
#include "render/culling/triangle_filter_kernel.h"
#include "render/gpu_scene/draw_list.h"
#include "render/layout.h"

#include <candela/gpu_scene.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// The draws of a selection without the triangles that leave no trace in a picture: those that face away,
/// leave the frame, or cover no pixel's centre. What is drawn is the same bit for bit. For software devices,
/// whose rasteriser takes all triangles through one thread; the filter runs on all. Source: Wihlidal,
/// "Optimizing the graphics pipeline with compute", GDC 2016.
class TriangleFilter {
  public:
    /// Draws of one batch that read the same indices.
    struct Run {
        PipelineKey key;
        bool filtered;  ///< Drawn from `vertexArray`, else from that of the scene.
        std::uint32_t firstCommand, commandCount;
    };

    /// `scene` outlives the filter. Its meshes can be read by the CPU (`GpuMeshes::Access`).
    explicit TriangleFilter(const GpuScene::State& scene,
                            const TriangleFilterKernel& kernel = *triangleFilterKernels().front());

    /// Fills the runs for the selection as `frame` sees it. Small meshes, what memory is not taken for
    /// and vertices that are not those of the scene's meshes stay as they are. Until the next call.
    void filter(const DrawSelection& selection, const layout::FrameUniforms& frame);

    std::span<const Run> runs() const { return runs_; }
    /// Binds the commands for `draw`.
    void bind() const { glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commandBuffer_.name()); }
    std::span<const DrawCommand> commands(const Run& run) const {
        return std::span(commands_).subspan(run.firstCommand, run.commandCount);
    }
    static void draw(const Run& run);
    GLuint vertexArray() const { return vertexArray_.name(); }

    /// Of the last call.
    struct Counts {
        std::size_t asked = 0, kept = 0;  ///< Triangles of draws that were filtered.
    };
    Counts counts() const;

  private:
    /// Vertices of an instance in view, for one thread.
    struct VertexShare {
        std::uint32_t instance, first, end;
    };
    /// Triangles of a draw, for one thread.
    struct TriangleShare {
        DrawCommand source;  ///< Of one instance; its indices are those of the share.
        std::uint32_t instance;
        float facing;
        std::size_t out;  ///< First index written.
        std::uint32_t kept = 0;
    };

    bool isFiltered(const DrawBatch& batch, const DrawCommand& command) const;
    bool hasRoomFor(const DrawCommand& command) const;
    void plan(const DrawSelection& selection);
    void planDraw(const PipelineKey& key, const DrawCommand& command);
    void addCommand(const PipelineKey& key, bool filtered, const DrawCommand& command);
    void transform(const layout::FrameUniforms& frame);
    void filterShares(const layout::FrameUniforms& frame);
    void writeCommands();
    ScreenColumns columnsOf(std::uint32_t instance);

    const GpuScene::State& scene_;
    const TriangleFilterKernel& kernel_;
    std::vector<VertexShare> vertexShares_;
    std::vector<TriangleShare> triangleShares_;
    std::vector<std::size_t>
        firstVertex_;  ///< Of each instance in the columns; `none` where it is not there.
    std::vector<std::uint32_t> instances_;  ///< Those that are.
    std::size_t vertexCount_ = 0, indexCount_ = 0;
    std::vector<float> columns_;
    /// Commands as planned: those that are filtered stand for a share, by `firstIndex`.
    std::vector<DrawCommand> commands_;
    std::vector<Run> runs_;
    gl::Buffer commandBuffer_{"filtered draw commands", gl::BufferUsage::dynamic};
    gl::Buffer indexBuffer_{"filtered indices", gl::BufferUsage::dynamic};
    gl::VertexArray vertexArray_{"filtered meshes"};
};

/// Runs of a filter's draws, or of a selection's, with other commands.
struct DrawRuns {
    std::span<const TriangleFilter::Run> runs;
    GLuint commandBuffer;
};

}  // namespace candela
