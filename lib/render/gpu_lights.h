#pragma once

#include "gl/texture.h"
#include "render/frame_uniforms.h"

#include <candela/gpu_scene.h>
#include <candela/light.h>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include <span>
#include <vector>

namespace candela {

/// The lights as the shaders read them: points first, then spots, then directional lights.
class GpuLights {
  public:
    explicit GpuLights(const GpuSceneOptions& options);

    /// Replaces all lights: one upload of the records, one of the spots' cones. Throws `Error` (badInput)
    /// naming a light whose numbers break what `PlacedLight` states, and `Error` (limit) when the device can
    /// not hold as many.
    void set(std::span<const PlacedLight> lights);

    const LightCounts& counts() const { return counts_; }
    /// Position and range of the points and spots, in the order of the records.
    std::span<const glm::vec4> reaches() const { return reaches_; }
    const LightReport& report() const { return report_; }

    const gl::BufferTexture& records() const { return records_; }
    const gl::BufferTexture& cones() const { return cones_; }

  private:
    void writeLocal(std::size_t index, const PlacedLight& light);
    float rangeOf(const PlacedLight& light, const glm::vec3& intensity);

    GpuSceneOptions options_;
    LightCounts counts_;
    LightReport report_;
    std::vector<glm::vec4> reaches_, recordData_, coneData_;
    gl::BufferTexture records_, cones_;
};

}  // namespace candela
