#pragma once

#include "gl/program.h"
#include "render/lighting/lighting_technique.h"
#include "render/lighting/volumes/light_volumes.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// Counts pairs of a pixel and a point or spot light by drawing light volumes with additive blending. Slow;
/// never part of a timed frame.
class PairCounter {
  public:
    PairCounter();

    /// A texture whose red channel is the number of lights in whose range each pixel lies. Valid until the
    /// next call of any member.
    const gl::Texture& drawLit(const LightingInputs& inputs);
    /// The same, read back: rows from the bottom.
    std::vector<float> litPerPixel(const LightingInputs& inputs);
    /// The point and spot lights in view.
    std::uint32_t lightsInView(const LightingInputs& inputs);
    /// The fragments that `LightVolumes::drawInside` shades.
    std::uint64_t countInside(const LightingInputs& inputs);
    /// The occlusion rays of a frame with shadows, those of directional lights included: one for each pair
    /// that would be lit if nothing were in between.
    std::uint64_t countRays(const LightingInputs& inputs);

  private:
    enum class Channel { lit = 0, evaluated = 1, rays = 2 };
    /// Of frames with shadows; compiled when they are first needed.
    struct RayPrograms {
        explicit RayPrograms(const std::vector<std::string>& definitions);
        gl::Program points, spots;
    };
    const gl::Texture& target(const LightingInputs& inputs);
    std::vector<float> read(const LightingInputs& inputs, Channel channel) const;

    std::uint64_t sum(const LightingInputs& inputs, Channel channel) const;

    gl::Program program_;
    std::array<std::optional<RayPrograms>, 2> rayPrograms_;  ///< Without and with lobe words.
    LightVolumes volumes_;
    StencilledDepth depth_;
    std::optional<gl::Texture> counts_;
    int width_ = 0, height_ = 0;
};

}  // namespace candela
