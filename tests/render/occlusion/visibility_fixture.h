#pragma once

#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include "gl/state_guard.h"
#include "render/frame_uniforms.h"
#include "render/gbuffer/gbuffer_copy.h"
#include "render/gbuffer/geometry_pass.h"
#include "render/gpu_scene/gpu_scene_state.h"
#include "render/occlusion/environment_occlusion.h"
#include "render/occlusion/environment_occlusion_pass.h"
#include "render/occlusion/occlusion_scene.h"

#include <candela/environment.h>
#include <candela/threads.h>

#include <cstdint>
#include <cstring>
#include <vector>

namespace candela::test {

inline Environment whiteEnvironment() {
    Environment environment;
    environment.picture.width = 2;
    environment.picture.height = 1;
    environment.picture.format = PixelFormat::rgba32f;
    const std::vector<float> white(8, 1.0f);
    environment.picture.pixels.resize(white.size() * sizeof(float));
    std::memcpy(environment.picture.pixels.data(), white.data(), environment.picture.pixels.size());
    return environment;
}

/// Tests of what `EnvironmentOcclusion` and `EnvironmentOcclusionPass` find, without the light.
class VisibilityTest : public DrawingTest {
  protected:
    static constexpr int width = 64, height = 36;
    static constexpr std::size_t pixels = std::size_t{width} * height;

    enum class Form { cpu, shader };
    static constexpr Form forms[] = {Form::cpu, Form::shader};

    /// Rows from the bottom.
    struct Picture {
        std::vector<std::uint8_t> bytes;
        std::vector<float> depth;
        std::vector<glm::vec3> positions;
    };

    /// Is the window of the filter whole?
    static bool isInside(std::size_t pixel) {
        const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
        return x >= 2 && y >= 2 && x < width - 2 && y < height - 2;
    }

    void SetUp() override {
        if (!hasShadows()) GTEST_SKIP() << "built without shadows";
    }

    static Picture visibility(GpuScene& scene, const CameraView& view, const EnvironmentRays& rays,
                              Form form) {
        context().makeCurrent();
        const gl::StateGuard guard(*context().state().binding, "a test");
        GpuScene::State& state = scene.state();
        state.update();
        const Frustum frustum(view, static_cast<float>(width) / height);
        state.updateDeformations(frustum, VertexScope::everywhere);
        state.updateOcclusion();
        const layout::FrameUniforms uniforms =
            frameUniforms(view, width, height, glm::dmat3(1.0), state.lights.counts());
        gl::Buffer buffer("frame", gl::BufferUsage::dynamic);
        buffer.upload(std::span<const layout::FrameUniforms>(&uniforms, 1));
        glBindBufferBase(GL_UNIFORM_BUFFER, layout::FRAME_BINDING, buffer.name());
        const GBufferTargets targets(width, height,
                                     {.shadowWord = true, .occlusion = state.usesOcclusionTextures()});
        GeometryPass geometry;
        DrawSelection draws;
        state.cull(frustum, draws);
        geometry.render({state, draws, targets, LoadOp::clear});
        GBufferCopy copy;
        copy.reset(targets);
        Picture picture;
        picture.depth.assign(copy.depth().begin(), copy.depth().end());
        for (std::size_t i = 0; i < pixels; ++i) {
            picture.positions.push_back(worldPosition(uniforms, static_cast<int>(i) % width,
                                                      static_cast<int>(i) / width, picture.depth[i]));
        }
        if (form == Form::cpu) {
            EnvironmentOcclusion occlusion;
            const auto textures =
                targets.parts.occlusion ? copy.occlusion() : std::span<const std::uint8_t>{};
            const auto bytes = occlusion.compute({uniforms, copy.depth(), copy.surfaces(), copy.shadowWords(),
                                                  textures, state.occlusion->view(), rays, copy.rectangle()});
            picture.bytes.assign(bytes.begin(), bytes.end());
            return picture;
        }
        state.occlusion->updateShaderForm();
        EnvironmentOcclusionPass pass(16);
        const gl::Texture& texture = pass.render(targets, *state.occlusion->shaderForm(), rays);
        picture.bytes.resize(pixels);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureImage(texture.name(), 0, GL_RED, GL_UNSIGNED_BYTE, static_cast<GLsizei>(pixels),
                          picture.bytes.data());
        return picture;
    }
};

}  // namespace candela::test
