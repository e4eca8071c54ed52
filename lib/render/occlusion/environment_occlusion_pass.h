#pragma once

#include "gl/program.h"
#include "gl/texture.h"
#include "render/gbuffer/gbuffer_targets.h"
#include "render/occlusion/environment_occlusion.h"
#include "render/occlusion/gpu_occlusion.h"

#include <map>
#include <optional>

namespace candela {

/// `EnvironmentOcclusion` in shaders. The frame's uniform block is bound.
class EnvironmentOcclusionPass {
  public:
    /// One invocation traces at most `maxRays` rays.
    explicit EnvironmentOcclusionPass(std::uint32_t maxRays) : maxRays_(maxRays) {}

    /// `targets` have the shadow word. Returns an R8 texture of their size, 1 is all of the environment;
    /// undefined where there is no surface. Valid until the next call.
    const gl::Texture& render(const GBufferTargets& targets, const GpuOcclusion& occluders,
                              const EnvironmentRays& rays);

  private:
    struct Targets {
        Targets(int width, int height);
        int width, height;
        gl::Texture hidden, visibility;
    };

    const gl::Program& filterFor(const GBufferParts& parts);

    std::uint32_t maxRays_;
    std::optional<gl::Program> trace_;
    std::map<GBufferParts, gl::Program> filters_;
    std::optional<Targets> targets_;
};

}  // namespace candela
