#pragma once

#include "scene/element.h"

#include <candela/scene.h>

namespace candela {

// The parts of `validate`: each checks one element and throws `Error` (badInput) that names it.

void validateImage(const Image& image, const Element& element);
void validateMaterial(const Material& material, const Scene& scene, const Element& element);
void validateMesh(const Mesh& mesh, const Scene& scene, const Element& element);
void validateAnimation(const Animation& animation, const Scene& scene, const Element& element);

/// Whether `direction` has a length of 1 within the tolerance of scene/limits.h.
bool isUnit(const glm::vec3& direction);

}  // namespace candela
