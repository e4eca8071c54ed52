#pragma once

#include "gl/buffer.h"
#include "render/culling/filter_view.h"
#include "render/culling/mesh_clusters.h"
#include "render/gpu_scene/draw_list.h"

#include <candela/gpu_scene.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// The draws of a selection without the triangles that leave no trace in a picture: those that face away,
/// leave the frame, or cover no pixel's centre (shaders/shared/triangle_filter.h). What is drawn is the same
/// bit for bit. First whole clusters are dropped, then triangles. Source: Wihlidal, "Optimizing the graphics
/// pipeline with compute", GDC 2016.
class TriangleFilter {
  public:
    /// Draws of one batch that read the same indices.
    struct Run {
        PipelineKey key;
        bool filtered;  ///< Drawn from `vertexArray`, else from that of the scene.
        std::uint32_t firstCommand, commandCount;
    };

    TriangleFilter(const TriangleFilter&) = delete;
    TriangleFilter& operator=(const TriangleFilter&) = delete;
    virtual ~TriangleFilter() = default;

    /// To be called when the buffers of the meshes are other ones.
    void describeMeshes();

    /// Fills the runs for the selection as `frame` sees it. Small meshes, what memory is not taken for
    /// and vertices that are not those of the scene's meshes stay as they are. Until the next call.
    virtual void filter(const DrawSelection& selection, const layout::FrameUniforms& frame) = 0;

    std::span<const Run> runs() const { return runs_; }
    /// Binds the commands for `draw`.
    void bind() const { glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commandBuffer_.name()); }
    /// Those of filtered opaque draws may be known to the device alone.
    std::span<const DrawCommand> commands(const Run& run) const {
        return std::span(commands_).subspan(run.firstCommand, run.commandCount);
    }
    static void draw(const Run& run);
    GLuint vertexArray() const { return vertexArray_.name(); }

    /// Triangles of the draws that the last call has filtered.
    struct Counts {
        std::size_t asked = 0;
        std::size_t inKeptClusters = 0;
        std::size_t kept = 0;
    };
    virtual Counts counts() const = 0;

  protected:
    /// `scene` outlives the filter.
    explicit TriangleFilter(const GpuScene::State& scene);

    /// A draw of one instance.
    struct Draw {
        DrawCommand source;
        ClusterRange clusters;
        std::uint32_t instance;
        float facing;         ///< As in `FilterView`.
        std::size_t command;  ///< What stands for it among the commands.
    };
    /// Which draws a form of the filter takes.
    struct Scope {
        std::uint32_t minIndices;  ///< Of a draw.
        std::size_t maxIndices;    ///< Of all together.
        SurfaceSet surfaces;
    };
    /// Fills runs, commands and draws; those are filtered then.
    void plan(const DrawSelection& selection, const Scope& scope);
    layout::FilterView viewOf(const Draw& draw, const FilterCamera& camera) const;

    const GpuScene::State& scene_;
    std::vector<Draw> draws_;
    std::vector<DrawCommand> commands_;
    gl::Buffer commandBuffer_{"filtered draw commands", gl::BufferUsage::dynamic};
    gl::Buffer indexBuffer_{"filtered indices", gl::BufferUsage::dynamic};
    gl::VertexArray vertexArray_{"filtered meshes"};

  private:
    std::optional<ClusterRange> clustersOf(const PipelineKey& key, const DrawCommand& command,
                                           const Scope& scope) const;
    void addCommand(const PipelineKey& key, bool filtered, const DrawCommand& command);

    std::size_t indexCount_ = 0;  ///< Of the draws.
    std::vector<Run> runs_;
};

/// Runs of a filter's draws, or of a selection's, with other commands.
struct DrawRuns {
    std::span<const TriangleFilter::Run> runs;
    GLuint commandBuffer;
};

}  // namespace candela
