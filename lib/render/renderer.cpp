#include <candela/renderer.h>

#include "gl/pass_timer.h"
#include "gl/state_guard.h"
#include "render/debug/aovs.h"
#include "render/debug/debug_view_pass.h"
#include "render/debug/instance_pass.h"
#include "render/debug/overlay_pass.h"
#include "render/debug/probe.h"
#include "render/debug/scissor.h"
#include "render/display/display_pass.h"
#include "render/frame_uniforms.h"
#include "render/frustum.h"
#include "render/gbuffer/geometry_pass.h"
#include "render/gbuffer/readback.h"
#include "render/gpu_scene/gpu_scene_state.h"
#include "render/lighting/lighting.h"

#include <candela/error.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <optional>

namespace candela {

namespace {

/// A frame that was drawn, for what is read or counted of it later.
struct DrawnFrame {
    FrameInputs inputs;
    Technique technique;
    layout::FrameUniforms uniforms;
    Frustum frustum;
};

struct DisplayTarget {
    gl::Texture texture;
    gl::Framebuffer framebuffer;
};

bool hasLines(const Overlays& overlays) {
    return overlays.wireframe || overlays.cage;
}

void checkInputs(const FrameInputs& inputs) {
    if (inputs.width >= 1 && inputs.height >= 1) return;
    throw Error(ErrorKind::badInput, "",
                "a picture of " + std::to_string(inputs.width) + "x" + std::to_string(inputs.height) +
                    " pixels is asked for; width and height have to be 1 or more");
}

void checkPixel(const FrameInputs& inputs, int x, int y) {
    if (x >= 0 && x < inputs.width && y >= 0 && y < inputs.height) return;
    throw Error(ErrorKind::badInput, "",
                "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") is asked for of a picture of " +
                    std::to_string(inputs.width) + "x" + std::to_string(inputs.height) + " pixels");
}

template <typename T>
void flipRows(std::vector<T>& pixels, int width, int height) {
    const auto row = static_cast<std::ptrdiff_t>(width) * 4;
    for (std::ptrdiff_t y = 0; y < height / 2; ++y) {
        std::swap_ranges(pixels.begin() + y * row, pixels.begin() + (y + 1) * row,
                         pixels.begin() + (height - 1 - y) * row);
    }
}

}  // namespace

struct Renderer::State {
    explicit State(const Context& context)
        : timer(context.isSoftware() ? gl::PassTimer::Clock::wallAroundFinish
                                     : gl::PassTimer::Clock::gpuQueries),
          lighting(context),
          display(context.isSoftware() ? DisplayPass::Baking::whereFaster : DisplayPass::Baking::never),
          frameBuffer("frame uniforms") {}

    void resize(int width, int height);
    LightingInputs lightingInputs(const GpuScene& scene) const;
    void bindFrame(const layout::FrameUniforms& uniforms);
    void drawGeometry(const GpuScene& scene, const GBufferTargets& into, GeometryPass::LoadOp start);
    void drawSurfaces(const GpuScene& scene, GeometryPass::LoadOp start);
    void drawPicture(const GpuScene& scene);
    void drawData(const GpuScene& scene);
    void drawOverlays(const GpuScene& scene);
    void makePasses(const FrameInputs& inputs, Technique technique);
    glm::vec3 emissionAt(const GpuScene& scene, int x, int y);
    const DrawnFrame& drawnFrame() const;

    gl::PassTimer timer;
    GeometryPass geometry;
    Lighting lighting;
    DisplayPass display;
    gl::Buffer frameBuffer;
    InstancePass instances;
    DrawSelection draws;  ///< Of the last frame's view.
    // Made by `makePasses` when they are first needed.
    std::optional<DebugViewPass> show;
    std::optional<OverlayPass> overlays;
    std::optional<GBufferTargets> targets;
    std::optional<GBufferTargets> unlitTargets;  ///< Where `emissionAt` draws.
    std::optional<DisplayTarget> displayTarget;
    std::optional<DrawnFrame> frame;
};

void Renderer::State::resize(int width, int height) {
    if (targets && targets->width == width && targets->height == height) return;
    frame.reset();
    displayTarget.reset();
    unlitTargets.reset();
    targets.reset();
    targets.emplace(width, height);
}

/// Makes what the frame is drawn with, before its passes are timed.
void Renderer::State::makePasses(const FrameInputs& inputs, Technique technique) {
    if (inputs.show == DebugView::none) {
        lighting.technique(technique, inputs.tileBackend);
    } else if (!show) {
        show.emplace();
    }
    if (hasLines(inputs.overlays) && !overlays) overlays.emplace();
}

LightingInputs Renderer::State::lightingInputs(const GpuScene& scene) const {
    return {*targets,        scene.state().lights, frame->frustum,
            frame->uniforms, frame->inputs.brdf,   draws.emits()};
}

void Renderer::State::bindFrame(const layout::FrameUniforms& uniforms) {
    frameBuffer.upload(std::span<const layout::FrameUniforms>(&uniforms, 1));
    glBindBufferBase(GL_UNIFORM_BUFFER, layout::FRAME_BINDING, frameBuffer.name());
}

void Renderer::State::drawGeometry(const GpuScene& scene, const GBufferTargets& into,
                                   GeometryPass::LoadOp start) {
    scene.state().cull(frame->frustum, draws);
    geometry.render({scene.state(), draws, into, start});
}

void Renderer::State::drawSurfaces(const GpuScene& scene, GeometryPass::LoadOp start) {
    const gl::PassTimer::Scope pass(timer, "geometry");
    drawGeometry(scene, *targets, start);
}

void Renderer::State::drawPicture(const GpuScene& scene) {
    LightingTechnique& technique = lighting.technique(frame->technique, frame->inputs.tileBackend);
    drawSurfaces(scene, technique.radianceLoadOp());
    const LightingInputs inputs = lightingInputs(scene);
    lighting.bind(inputs);
    technique.render(inputs, timer);
}

void Renderer::State::drawData(const GpuScene& scene) {
    drawSurfaces(scene, GeometryPass::LoadOp::clear);
    const LightingInputs inputs = lightingInputs(scene);
    lighting.bind(inputs);
    const gl::PassTimer::Scope pass(timer, "show");
    show->render({frame->inputs.show, scene.state(), draws, inputs, lighting, instances});
}

void Renderer::State::drawOverlays(const GpuScene& scene) {
    const gl::PassTimer::Scope pass(timer, "overlays");
    overlays->render({scene.state(), draws, *targets, frame->inputs.overlays});
}

/// The emission at a pixel of the last frame, y from the bottom. The frame's own radiance target holds light
/// by now, so that the pixel is drawn once more.
glm::vec3 Renderer::State::emissionAt(const GpuScene& scene, int x, int y) {
    if (!draws.emits()) return glm::vec3(0.0f);
    if (!unlitTargets) unlitTargets.emplace(targets->width, targets->height);
    const Scissor pixel({x, y, 1, 1});
    drawGeometry(scene, *unlitTargets, GeometryPass::LoadOp::clear);
    glm::vec4 emission(0.0f);
    glGetTextureSubImage(unlitTargets->radiance.name(), 0, x, y, 0, 1, 1, 1, GL_RGBA, GL_FLOAT,
                         sizeof emission, &emission);
    return glm::vec3(emission);
}

const DrawnFrame& Renderer::State::drawnFrame() const {
    assert(frame && "render has to be called first");
    return *frame;
}

Renderer::Renderer(const Context& context) {
    context.makeCurrent();
    const gl::StateGuard guard;
    state_ = std::make_unique<State>(context);
}

Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

void Renderer::render(const GpuScene& scene, const FrameInputs& inputs) {
    checkInputs(inputs);
    const gl::StateGuard guard;
    State& state = *state_;
    state.resize(inputs.width, inputs.height);
    scene.state().update();
    const Technique technique =
        inputs.technique == Technique::automatic ? Technique::tiles : inputs.technique;
    state.makePasses(inputs, technique);
    state.frame.emplace(DrawnFrame{
        inputs, technique,
        frameUniforms(inputs.view, inputs.width, inputs.height, scene.state().options.workingFromRec709,
                      scene.state().lights.counts()),
        Frustum(inputs.view, static_cast<float>(inputs.width) / static_cast<float>(inputs.height))});
    state.timer.beginFrame();
    state.bindFrame(state.frame->uniforms);
    if (scene.state().hasCages()) {
        const gl::PassTimer::Scope pass(state.timer, "cages");
        scene.state().updateCages(inputs.view, inputs.width, inputs.height);
    }
    if (inputs.show == DebugView::none) {
        state.drawPicture(scene);
    } else {
        state.drawData(scene);
    }
    if (hasLines(inputs.overlays)) state.drawOverlays(scene);
}

void Renderer::display(const DisplayTransform& transform, const FrameTarget& target) {
    const DrawnFrame& frame = state_->drawnFrame();
    const gl::StateGuard guard;
    const gl::PassTimer::Scope pass(state_->timer, "display");
    if (frame.inputs.show == DebugView::none) {
        state_->display.render(
            {state_->targets->radiance, frame.inputs.width, frame.inputs.height, transform, target});
    } else {
        state_->show->display(*state_->targets, target);
    }
    if (hasLines(frame.inputs.overlays)) state_->overlays->display(target);
}

std::vector<std::uint8_t> Renderer::displayPicture(const DisplayTransform& transform) {
    const FrameInputs& inputs = state_->drawnFrame().inputs;
    if (!state_->displayTarget) {
        gl::Texture texture = gl::Texture::target2d(GL_RGBA8, inputs.width, inputs.height, "display");
        gl::Framebuffer framebuffer({&texture}, nullptr, "display");
        state_->displayTarget = DisplayTarget{std::move(texture), std::move(framebuffer)};
    }
    display(transform, {.framebuffer = state_->displayTarget->framebuffer.name()});
    const gl::StateGuard guard;
    std::vector<std::uint8_t> pixels = readBytes(state_->displayTarget->texture, inputs.width, inputs.height);
    flipRows(pixels, inputs.width, inputs.height);
    return pixels;
}

HdrImage Renderer::radiance() {
    const gl::StateGuard guard;
    const GBufferTargets& targets = *state_->targets;
    HdrImage picture{targets.width, targets.height,
                     readColor(targets.radiance, targets.width, targets.height)};
    const std::vector<float> depth = readDepth(targets);
    for (std::size_t i = 0; i < depth.size(); ++i) picture.rgba[4 * i + 3] = depth[i] > 0.0f ? 1.0f : 0.0f;
    flipRows(picture.rgba, targets.width, targets.height);
    return picture;
}

std::vector<Aov> Renderer::aovs(const GpuScene& scene, const std::vector<std::string>& names) {
    checkAovNames(names);
    const DrawnFrame& frame = state_->drawnFrame();
    const gl::StateGuard guard;
    const GBufferTargets& targets = *state_->targets;
    const auto wants = [&](const char* name) { return std::ranges::find(names, name) != names.end(); };
    state_->bindFrame(frame.uniforms);
    std::vector<float> emission, lightCount;
    if (wants("emission")) {
        // The frame's own radiance target holds light by now: the emission is drawn once more.
        const GBufferTargets unlit(targets.width, targets.height);
        state_->drawGeometry(scene, unlit, GeometryPass::LoadOp::clear);
        emission = readColor(unlit.radiance, targets.width, targets.height);
    }
    if (wants("light_count")) {
        const LightingInputs inputs = state_->lightingInputs(scene);
        state_->lighting.bind(inputs);
        lightCount = state_->lighting.counter().litPerPixel(inputs);
    }
    const std::vector<GBufferTexel> surfaces = readSurfaces(targets);
    const std::vector<float> depth = readDepth(targets);
    const AovSources sources{targets.width, targets.height, frame.uniforms, surfaces,
                             depth,         emission,       lightCount};
    std::vector<Aov> result;
    for (const std::string& name : names) result.push_back(makeAov(name, sources));
    return result;
}

std::optional<PixelProbe> Renderer::probe(const GpuScene& scene, int x, int y) {
    const DrawnFrame& frame = state_->drawnFrame();
    checkPixel(frame.inputs, x, y);
    const gl::StateGuard guard;
    const int width = frame.inputs.width, height = frame.inputs.height, fromBottom = height - 1 - y;
    std::optional<PixelProbe> probe =
        probeSurface({*state_->targets, frame.uniforms, scene.state().lights, x, fromBottom});
    if (!probe) return std::nullopt;
    state_->bindFrame(frame.uniforms);
    scene.state().cull(frame.frustum, state_->draws);
    const std::optional<std::uint32_t> instance =
        state_->instances.at({scene.state(), state_->draws, width, height}, x, fromBottom);
    if (!instance) return std::nullopt;  // What the frame shows here has left the scene since.
    probe->node = scene.state().instances[*instance].node;
    probe->emission = state_->emissionAt(scene, x, fromBottom);
    return probe;
}

std::uint32_t Renderer::maxLightCount() const {
    if (state_->drawnFrame().inputs.show != DebugView::lightCount) return 0;
    return state_->show->maxLightCount();
}

PairCounts Renderer::countPairs(const GpuScene& scene) {
    const DrawnFrame& frame = state_->drawnFrame();
    const gl::StateGuard guard;
    state_->bindFrame(frame.uniforms);
    const LightingInputs inputs = state_->lightingInputs(scene);
    state_->lighting.bind(inputs);
    PairCounter& counter = state_->lighting.counter();
    const auto directionals = static_cast<std::uint64_t>(inputs.lights.counts().directionals);
    const std::uint64_t directionalPairs = directionals * countLitSurfaces(*state_->targets);
    const std::vector<float> lit = counter.litPerPixel(inputs);
    PairCounts counts;
    counts.lightsVisible = counter.lightsInView(inputs) + directionals;
    counts.pairsLit =
        static_cast<std::uint64_t>(std::accumulate(lit.begin(), lit.end(), 0.0)) + directionalPairs;
    if (frame.inputs.show != DebugView::none) return counts;  // No light was evaluated.
    LightingTechnique& lighting = state_->lighting.technique(frame.technique, frame.inputs.tileBackend);
    counts.pairsEvaluated = lighting.countEvaluated(inputs, counter) + directionalPairs;
    counts.lightListBytes = lighting.lightListBytes();
    return counts;
}

std::vector<PassTime> Renderer::passTimes() {
    std::vector<PassTime> times;
    for (const auto& [name, milliseconds] : state_->timer.results()) times.push_back({name, milliseconds});
    return times;
}

Technique Renderer::technique() const {
    return state_->drawnFrame().technique;
}

}  // namespace candela
