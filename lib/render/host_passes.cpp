// What hosts draw into a frame: surfaces that they have drawn before, and passes of their own.

#include "gl/state_guard.h"
#include "render/debug/previous_vertices.h"
#include "render/frame_request.h"
#include "render/renderer_state.h"

#include <string>

namespace candela {

namespace {

/// Throws unless a texture of a host has one level of the frame's size to read.
void requireHostTexture(const char* what, GLuint texture, const FrameSettings& settings) {
    const std::string name =
        std::string("the ") + what + " of host surfaces, texture " + std::to_string(texture);
    if (glIsTexture(texture) == GL_FALSE) refuse(name + ", does not exist in the current context");
    GLint target = 0, width = 0, height = 0;
    glGetTextureParameteriv(texture, GL_TEXTURE_TARGET, &target);
    if (target != GL_TEXTURE_2D) refuse(name + ", is not of the type GL_TEXTURE_2D");
    glGetTextureLevelParameteriv(texture, 0, GL_TEXTURE_WIDTH, &width);
    glGetTextureLevelParameteriv(texture, 0, GL_TEXTURE_HEIGHT, &height);
    if (width == settings.width && height == settings.height) return;
    refuse(name + ", has " + std::to_string(width) + "x" + std::to_string(height) +
           " pixels; the frame has " + std::to_string(settings.width) + "x" +
           std::to_string(settings.height));
}

}  // namespace

CameraView Renderer::State::requestedView() const {
    CameraView view = frame->view;
    view.farPlane = frame->requestedFarPlane;
    return view;
}

DepthConversion& Renderer::State::conversion() {
    if (!depthConversion) depthConversion.emplace();
    return *depthConversion;
}

void Renderer::State::useHostSurfaces() {
    hostDraws = {};
    const HostSurfaces host = frame->settings.hostSurfaces;
    if (host.radiance != 0) requireHostTexture("radiance", host.radiance, frame->settings);
    if (host.depth != 0) {
        requireHostTexture("depth", host.depth, frame->settings);
        const DepthScale from = depthScale(requestedView(), host.convention), to = depthScale(frame->view);
        hostDraws.depth = [this, host, from, to, settings = frame->settings](GLuint framebuffer) {
            conversion().render({host.depth, from, to, {framebuffer}, settings.width, settings.height});
        };
    }
    if (host.radiance == 0) return;
    hostDraws.radiance = [this, host](const GBufferTargets& into) {
        const bool hasDepth = static_cast<bool>(hostDraws.depth);
        const DepthScale to = depthScale(frame->view);
        const DepthScale from = hasDepth ? depthScale(requestedView(), host.convention) : to;
        conversion().renderRadiance(
            host.radiance, {host.depth, from, to, {into.litWithDepth.name()}, into.width, into.height});
    };
}

std::vector<SurfaceId> Renderer::State::surfaceIds(const GpuScene::State& scene,
                                                   const gl::PixelRectangle& rectangle) {
    scene.cull(frame->frustum, draws);
    return instances.read({scene, draws, targets->width, targets->height, hostDraws.depth}, rectangle);
}

std::vector<float> Renderer::State::previousPositions(GpuScene::State& scene,
                                                      std::span<const SurfaceId> ids) {
    PreviousVertices previous(scene, ids);
    if (previous.empty()) return {};
    bindFrame();
    scene.cull(frame->frustum, draws);
    previous.bind();
    return instances.readPreviousPositions({scene, draws, targets->width, targets->height, hostDraws.depth});
}

void Renderer::State::runHook(const std::function<void(const FrameStage&)>& hook,
                              const gl::Framebuffer& target) {
    const gl::PassTimer::Scope pass(timer, "host");
    glBindFramebuffer(GL_FRAMEBUFFER, target.name());
    glViewport(0, 0, targets->width, targets->height);
    glDepthFunc(GL_LESS);
    glUseProgram(0);
    glBindVertexArray(0);
    hook({target.name(), targets->width, targets->height, frame->uniforms.clipFromWorld,
          frame->view.worldFromCamera});
    binding->requireCurrent("a Renderer, after a hook of the host,");
    gl::StateGuard::setDefaults();
    bindFrame();
}

void Renderer::State::runAfterGeometry() {
    if (!frame->settings.hooks.afterGeometry) return;
    runHook(frame->settings.hooks.afterGeometry, targets->surfacesAndEmission);
    frameSurfaces.emits = true;
}

void Renderer::State::runBeforeDisplay() {
    if (!frame->settings.hooks.beforeDisplay) return;
    targets->takeLitRadiance();
    runHook(frame->settings.hooks.beforeDisplay, targets->litWithDepth);
}

void Renderer::State::writeDepth(const FrameTarget& target, const DepthConvention& convention) {
    conversion().render({targets->depth.name(), depthScale(frame->view),
                         depthScale(requestedView(), convention), target, targets->width, targets->height});
}

}  // namespace candela
