#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace candela {

/// Appends the record of shaders/lib/instance.glsl for an instance that stands where `worldFromLocal` puts
/// it. Returns whether that turns the winding round.
bool appendInstanceRecord(std::vector<glm::vec4>& records, const glm::mat4& worldFromLocal);

/// No direction is stretched more than this by the matrix.
float maxScale(const glm::mat4& matrix);

/// A sphere in the world, centre and radius, that holds the local one.
glm::vec4 worldSphere(const glm::mat4& worldFromLocal, const glm::vec3& center, float radius);

}  // namespace candela
