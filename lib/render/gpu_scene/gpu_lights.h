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

/// Positions and ranges, a column each, for culling many at a time. The columns are `padding` longer than the
/// lights are many.
struct LightReaches {
    static constexpr std::size_t padding = 16;

    std::vector<float> x, y, z, range;

    std::size_t size() const { return x.empty() ? 0 : x.size() - padding; }
    void resize(std::size_t size);
    glm::vec3 position(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// The lights as the shaders read them: points first, then spots, then directional lights.
class GpuLights {
  public:
    explicit GpuLights(const GpuSceneOptions& options);

    /// Replaces all lights: one upload of the records, one of the spots' cones. Throws `Error` (badInput)
    /// naming a light whose numbers break what `WorldLight` states, and `Error` (limit) when the device can
    /// not hold as many.
    void set(std::span<const WorldLight> lights);

    const LightCounts& counts() const { return counts_; }
    /// Where the points and spots reach, in the order of the records.
    const LightReaches& reaches() const { return reaches_; }
    /// The records as they were uploaded: two vectors a light, and one a spot.
    std::span<const glm::vec4> recordData() const { return recordData_; }
    std::span<const glm::vec4> coneData() const { return coneData_; }
    const LightReport& report() const { return report_; }

    const gl::BufferTexture& records() const { return records_; }
    const gl::BufferTexture& cones() const { return cones_; }

  private:
    void writeLocal(std::size_t index, const WorldLight& light);
    float rangeOf(const WorldLight& light, const glm::vec3& intensity);

    GpuSceneOptions options_;
    LightCounts counts_;
    LightReport report_;
    LightReaches reaches_;
    std::vector<glm::vec4> recordData_, coneData_;
    gl::BufferTexture records_, cones_;
};

}  // namespace candela
