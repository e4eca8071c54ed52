#include <candela/renderer.h>

#include "gl/state_guard.h"
#include "render/culling/triangle_filter.h"
#include "render/environment/gpu_environment.h"
#include "render/frame_request.h"
#include "render/frame_uniforms.h"
#include "render/gbuffer/readback.h"
#include "render/occlusion/ambient_occlusion.h"
#include "render/occlusion/occlusion_scene.h"
#include "render/renderer_state.h"

#include <candela/error.h>

#include <algorithm>
#include <array>
#include <string>

namespace candela {

namespace {

/// The environment of a scene, null where none lights surfaces.
const GpuEnvironment* lightOf(const GpuScene::State& scene) {
    return scene.environment && scene.environment->lights() ? scene.environment.get() : nullptr;
}

gl::PassTimer::Clock clockOf(const Context& context) {
    return context.isSoftware() ? gl::PassTimer::Clock::wallAroundFinish : gl::PassTimer::Clock::gpuQueries;
}

/// Of orthographic views: twice the size of the largest scene that `validate` takes.
constexpr float maxFarPlane = 4.0e9f;

bool castsShadows(const FrameSettings& settings) {
    return settings.shadows != Shadows::off && hasShadows();
}

bool drawsShadows(const FrameSettings& settings) {
    if (settings.shadows == Shadows::on && !hasShadows()) {
        throw Error(ErrorKind::environment, "",
                    "shadows are asked for, but this candela was built without them (CMake option "
                    "CANDELA_SHADOWS)");
    }
    // Other debug views show no light.
    return castsShadows(settings) &&
           (settings.debugView == DebugView::none || settings.debugView == DebugView::shadowedCount);
}

/// The depth of an orthographic view is linear and needs a far plane: one behind everything.
CameraView withFarPlane(const CameraView& view, const GpuScene::State& scene, const FramePixels& pixels) {
    if (!view.orthographicHeight) return view;
    CameraView limited = view;
    constexpr float margin = 1.001f;
    const float minRange = 0.01f * *view.orthographicHeight;
    const float range =
        margin * (scene.instances.farthestDepth(Frustum(view, pixels.pictureWindow(view))) - view.nearPlane);
    // Written so that a range that is not a number is the least one.
    const float farPlane = view.nearPlane + (range > minRange ? range : minRange);
    limited.farPlane = std::min({view.farPlane.value_or(farPlane), farPlane, maxFarPlane});
    return limited;
}

}  // namespace

Renderer::State::State(const Context& context)
    : binding(context.state().binding),
      timer(clockOf(context)),
      lighting(context),
      display(context.isSoftware() ? DisplayPass::Baking::always : DisplayPass::Baking::never),
      frameBuffer("frame uniforms", gl::BufferUsage::dynamic),
      layerTimer(clockOf(context)),
      targetMemory(context.isSoftware()) {}

void Renderer::State::selectTargets(int width, int height, const GBufferParts& parts,
                                    const gl::ExternalMemoryDevice* memoryDevice) {
    if (targets != nullptr && (targets->width != width || targets->height != height)) {
        displayTarget.reset();
        emissionTargets.reset();
        maskedTargets.reset();
        otherSampleTargets.reset();
        targetSets.clear();
    }
    targets = nullptr;
    const auto known = targetSets.find(parts);
    if (known != targetSets.end() && known->second.movesTo(memoryDevice)) targetSets.erase(known);
    targets = &targetsWith(parts, width, height, memoryDevice);
    targets->memory = {};
}

GBufferTargets& Renderer::State::targetsWith(const GBufferParts& parts, int width, int height,
                                             const gl::ExternalMemoryDevice* memoryDevice) {
    const auto found = targetSets.find(parts);
    if (found != targetSets.end()) return found->second;
    return targetSets.try_emplace(parts, width, height, parts, memoryDevice).first->second;
}

/// Creates what the frame is drawn with, before its passes are timed.
void Renderer::State::createPasses(const FrameSettings& settings, Technique technique,
                                   const TracedRays& traced) {
    if (settings.debugView == DebugView::none) {
        lighting.technique(technique, settings.tileBackend);
    } else if (!debugView) {
        debugView.emplace();
    }
    if (hasLines(settings.overlays) && !overlays) overlays.emplace();
    const bool inShaders = lighting.shadesInShaders(technique, settings.tileBackend);
    if (traced.environment && inShaders && !environmentOcclusionPass)
        environmentOcclusionPass.emplace(lighting.raysPerInvocation());
}

LightingInputs Renderer::State::lightingInputs(const GpuScene::State& scene, ShadedSurfaces& shaded) {
    return {*shaded.targets,
            scene.lights,
            frame->frustum,
            frame->uniforms,
            frame->settings.brdf,
            frame->traced.shadows ? scene.occlusion.get() : nullptr,
            lightOf(scene),
            shaded.visibility.bytes,
            shaded.emits,
            &shaded.copy,
            shaded.visibility.texture};
}

bool Renderer::State::showsLobes(const GpuScene::State& scene) {
    if (!scene.materials.hasLobes()) return false;
    scene.cull(frame->frustum, draws);
    return draws.isExtended();
}

void Renderer::State::bindFrame() {
    frameBuffer.upload(std::span<const layout::FrameUniforms>(&frame->uniforms, 1));
    glBindBufferBase(GL_UNIFORM_BUFFER, layout::FRAME_BINDING, frameBuffer.name());
}

void Renderer::State::drawGeometry(const GpuScene::State& scene, const GBufferTargets& into, SurfaceSet set,
                                   LoadOp radianceLoad) {
    set == SurfaceSet::opaque ? scene.cullOccluded(frame->frustum, frame->uniforms, draws)
                              : scene.cull(frame->frustum, draws);
    scene.triangleFilter->filter(draws, frame->uniforms);
    geometry.render({scene, draws, into, radianceLoad, set, scene.triangleFilter.get(), nullptr,
                     hasHostSurfaces() ? &hostDraws : nullptr});
}

void Renderer::State::drawLit(const GpuScene::State& scene) {
    LightingTechnique& technique = lighting.technique(frame->technique, frame->settings.tileBackend);
    {
        const gl::PassTimer::Scope pass(timer, "geometry");
        const bool addsRadiance = static_cast<bool>(frame->settings.hooks.afterGeometry);
        drawGeometry(scene, *targets, SurfaceSet::opaque,
                     addsRadiance ? LoadOp::clear : technique.radianceLoadOp());
    }
    frameSurfaces.emits = draws.emits() || hasHostSurfaces();
    runAfterGeometry();
    frame->hasTransparent = draws.hasTransparent();
    // First, so that all that is asked of the technique and of its passes later is of the opaque surfaces.
    if (frame->hasTransparent) drawLayers(scene);
    light(scene, frameSurfaces, timer);
    shadowCounts = technique.shadowCounts();
    if (scene.environment && scene.environment->isBackground()) drawBackground(scene);
    if (layerCounts.layers > 0) compositeLayers(scene);
}

void Renderer::State::light(const GpuScene::State& scene, ShadedSurfaces& shaded, gl::PassTimer& passes) {
    LightingTechnique& technique = lighting.technique(frame->technique, frame->settings.tileBackend);
    findVisibility(scene, shaded, passes);
    const LightingInputs inputs = lightingInputs(scene, shaded);
    if (lighting.shadesInShaders(frame->technique, frame->settings.tileBackend)) lighting.bind(inputs);
    technique.render(inputs, passes);
    if (inputs.environment == nullptr || technique.drawsEnvironment()) return;
    const gl::PassTimer::Scope pass(passes, "environment");
    environment.addLight(inputs, shaded.targets->lit, {});
}

void Renderer::State::drawBackground(const GpuScene::State& scene) {
    const gl::PassTimer::Scope pass(timer, "background");
    targets->takeLitRadiance();  // The background is drawn over it.
    environment.drawBackground(*targets, *scene.environment);
}

/// Of the environment: what occlusion textures leave of what rays find.
void Renderer::State::findVisibility(const GpuScene::State& scene, ShadedSurfaces& shaded,
                                     gl::PassTimer& passes) {
    const GBufferTargets& from = *shaded.targets;
    if (frame->traced.environment) {
        const gl::PassTimer::Scope pass(passes, "ambient occlusion");
        shaded.visibility = traceVisibility(scene, shaded);
    } else if (from.parts.occlusion &&
               lighting.shadesInShaders(frame->technique, frame->settings.tileBackend)) {
        shaded.visibility.texture = &from.words[from.indexOf(layout::OCCLUSION_OUTPUT)];
    } else if (from.parts.occlusion) {
        shaded.visibility.bytes = shaded.copy.occlusion().data();
    }
}

EnvironmentRays Renderer::State::environmentRays(const GpuScene::State& scene) const {
    constexpr float farthest = 1.0e30f;
    return {frame->settings.environmentOcclusion.rays, frame->settings.sample,
            scene.environment->settings().occlusionDistance.value_or(farthest)};
}

const std::uint8_t* Renderer::State::traceOnCpu(const GpuScene::State& scene,
                                                const layout::FrameUniforms& uniforms,
                                                const EnvironmentRays& rays, const GBufferParts& parts,
                                                GBufferCopy& copy) {
    const std::span<const std::uint8_t> textures =
        parts.occlusion ? copy.occlusion() : std::span<const std::uint8_t>{};
    return environmentOcclusion
        .compute({uniforms, copy.depth(), copy.surfaces(), copy.shadowWords(), textures,
                  scene.occlusion->view(), rays, copy.rectangle()})
        .data();
}

EnvironmentVisibility Renderer::State::traceVisibility(const GpuScene::State& scene, ShadedSurfaces& shaded) {
    const EnvironmentRays rays = environmentRays(scene);
    if (environmentOcclusionPass && lighting.shadesInShaders(frame->technique, frame->settings.tileBackend))
        return {&environmentOcclusionPass->render(*shaded.targets, *scene.occlusion->shaderForm(), rays),
                nullptr};
    return {nullptr, traceOnCpu(scene, frame->uniforms, rays, shaded.targets->parts, shaded.copy)};
}

void Renderer::State::drawDebugView(const GpuScene::State& scene) {
    {
        const gl::PassTimer::Scope pass(timer, "geometry");
        drawGeometry(scene, *targets, SurfaceSet::all, LoadOp::clear);
    }
    frameSurfaces.emits = draws.emits(SurfaceSet::all) || hasHostSurfaces();
    const LightingInputs inputs = lightingInputs(scene, frameSurfaces);
    lighting.bind(inputs);
    const gl::PassTimer::Scope pass(timer, "debug view");
    debugView->render(
        {frame->settings.debugView, scene, draws, inputs, lighting, instances, hostDraws.depth});
}

void Renderer::State::drawOverlays(GpuScene::State& scene) {
    const gl::PassTimer::Scope pass(timer, "overlays");
    scene.cull(frame->frustum, draws);  // Lines show a little behind a surface, too.
    overlays->render({scene, draws, *targets, frame->settings.overlays});
}

const GBufferTargets& Renderer::State::drawEmission(const GpuScene::State& scene) {
    if (!emissionTargets) emissionTargets.emplace(targets->width, targets->height);
    drawGeometry(scene, *emissionTargets, SurfaceSet::all, LoadOp::clear);
    return *emissionTargets;
}

ShadedSurfaces& Renderer::State::drawMasked(const GpuScene::State& scene) {
    if (masked.targets != nullptr) return masked;
    if (!maskedTargets || maskedTargets->parts != targets->parts)
        maskedTargets.emplace(targets->width, targets->height, targets->parts);
    drawGeometry(scene, *maskedTargets, SurfaceSet::all, LoadOp::dontCare);
    masked.reset(*maskedTargets);
    findVisibility(scene, masked, layerTimer);
    return masked;
}

const GBufferTargets& Renderer::State::drawEnvironment(const GpuScene::State& scene, ShadedSurfaces& shaded,
                                                       EnvironmentPass::Parts parts) {
    if (!emissionTargets) emissionTargets.emplace(targets->width, targets->height);
    constexpr std::array<GLfloat, 4> black{0.0f, 0.0f, 0.0f, 0.0f};
    glClearNamedFramebufferfv(emissionTargets->lit.name(), GL_COLOR, 0, black.data());
    const LightingInputs inputs = lightingInputs(scene, shaded);
    if (inputs.environment == nullptr) return *emissionTargets;
    lighting.bind(inputs);
    environment.addLight(inputs, emissionTargets->lit, parts);
    return *emissionTargets;
}

const GBufferTargets& Renderer::State::prepareRays(GpuScene::State& scene, const GBufferTargets& shown) {
    if (shown.parts.shadowWord) return shown;
    scene.updateCages(frame->view, frame->pixels.pictureWidth, frame->pixels.pictureHeight,
                      VertexScope::everywhere);
    scene.updateDeformations(frame->frustum, VertexScope::everywhere);
    scene.updateOcclusion();
    const GBufferParts parts{.shadowWord = true};
    const GBufferTargets& set = targetsWith(parts, targets->width, targets->height);
    drawGeometry(scene, set, SurfaceSet::all, LoadOp::dontCare);
    return set;
}

std::vector<float> Renderer::State::countShadowed(GpuScene::State& scene, const GBufferTargets& shown) {
    const bool shadows = castsShadows(frame->settings);
    const GBufferTargets& from = shadows ? prepareRays(scene, shown) : shown;
    return lighting.shadowedPerPixel({from, scene.lights, frame->frustum, frame->uniforms,
                                      frame->settings.brdf, shadows ? scene.occlusion.get() : nullptr,
                                      nullptr, nullptr, false});
}

std::vector<float> Renderer::State::traceAmbientOcclusion(GpuScene::State& scene,
                                                          const GBufferTargets& shown) {
    const GBufferTargets& from = prepareRays(scene, shown);
    const std::vector<float> depth = readDepth(from);
    std::vector<std::uint32_t> shadowWords(depth.size());
    readWords(from, wholeOf(from), layout::SHADOW_OUTPUT, shadowWords);
    const std::vector<GBufferTexel> surfaces = readSurfaces(from);
    return ambientOcclusion({frame->uniforms, depth, surfaces, shadowWords, scene.occlusion->view(),
                             frame->settings.ambientOcclusion});
}

glm::vec3 Renderer::State::emissionAt(const GpuScene::State& scene, int x, int y) {
    if (!draws.emits(SurfaceSet::all)) return glm::vec3(0.0f);
    const gl::Scissor pixel({x, y, 1, 1});
    return readColorAt(drawEmission(scene).radiance, x, y);
}

void Renderer::State::describeFrame(const GpuScene::State& scene, const CameraView& requested,
                                    const FrameSettings& settings, Technique technique,
                                    const TracedRays& traced) {
    const FramePixels pixels = framePixels(settings);
    const CameraView view = withFarPlane(requested, scene, pixels);
    const ViewWindow window = pixels.window(view);
    frame.emplace(
        DrawnFrame{settings, view, requested.farPlane, pixels, technique, traced,
                   frameUniforms(view, pixels, scene.options.workingFromRec709, scene.lights.counts()),
                   Frustum(view, window), scene.sceneState.origin});
    // Of the wider side of a pixel.
    const double pixelShare =
        std::max(1.0 / settings.height, window.halfExtent.x / window.halfExtent.y / settings.width);
    frame->frustum.setElementSize(std::max(settings.pointSize, settings.lineWidth) *
                                  static_cast<float>(pixelShare));
    frame->uniforms.elementSizes = {settings.pointSize, settings.lineWidth, 0.0f, 0.0f};
    if (scene.environment) scene.environment->describe(frame->uniforms);
    frame->uniforms.cameraForward.w = settings.specularAntialiasing ? 1.0f : 0.0f;
}

void Renderer::State::render(GpuScene::State& scene, const CameraView& requested,
                             const FrameSettings& settings) {
    ++frameNumber;
    frame.reset();
    shadowCounts = {};
    samplePasses.clear();
    masked.targets = nullptr;
    layerCounts = {};
    // Without such a light, as in a scene that only default lights light, the structure is not built.
    const bool shadows = drawsShadows(settings) && scene.lights.anyCastsShadow();
    const bool isLit = settings.debugView == DebugView::none;
    const TracedRays traced{shadows, drawsShadows(settings) && isLit && scene.hasEnvironmentLight()};
    GBufferParts parts{.shadowWord = traced.shadows || traced.environment,
                       .occlusion = isLit && scene.usesOcclusionTextures()};
    scene.lights.setSample(settings.sample);
    scene.update();
    const Technique technique =
        settings.technique == Technique::automatic ? Technique::tiles : settings.technique;
    createPasses(settings, technique, traced);
    describeFrame(scene, requested, settings, technique, traced);
    useHostSurfaces();
    timer.beginFrame();
    bindFrame();
    // What is out of view may cast shadows into it.
    const VertexScope scope = parts.shadowWord ? VertexScope::everywhere : VertexScope::inView;
    if (scene.hasCages()) {
        const gl::PassTimer::Scope pass(timer, "cages");
        scene.updateCages(frame->view, frame->pixels.pictureWidth, frame->pixels.pictureHeight, scope);
    }
    if (scene.hasDeformations()) {
        const gl::PassTimer::Scope pass(timer, "deform");
        scene.updateDeformations(frame->frustum, scope);
    }
    if (parts.shadowWord) {
        const gl::PassTimer::Scope pass(timer, "shadows");
        scene.updateOcclusion();
        if (lighting.shadesInShaders(technique, settings.tileBackend)) scene.occlusion->updateShaderForm();
    }
    parts.lobes = isLit && showsLobes(scene);
    const bool litOnCpu = isLit && !lighting.shadesInShaders(technique, settings.tileBackend);
    selectTargets(settings.width, settings.height, parts, litOnCpu ? targetMemory.countFrame() : nullptr);
    frameSurfaces.reset(*targets);
    if (settings.debugView == DebugView::none) {
        drawLit(scene);
        runBeforeDisplay();
    } else {
        drawDebugView(scene);
    }
    if (hasLines(settings.overlays)) drawOverlays(scene);
}

Renderer::Renderer(const Context& context) {
    context.makeCurrent();
    const std::shared_ptr<gl::ContextBinding>& binding = context.state().binding;
    const gl::StateGuard guard(*binding, "a Renderer");
    state_ = std::shared_ptr<State>(new State(context), gl::ContextDeleter<State>{binding, "Renderer"});
}

Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Frame Renderer::render(GpuScene& scene, const CameraView& view, const FrameSettings& settings) {
    if (!state_) refuse("a Renderer is used that was moved from");
    if (!scene.state_) refuse("a GpuScene is rendered that was moved from");
    checkSettings(settings);
    checkView(view);
    if (!scene.state_->binding->isSameAs(*state_->binding)) {
        refuse(
            "a GpuScene is rendered by a Renderer of another Context; both have to be created for the same "
            "one");
    }
    const gl::StateGuard guard(*state_->binding, "a Renderer");
    state_->render(*scene.state_, view, settings);
    return Frame(state_, scene.state_, state_->frameNumber);
}

}  // namespace candela
