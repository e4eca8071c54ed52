#pragma once

#include "scene/validate/error_context.h"

#include <candela/scene.h>

namespace candela {

// The parts of `validate`: each checks one element and throws `Error` (badInput) that names it.

void validateImage(const Image& image, const ErrorContext& element);
void validateMaterial(const Material& material, const Scene& scene, const ErrorContext& element);
void validateMesh(const Mesh& mesh, const Scene& scene, const ErrorContext& element);
/// All but which of the skin's joints it names: see `validateCageInstances`.
void validateCage(const Cage& cage, const Scene& scene, const ErrorContext& element);
/// The part of `validateCage` that needs no scene: all but the materials.
void validateCageSurface(const Cage& cage, const ErrorContext& element);
void validateSkin(const Skin& skin, const Scene& scene, const ErrorContext& element);
void validateAnimation(const Animation& animation, const Scene& scene, const ErrorContext& element);

/// That the cages of the nodes exist and fit their skins and morph weights. Cages and skins have been
/// checked.
void validateCageInstances(const Scene& scene);
/// Where the nodes stand at time 0. All else has been checked.
void validatePlaces(const Scene& scene);

/// Which sets of texture coordinates an element has.
struct UvSets {
    bool set0 = false, set1 = false;
};

/// glTF 2.0, 5.30.2: an element must have the texture coordinates that its material's textures name.
void requireUvs(const UvSets& sets, std::uint32_t material, const Scene& scene, const ErrorContext& element);

/// Whether the last row is 0, 0, 0, 1.
bool isAffine(const glm::mat4& matrix);

/// Whether `direction` has a length of 1 within the tolerance of scene/limits.h.
bool isUnit(const glm::vec3& direction);

}  // namespace candela
