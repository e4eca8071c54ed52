#pragma once

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/environment/gpu_environment.h"
#include "render/lighting/lighting_technique.h"

#include <array>
#include <optional>

namespace candela {

/// Draws what an environment adds to a picture: its light on surfaces, for the techniques that do not, and
/// itself where no surface is.
class EnvironmentPass {
  public:
    EnvironmentPass();

    /// The parts of the light that are drawn, as factors.
    struct Parts {
        float diffuse = 1.0f, specular = 1.0f;
    };
    /// Adds the light of `inputs.environment` to `target`. The frame's uniform block and the textures of
    /// `bindForLighting` are bound.
    void addLight(const LightingInputs& inputs, const gl::Framebuffer& target, Parts parts);

    /// Writes the environment into the pixels of the radiance target that show no surface. The frame's
    /// uniform block is bound.
    void drawBackground(const GBufferTargets& targets, const GpuEnvironment& environment);
    /// Adds the environment to `picture`, of associated alpha, to the share of each pixel that it does not
    /// cover. The depth of `picture` is that of the opaque surfaces, where nothing is added.
    void drawBehind(const gl::Framebuffer& picture, const GBufferTargets& targets,
                    const GpuEnvironment& environment);

  private:
    const gl::Program& lightProgram(const LightingInputs& inputs, bool withVisibility);
    void bindVisibility(const LightingInputs& inputs);
    void drawPicture(const gl::Framebuffer& target, const GBufferTargets& targets,
                     const GpuEnvironment& environment);
    void draw(const gl::Framebuffer& target, const GBufferTargets& targets) const;

    std::array<std::optional<gl::Program>, 8> lightPrograms_;
    std::optional<gl::Program> background_;
    gl::Texture visibility_;
    int visibilityWidth_ = 0, visibilityHeight_ = 0;
    gl::VertexArray vertexArray_;
};

}  // namespace candela
