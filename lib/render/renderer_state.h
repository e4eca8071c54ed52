#pragma once

#include "gl/context_binding.h"
#include "gl/pass_timer.h"
#include "render/accumulation/sample_sums.h"
#include "render/debug/debug_view_pass.h"
#include "render/debug/instance_pass.h"
#include "render/debug/overlay_pass.h"
#include "render/display/display_pass.h"
#include "render/display/display_target.h"
#include "render/display/memory_display.h"
#include "render/environment/environment_pass.h"
#include "render/frame_uniforms.h"
#include "render/frustum.h"
#include "render/gbuffer/gbuffer_copy.h"
#include "render/gbuffer/geometry_pass.h"
#include "render/gbuffer/target_memory.h"
#include "render/gpu_scene/gpu_scene_state.h"
#include "render/host/depth_conversion.h"
#include "render/layers/fragment_lists.h"
#include "render/layers/layer_draws.h"
#include "render/layers/layer_pass.h"
#include "render/layout.h"
#include "render/lighting/lighting.h"
#include "render/occlusion/environment_occlusion.h"
#include "render/occlusion/environment_occlusion_pass.h"

#include <candela/renderer.h>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace candela {

inline bool hasLines(const Overlays& overlays) {
    return overlays.wireframe || overlays.cage;
}

/// What a frame traces rays for.
struct TracedRays {
    bool shadows;      ///< Of lights.
    bool environment;  ///< How much of the environment pixels see.
};

/// How much of the environment each pixel sees, as `LightingInputs` has it. All of it where neither is there.
struct EnvironmentVisibility {
    const gl::Texture* texture = nullptr;
    const std::uint8_t* bytes = nullptr;
};

/// A G-buffer that has been drawn, with what lighting reads besides.
struct ShadedSurfaces {
    const GBufferTargets* targets = nullptr;
    GBufferCopy copy;  ///< Of `targets`.
    EnvironmentVisibility visibility;
    bool emits = false;  ///< The radiance target holds emission.

    void reset(const GBufferTargets& drawn) { reset(drawn, {0, 0, drawn.width, drawn.height}); }
    /// `drawn` has no surfaces outside of `rectangle`.
    void reset(const GBufferTargets& drawn, const gl::PixelRectangle& rectangle) {
        targets = &drawn;
        copy.reset(drawn, rectangle);
        visibility = {};
        emits = false;
    }
};

/// The frame that a renderer's targets hold.
struct DrawnFrame {
    FrameSettings settings;
    CameraView view;  ///< Of the whole picture. Orthographic ones have a far plane.
    std::optional<float> requestedFarPlane;
    FramePixels pixels;
    Technique technique;  ///< Never `automatic`.
    TracedRays traced;
    layout::FrameUniforms uniforms;
    Frustum frustum;
    glm::dvec3 origin;            ///< `Scene::origin`.
    bool hasTransparent = false;  ///< Its targets lack transparent surfaces, which are in layers.
};

/// Consecutive samples of a picture.
struct SampleSpan {
    std::uint32_t first, end;
};
using SampleViews = std::function<CameraView(std::uint32_t sample)>;

/// The passes of a renderer and the targets that they draw into. A `Renderer` and its `Frame`s share it.
struct Renderer::State {
    explicit State(const Context& context);

    /// Draws a frame and counts it in `frameNumber`.
    void render(GpuScene::State& scene, const CameraView& requested, const FrameSettings& settings);

    /// Whether the samples after the last frame, of the same scene and settings, can be drawn by
    /// `drawSamples`: surfaces rest, and memory of the CPU is all that lighting reads.
    bool canOverlapSamples(const GpuScene::State& scene) const;
    /// Draws more samples from the views of `viewOf` and adds them to `sums`, which are in memory and not
    /// empty. A sample is drawn while the one before is lit, on another thread. The last one is the
    /// renderer's frame then.
    void drawSamples(GpuScene::State& scene, const SampleSpan& samples, const SampleViews& viewOf,
                     SampleSums& sums);

    // What frames ask for, after a check that `frame` is theirs.
    LightingInputs lightingInputs(const GpuScene::State& scene, ShadedSurfaces& shaded);
    void bindFrame();
    void drawGeometry(const GpuScene::State& scene, const GBufferTargets& into, SurfaceSet set,
                      LoadOp radianceLoad);
    /// The frame's surfaces with the transparent ones as masks, drawn again: what AOVs show of a frame that
    /// has transparent surfaces.
    ShadedSurfaces& drawMasked(const GpuScene::State& scene);
    /// Draws the geometry again into targets whose radiance is the emission alone: that of the frame's own
    /// targets is lit by now.
    const GBufferTargets& drawEmission(const GpuScene::State& scene);
    /// Draws parts of the environment's light alone into targets of its own.
    const GBufferTargets& drawEnvironment(const GpuScene::State& scene, ShadedSurfaces& shaded,
                                          EnvironmentPass::Parts parts);
    /// The AOV `shadowed_count`, rows from the bottom.
    std::vector<float> countShadowed(GpuScene::State& scene, const GBufferTargets& shown);
    /// The AOV `ambient_occlusion`, rows from the bottom. The library has shadows.
    std::vector<float> traceAmbientOcclusion(GpuScene::State& scene, const GBufferTargets& shown);
    /// Emission at a pixel, y from the bottom.
    glm::vec3 emissionAt(const GpuScene::State& scene, int x, int y);
    /// Shows the frame and its overlays in a complete framebuffer.
    void displayFrame(const DisplayTransform& transform, const FrameTarget& target);
    /// The same as 8-bit RGBA, rows from the top.
    std::vector<std::uint8_t> displayPicture(const DisplayTransform& transform);
    /// The frame, shown in a target of its own.
    const DisplayTarget& shownTarget(const DisplayTransform& transform);

    /// What the pixels of a rectangle show, rows from the bottom: drawn again.
    std::vector<SurfaceId> surfaceIds(const GpuScene::State& scene, const gl::PixelRectangle& rectangle);
    /// Of the frame's surfaces; see `MotionInputs`.
    std::vector<float> previousPositions(GpuScene::State& scene, std::span<const SurfaceId> ids);
    /// Writes depth as a host has it.
    void writeDepth(const FrameTarget& target, const DepthConvention& convention);
    /// The lit frame where a technique has left it in memory; else, and in a debug view, without radiance.
    MemoryPicture pictureInMemory() const {
        return {targets->memory.radiance,
                targets->width,
                targets->height,
                {frame->pixels.left, frame->pixels.bottom}};
    }

    std::shared_ptr<gl::ContextBinding> binding;
    gl::PassTimer timer;
    GeometryPass geometry;
    Lighting lighting;
    EnvironmentPass environment;
    DisplayPass display;
    MemoryDisplay memoryDisplay;
    gl::Buffer frameBuffer;
    InstancePass instances;
    DrawSelection draws;  ///< Of the frame's view.
    std::uint64_t frameNumber = 0;
    std::optional<DrawnFrame> frame;
    ShadowCounts shadowCounts;  ///< Of the last frame.
    /// Of all samples that were drawn together with the last frame; empty where it was drawn alone.
    std::vector<PassTime> samplePasses;
    ShadedSurfaces frameSurfaces;  ///< Of the frame's targets.
    ShadedSurfaces layerSurfaces;  ///< Of the layer drawn last.
    ShadedSurfaces masked;         ///< Of `drawMasked`; without targets until the frame needs it.
    LayerCounts layerCounts;       ///< Of the frame.
    gl::PassTimer layerTimer;      ///< Of the passes that light a layer; `timer` has the sum.
    EnvironmentOcclusion environmentOcclusion;
    // Created when they are first needed.
    std::optional<DebugViewPass> debugView;
    std::optional<EnvironmentOcclusionPass> environmentOcclusionPass;
    std::optional<OverlayPass> overlays;
    std::optional<LayerPass> layers;
    std::optional<FragmentLists> fragmentLists;
    std::optional<LayerDraws> layerDraws;
    TargetMemory targetMemory;
    GBufferTargets* targets = nullptr;                  ///< Of the frame: one of `targetSets`.
    std::map<GBufferParts, GBufferTargets> targetSets;  ///< Of the frame's size.
    std::optional<GBufferTargets> emissionTargets;      ///< Where `drawEmission` and `drawEnvironment` draw.
    std::optional<GBufferTargets> maskedTargets;        ///< Of `drawMasked`.
    std::optional<GBufferTargets> otherSampleTargets;   ///< Of `sampleTargets`.
    std::optional<DisplayTarget> displayTarget;
    std::optional<DepthConversion> depthConversion;
    HostSurfaceDraws hostDraws;  ///< Of the frame; see lib/render/host_passes.cpp.
    bool hasHostSurfaces() const { return hostDraws.depth || hostDraws.radiance; }

  private:
    /// The frame's view as the host has asked for it.
    CameraView requestedView() const;
    DepthConversion& conversion();
    /// Prepares for the host's surfaces of the frame's settings. Throws as `HostSurfaces` states.
    void useHostSurfaces();
    void runHook(const std::function<void(const FrameStage&)>& hook, const gl::Framebuffer& target);
    void runAfterGeometry();
    void runBeforeDisplay();
    /// Makes the frame's targets anew where they are not in memory of `memoryDevice` yet, unless a host has
    /// their names.
    void selectTargets(int width, int height, const GBufferParts& parts,
                       const gl::ExternalMemoryDevice* memoryDevice);
    GBufferTargets& targetsWith(const GBufferParts& parts, int width, int height,
                                const gl::ExternalMemoryDevice* memoryDevice = nullptr);
    void createPasses(const FrameSettings& settings, Technique technique, const TracedRays& traced);
    void describeFrame(const GpuScene::State& scene, const CameraView& requested,
                       const FrameSettings& settings, Technique technique, const TracedRays& traced);
    /// Whether a material in view has more lobes than metallic and roughness describe.
    bool showsLobes(const GpuScene::State& scene);
    void startSample(GpuScene::State& scene, const CameraView& view, std::uint32_t sample,
                     GBufferTargets& into);
    void drawLit(const GpuScene::State& scene);
    void drawLayers(const GpuScene::State& scene);
    void drawLayer(const GpuScene::State& scene, std::uint32_t index, const LayerExtents::Layer& layer);
    void compositeLayers(const GpuScene::State& scene);
    /// Adds all light to the targets of `shaded`, whose geometry has been drawn.
    void light(const GpuScene::State& scene, ShadedSurfaces& shaded, gl::PassTimer& passes);
    void findVisibility(const GpuScene::State& scene, ShadedSurfaces& shaded, gl::PassTimer& passes);
    EnvironmentVisibility traceVisibility(const GpuScene::State& scene, ShadedSurfaces& shaded);
    EnvironmentRays environmentRays(const GpuScene::State& scene) const;
    /// Of the frame that `uniforms` describes and `copy` has read. Without OpenGL where that was read before.
    const std::uint8_t* traceOnCpu(const GpuScene::State& scene, const layout::FrameUniforms& uniforms,
                                   const EnvironmentRays& rays, const GBufferParts& parts, GBufferCopy& copy);
    /// What samples are drawn into in turns: the frame's targets and, where these are mapped, others, so that
    /// both are read in place.
    std::array<GBufferTargets*, 2> sampleTargets();
    using FindVisibility = std::function<const std::uint8_t*()>;
    FindVisibility captureSample(const GpuScene::State& scene, const GBufferTargets& drawn, CpuTiles& tiles);
    void drawBackground(const GpuScene::State& scene);
    void drawDebugView(const GpuScene::State& scene);
    void drawOverlays(GpuScene::State& scene);
    /// Targets with the shadow word, from which occlusion rays start, with `scene.occlusion` in step: those
    /// `shown`, or drawn again for a frame without shadows.
    const GBufferTargets& prepareRays(GpuScene::State& scene, const GBufferTargets& shown);
};

}  // namespace candela
