#pragma once

#include "gl/program.h"
#include "render/lighting/lighting_technique.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// The directional albedo table as a texture.
gl::Texture makeAlbedoTexture();

/// Binds what shaders/lib/surface.glsl and shaders/lib/lights.glsl read.
void bindForLighting(const GBufferTargets& targets, const GpuLights& lights, const gl::Texture& albedo);

/// A program for each reflection model, made when it is first needed: of a compute stage, or of a vertex and
/// a fragment stage.
class ModelPrograms {
  public:
    /// `vertexFile` is empty for a compute stage. `definitions` are for `file`, the stage that shades.
    ModelPrograms(std::string vertexFile, std::string file, std::vector<std::string> definitions);

    const gl::Program& get(BrdfModel model) const;

  private:
    std::string vertexFile_, file_;
    std::vector<std::string> definitions_;
    mutable std::array<std::optional<gl::Program>, 2> programs_;
};

/// The definition that chooses a model in shaders/lib/brdf.glsl.
std::string brdfDefinition(BrdfModel model);

}  // namespace candela
