#pragma once

#include "gl/pass_timer.h"
#include "gl/program.h"
#include "render/frustum.h"
#include "render/gbuffer/gbuffer_targets.h"
#include "render/gpu_scene/gpu_lights.h"

#include <candela/brdf.h>
#include <candela/frame_data.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace candela {

class GBufferCopy;
class GpuEnvironment;
class OcclusionScene;
class PairCounter;

/// What a lighting technique works on. The frame's uniform block is bound, and for techniques that shade in
/// shaders the textures of `bindForLighting`.
struct LightingInputs {
    const GBufferTargets& targets;
    const GpuLights& lights;
    const Frustum& frustum;
    const layout::FrameUniforms& uniforms;
    BrdfModel brdf;
    /// What hides lights; null in a frame without shadows. The G-buffer has the shadow word with it.
    const OcclusionScene* occlusion;
    /// What lights from everywhere; null in a frame without it.
    const GpuEnvironment* environment;
    /// The share of the environment that each pixel sees, 0 to 255, rows from the bottom; null: all of it.
    const std::uint8_t* environmentVisibility;
    bool emissionDrawn;  ///< `targets.radiance` holds emission; else its content is that of `radianceLoadOp`.
    /// Of `targets`, or of a rectangle outside of which these have no surfaces; null: who needs one makes it.
    GBufferCopy* copy = nullptr;
    /// As `environmentVisibility`, for techniques that shade in shaders: R8, of the targets' size.
    const gl::Texture* environmentVisibilityTexture = nullptr;
};

/// A way to bring lights to pixels. Each adds the light of all lights to `targets.radiance`. A new technique
/// is a subclass, a value of `Technique`, and a case in `Lighting`.
class LightingTechnique {
  public:
    virtual ~LightingTechnique() = default;

    /// How the geometry pass loads the radiance target: `dontCare` for a technique that writes every pixel.
    virtual LoadOp radianceLoadOp() const { return LoadOp::clear; }

    /// The result may stay in memory (`GBufferTargets::memory`) until the next frame.
    virtual void render(const LightingInputs& inputs, gl::PassTimer& timer) = 0;

    /// Whether `render` adds the light of the environment too; else `EnvironmentPass` does.
    virtual bool drawsEnvironment() const { return false; }

    /// Bytes of the lists of lights of the last rendered frame.
    virtual std::uint64_t lightListBytes() const = 0;

    /// Occlusion rays of the last rendered frame.
    virtual ShadowCounts shadowCounts() const { return {}; }

    /// How often the last rendered frame ran the BRDF of a point or spot light at a pixel. May draw again
    /// with `counter`; never part of a timed frame.
    virtual std::uint64_t countEvaluated(const LightingInputs& inputs, PairCounter& counter) = 0;
};

/// How many lights one invocation of a shader iterates over at most. llvmpipe silently ends the loops of an
/// invocation after 65,535 iterations in all.
struct LightsPerInvocation {
    int plain = 32768;
    int traced = 16;  ///< In frames with shadows: a ray has up to some thousand iterations of its own.

    /// On a GPU only the time of one draw or dispatch is limited.
    static LightsPerInvocation onGpu() { return {32768, 4096}; }
    int of(const LightingInputs& inputs) const { return inputs.occlusion == nullptr ? plain : traced; }
};

/// Directional albedo tables as textures: the model's, and that of sheen.
gl::Texture makeAlbedoTexture(BrdfModel model);
gl::Texture makeSheenTexture();

/// Binds the textures that shaders/lib/lighting.glsl reads in frames without shadows.
void bindForLighting(const GBufferTargets& targets, const GpuLights& lights, const gl::Texture& albedo);

/// A program for each reflection model, without and with shadows and lobe words, compiled when it is first
/// needed: of a compute stage, or of a vertex and a fragment stage.
class ModelPrograms {
  public:
    /// `vertexFile` is empty for a compute stage. `definitions` are for `file`, the stage that shades.
    ModelPrograms(std::string vertexFile, std::string file, std::vector<std::string> definitions);

    const gl::Program& get(const LightingInputs& inputs) const;

  private:
    std::string vertexFile_, file_;
    std::vector<std::string> definitions_;
    mutable std::array<std::optional<gl::Program>, 8> programs_;
};

}  // namespace candela
