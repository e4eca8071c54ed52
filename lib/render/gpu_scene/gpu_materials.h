#pragma once

#include "render/gpu_scene/record_buffer.h"
#include "render/layout.h"
#include "scene/model/uv_sets.h"

#include <candela/scene.h>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace candela {

/// The records of shaders/lib/material.glsl for all materials of a scene, after them one for surfaces
/// without a material, and then those of materials that are added.
class GpuMaterials {
  public:
    GpuMaterials(const Scene& scene, const glm::dmat3& workingFromRec709);

    /// Throws `Error` (badInput) when a surface of material `index` lacks texture coordinates that a texture
    /// of `material` reads.
    void requireUvs(std::uint32_t index, const Material& material) const;
    /// Makes room for what `set` writes of a material. Throws `Error` (limit) when the device has none;
    /// nothing is changed then.
    void reserve(const Material& material);
    void set(std::uint32_t index, const Material& material);
    /// Makes room for materials up to `count`, to be set. Throws as `reserve` does.
    void grow(std::size_t count);
    /// The sets of texture coordinates that all surfaces of a material have.
    void setCommonUvs(std::uint32_t index, UvSets sets) { commonUvs_[index] = sets; }
    /// Uploads the records set since the last call. Returns how many those are.
    std::size_t upload();

    const gl::BufferTexture& records() const { return records_.texture(); }
    /// Of shaders/lib/extended_material.glsl. Only those of materials with more lobes are written, and there
    /// are none before the first such material.
    bool hasLobes() const { return !lobeRecords_.texels().empty(); }
    const gl::BufferTexture& lobeRecords() const { return lobeRecords_.texture(); }

    /// The record of a material as shaders read it.
    std::span<const glm::uvec4> record(std::uint32_t index) const {
        return records_.texels().subspan(std::size_t{index} * layout::MATERIAL_TEXELS,
                                         layout::MATERIAL_TEXELS);
    }

  private:
    glm::dmat3 workingFromRec709_;
    std::vector<UvSets> commonUvs_;  ///< One a material: those that all of its surfaces have.
    RecordBuffer<glm::uvec4> records_;
    RecordBuffer<glm::vec4> lobeRecords_;  ///< One a material, or none.
};

}  // namespace candela
