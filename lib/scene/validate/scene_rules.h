#pragma once

#include "base/error_context.h"
#include "scene/model/deformation.h"
#include "scene/model/uv_sets.h"

#include <candela/scene.h>

namespace candela {

// The limits of scenes, and the parts of `validate`.

/// How far from the world's origin, in metres along each axis, meshes, lights and cameras may be. Squared
/// distances are then well within the range of a float.
constexpr float maxCoordinate = 1e9f;

/// The largest intensity of a light (candela or lux, times colour) and the largest emission.
constexpr float maxIntensity = 1e20f;

/// The largest value of an animation, and of a morph weight.
constexpr float maxAnimated = 1e9f;

/// How far the length of a direction may be from 1: the error of 8-bit quantised directions
/// (KHR_mesh_quantization), sqrt(4) × 0.5 / 127 for four numbers, and a little.
constexpr float unitTolerance = 0.01f;

/// How far the sum of a vertex's joint weights may be from 1: the error of four weights of 8 bits each,
/// 4 × 0.5 / 255, and a little. What deforms vertices divides by the sum.
constexpr float weightSumTolerance = 0.01f;

/// The largest colour channel of an environment's picture.
float largestRadiance(const Image& picture);

/// Whether the last row is 0, 0, 0, 1.
bool isAffine(const glm::mat4& matrix);

/// Whether `direction` has a length of 1 within `unitTolerance`.
bool isUnit(const glm::vec3& direction);

// Each checks one element and throws `Error` (badInput) that names it.

void validateImage(const Image& image, const ErrorContext& element);
void validateMaterial(const Material& material, const Scene& scene, const ErrorContext& element);
/// All but which of the skin's joints it names: see `validateDeformations`.
void validateMesh(const Mesh& mesh, const Scene& scene, const ErrorContext& element);
/// All but which of the skin's joints it names: see `validateDeformations`.
void validateCage(const Cage& cage, const Scene& scene, const ErrorContext& element);
/// The part of `validateCage` that needs no scene: all but the materials.
void validateCageSurface(const Cage& cage, const ErrorContext& element);
void validateSkin(const Skin& skin, const Scene& scene, const ErrorContext& element);
void validateNode(const Node& node, std::size_t index, const Scene& scene, const ErrorContext& element);
void validateCamera(const Camera& camera, const Scene& scene, const ErrorContext& element);
void validateLight(const Light& light, const Scene& scene, const ErrorContext& element);
void validateEnvironment(const Environment& environment);
/// The part of `validateEnvironment` beside the picture; `largest` is its `largestRadiance`.
void validateEnvironmentSettings(const EnvironmentSettings& settings, float largest,
                                 const ErrorContext& element);
void validateAnimation(const Animation& animation, const Scene& scene, const ErrorContext& element);

/// That the meshes and cages of all nodes fit the nodes' skins and morph weights. All of these have passed.
void validateDeformations(const Scene& scene);
/// The world positions at time 0. All else has passed.
void validatePositions(const Scene& scene);

/// That the indices of a mesh name vertices of the mesh, at most 2^32 - 1 of each, and are whole triangles in
/// a mesh of nothing else.
void requireIndices(const Mesh& mesh, const ErrorContext& element);

/// That joints, joint weights and morph targets have as many elements as the vertices require, and that their
/// numbers are in range.
void requireInfluences(const DeformableVertices& shape, const ErrorContext& element);
void requireMorphTargets(const DeformableVertices& shape, const ErrorContext& element);

/// That the positions, texture coordinates, faces and holes of a cage fit together.
void requireFaces(const Cage& cage, const ErrorContext& element);

/// Requires that a channel of an animation names a node that has the animated property, and has as many
/// values as its keys require. The values are not read.
void requireChannel(const AnimationChannel& channel, std::size_t index, const Scene& scene,
                    const ErrorContext& animation);
/// The same of a channel of a property: its element exists and has the property.
void requireChannel(const PropertyChannel& channel, std::size_t index, const Scene& scene,
                    const ErrorContext& animation);

/// That a time, in seconds, is finite.
void requireTime(double time);

/// That `world` has one matrix per node.
void requireWorldMatrices(const Scene& scene, const std::vector<glm::mat4>& world);

/// glTF 2.0, 5.30.2: an element must have the texture coordinates that its material's textures name.
void requireUvs(UvSets sets, std::uint32_t material, const Scene& scene, const ErrorContext& element);

}  // namespace candela
