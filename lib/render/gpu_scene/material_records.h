#pragma once

#include <candela/material.h>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include <span>
#include <vector>

namespace candela {

/// The records of shaders/lib/material.glsl for all materials of a scene, and after them one for surfaces
/// without a material.
std::vector<glm::uvec4> materialRecords(std::span<const Material> materials,
                                        const glm::dmat3& workingFromRec709);

/// The record of one of them.
std::vector<glm::uvec4> materialRecord(const Material& material, const glm::dmat3& workingFromRec709);

}  // namespace candela
