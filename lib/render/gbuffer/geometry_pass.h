#pragma once

#include "gl/program.h"
#include "render/gbuffer/gbuffer_targets.h"
#include "render/gpu_scene/gpu_scene_state.h"

#include <map>
#include <optional>
#include <tuple>

namespace candela {

/// Between which depths the fragments of a layer lie.
struct LayerDepths {
    const gl::Texture& opaque;  ///< Of the opaque surfaces.
    const gl::Texture* before;  ///< Of the layer in front; null for the first layer.
};

/// Draws the surfaces in view into the G-buffer and their emission into the radiance target.
class GeometryPass {
  public:
    GeometryPass();

    struct Inputs {
        const GpuScene::State& scene;
        const DrawSelection& draws;  ///< Of the view.
        const GBufferTargets& targets;
        LoadOp radianceLoad;  ///< Where a draw emits, the target is cleared in any case.
        SurfaceSet surfaces = SurfaceSet::opaque;
        /// Of transparent surfaces; null: targets without the part `layer`.
        const LayerDepths* layer = nullptr;
        /// The draws without triangles that leave no trace in the picture; null: all are drawn.
        const TriangleFilter* filter = nullptr;
    };
    void render(const Inputs& inputs);
    /// Draws the fragments that layers may hold, all of them, and writes nothing: for a query that counts
    /// them. The inputs are those of the first layer.
    void drawFragments(const Inputs& inputs);

  private:
    /// With the fragment outputs of one set of parts of the G-buffer.
    struct Programs {
        explicit Programs(const GBufferParts& parts);
        const gl::Program& of(const PipelineKey& key);
        bool hasLobes() const { return extended_.has_value(); }

      private:
        /// That of a key's program, topology and light.
        static gl::Program make(const PipelineKey& key, const GBufferParts& parts);

        gl::Program plain_, textured_;
        std::optional<gl::Program> extended_;  ///< Where the parts have lobes; else these are not written.
        /// Of lines and points, and of materials that read further sets of texture coordinates. Compiled when
        /// they are first needed.
        std::map<std::tuple<Topology, PipelineKey::Program, bool, std::uint32_t>, gl::Program> special_;
        GBufferParts parts_;
    };

    Programs& programsFor(const GBufferTargets& targets);
    void drawBatches(const Inputs& inputs);
    static void bindTextures(const PipelineKey& key);
    static void bindLobeTextures(const GpuScene::State& scene, const PipelineKey& key);
    static void select(const Inputs& inputs, const PipelineKey& key, Programs& programs);

    std::map<GBufferParts, Programs> programs_;  ///< Compiled when they are first needed.
};

}  // namespace candela
