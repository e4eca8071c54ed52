#include "support/tile_implementations.h"

#include "gl/state_guard.h"
#include "render/environment/environment_pass.h"
#include "render/frame_uniforms.h"
#include "render/gbuffer/geometry_pass.h"
#include "render/gbuffer/readback.h"
#include "render/lighting/fullscreen/fullscreen_technique.h"
#include "render/lighting/tiled/compute_tiles.h"
#include "render/lighting/tiled/cpu_tiles.h"

namespace candela::test {

namespace {

/// A fullscreen technique that owns its pass.
class OwnFullscreen final : public LightingTechnique {
  public:
    OwnFullscreen() : technique_(pass_) {}
    void render(const LightingInputs& inputs, gl::PassTimer& timer) override {
        technique_.render(inputs, timer);
    }
    std::uint64_t lightListBytes() const override { return 0; }
    std::uint64_t countEvaluated(const LightingInputs& inputs, PairCounter& counter) override {
        return technique_.countEvaluated(inputs, counter);
    }

  private:
    FullscreenPass pass_;
    FullscreenTechnique technique_;
};

}  // namespace

std::vector<TileImplementation> tileImplementations() {
    std::vector<TileImplementation> implementations;
    implementations.push_back({"compute", std::make_unique<ComputeTiles>()});
    for (const TileKernel* kernel : tileKernels())
        implementations.push_back({kernel->name, std::make_unique<CpuTiles>(*kernel)});
    return implementations;
}

std::vector<TileImplementation> limitedTileImplementations() {
    std::vector<TileImplementation> implementations;
    implementations.push_back({"compute, 64 KiB", std::make_unique<ComputeTiles>(std::size_t{1} << 16)});
    implementations.push_back(
        {"cpu, 64 KiB", std::make_unique<CpuTiles>(tileKernel(), std::uint64_t{1} << 14)});
    return implementations;
}

TileImplementation fullscreenImplementation() {
    return {"fullscreen", std::make_unique<OwnFullscreen>()};
}

std::vector<float> radianceOf(const Context& context, const TileImplementation& implementation,
                              const TileTestFrame& picture) {
    context.makeCurrent();
    GpuScene scene(context, picture.scene);
    scene.setLights(picture.lights);
    const gl::StateGuard guard(*context.state().binding, "a test");
    GeometryPass geometry;
    const gl::Texture albedo = makeAlbedoTexture(picture.brdf), sheen = makeSheenTexture();
    CameraView view = picture.view;
    // As the renderer does: behind every surface of the test scenes.
    if (view.orthographicHeight && !view.farPlane) view.farPlane = 1000.0f;
    const Frustum frustum(view, static_cast<float>(picture.width) / static_cast<float>(picture.height));
    GpuScene::State& state = scene.state();
    state.update();
    const GBufferTargets targets(picture.width, picture.height, {.lobes = state.materials.hasLobes()});
    DrawSelection draws;
    state.cull(frustum, draws);
    layout::FrameUniforms uniforms =
        frameUniforms(view, picture.width, picture.height, glm::dmat3(1.0), state.lights.counts());
    const GpuEnvironment* environment = state.environment.get();
    if (environment != nullptr) environment->describe(uniforms);
    EnvironmentPass environmentPass;
    gl::Buffer buffer("frame", gl::BufferUsage::dynamic);
    buffer.upload(std::span<const layout::FrameUniforms>(&uniforms, 1));
    glBindBufferBase(GL_UNIFORM_BUFFER, layout::FRAME_BINDING, buffer.name());
    gl::PassTimer timer(gl::PassTimer::Clock::wallAroundFinish);
    const LoadOp start = implementation.technique->radianceLoadOp();
    for (int frame = 0; frame < picture.frames; ++frame) {
        geometry.render({state, draws, targets, start});
        bindForLighting(targets, state.lights, albedo);
        glBindTextureUnit(layout::SHEEN_UNIT, sheen.name());
        const LightingInputs inputs{targets,      state.lights, frustum,     uniforms,
                                    picture.brdf, nullptr,      environment, picture.environmentVisibility,
                                    draws.emits()};
        implementation.technique->render(inputs, timer);
        if (environment != nullptr && !implementation.technique->drawsEnvironment())
            environmentPass.addLight(inputs, targets.lit, {});
    }
    return readColor(targets.litRadiance(), picture.width, picture.height);
}

}  // namespace candela::test
