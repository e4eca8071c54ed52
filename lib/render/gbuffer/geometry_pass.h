#pragma once

#include "gl/program.h"
#include "render/gbuffer/gbuffer_targets.h"
#include "render/gpu_scene/gpu_scene_state.h"

#include <functional>
#include <map>
#include <optional>
#include <tuple>

namespace candela {

struct DrawRuns;

/// Whether surfaces of a layer lie at the depth of others, so that their numbers tell which of them it holds.
enum class DepthTies { none, numbered };

/// Draws surfaces of a host.
struct HostSurfaceDraws {
    /// Their depth, over all pixels. Empty where they have none.
    std::function<void(GLuint framebuffer)> depth;
    /// Their radiance, where the targets still hold their depth after all surfaces have been drawn: only
    /// emissive ones write radiance, so that the others would leave what lies behind them.
    std::function<void(const GBufferTargets& targets)> radiance;
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
        /// The draws without triangles that leave no trace in the picture; null: all are drawn.
        const TriangleFilter* filter = nullptr;
        /// Of those draws or of `filter`'s, those that are drawn; null: all.
        const DrawRuns* runs = nullptr;
        const HostSurfaceDraws* host = nullptr;  ///< Of `render`; null: there are none.
    };
    void render(const Inputs& inputs);
    /// Draws the surfaces of a layer: those at the depths that the targets hold, whose words are cleared.
    void renderLayer(const Inputs& inputs, DepthTies ties);
    /// Draws all transparent fragments in front of what the targets hold, for the images that `FragmentLists`
    /// has bound. Writes nothing else.
    void recordFragments(const Inputs& inputs);
    /// The same for the layers of each draw (`LayerDraws`), from the number `firstNumber` on.
    void findLayers(const Inputs& inputs, std::uint32_t firstNumber);
    /// The same of those at the depths that the targets hold, for their numbers in layer `index`.
    void numberSurfaces(const Inputs& inputs, std::uint32_t index);

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

    enum class FragmentUse { record, findLayers, number };

    Programs& programsFor(const GBufferTargets& targets);
    const gl::Program& fragmentProgram(const PipelineKey& key, FragmentUse use);
    void drawSurfaces(const Inputs& inputs, DepthTies ties);
    /// `select` gets the key of each batch and makes its state current.
    template <typename Select>
    static void drawBatches(const Inputs& inputs, const Select& select);
    template <typename Select>
    static void drawRuns(const Inputs& inputs, const Select& select);
    /// `value` is the program's uniform.
    void drawFragments(const Inputs& inputs, FragmentUse use, GLenum depthFunction, std::uint32_t value);
    static void bindTextures(const PipelineKey& key);
    static void bindLobeTextures(const GpuScene::State& scene, const PipelineKey& key);
    static void cull(const PipelineKey& key);
    static const gl::Program& select(const Inputs& inputs, const PipelineKey& key, Programs& programs);

    // Compiled when they are first needed.
    std::map<GBufferParts, Programs> programs_;
    /// By topology and further sets of texture coordinates.
    std::map<std::tuple<Topology, std::uint32_t, FragmentUse>, gl::Program> fragmentPrograms_;
};

}  // namespace candela
