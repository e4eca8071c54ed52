#include "base/error_context.h"
#include "base/runs.h"
#include "scene/validate/scene_rules.h"

#include <candela/scene.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

void validateTransform(const Transform& transform, const ErrorContext& element) {
    element.require(allFinite(transform.translation), "its translation must be finite numbers");
    element.require(allFinite(transform.scale), "its scale must be finite numbers");
    const float length = glm::length(transform.rotation);
    element.require(std::abs(length - 1.0f) <= unitTolerance,
                    "its rotation must be a quaternion of unit length");
}

void validateMeshes(const Scene& scene) {
    const auto sizeOf = [&](std::size_t i) {
        return std::max(scene.meshes[i].positions.size(), scene.meshes[i].indices.size());
    };
    forEachElement(scene.meshes.size(), sizeOf, [&](std::size_t i) {
        validateMesh(scene.meshes[i], scene, ErrorContext("mesh", i, scene.meshes[i].name));
    });
}

bool isPositive(float number) {
    return number > 0.0f && std::isfinite(number);
}

void validateMatrix(const glm::mat4& matrix, const ErrorContext& element) {
    element.require(allFinite(matrix), "its matrix must be finite numbers");
    element.require(isAffine(matrix), "its matrix must be affine: a last row of 0, 0, 0, 1");
}

}  // namespace

void validateNode(const Node& node, std::size_t index, const Scene& scene, const ErrorContext& element) {
    element.requireIndex("node", node.parent, scene.nodes.size());
    element.require(!node.parent || *node.parent < index, "its parent must precede it");
    element.requireIndex("mesh", node.mesh, scene.meshes.size());
    element.require(allFinite(node.translationRemainder),
                    "the remainder of its translation must be finite numbers");
    element.requireIndex("cage", node.cage, scene.cages.size());
    element.requireIndex("skin", node.skin, scene.skins.size());
    if (const auto* transform = std::get_if<Transform>(&node.transform)) {
        validateTransform(*transform, element);
    } else {
        validateMatrix(std::get<glm::mat4>(node.transform), element);
    }
}

void validateCamera(const Camera& camera, const Scene& scene, const ErrorContext& element) {
    element.requireIndex("node", camera.node, scene.nodes.size());
    element.require(camera.verticalFov > 0.0f && camera.verticalFov < std::numbers::pi_v<float>,
                    "its vertical field of view must lie between 0 and pi");
    const bool orthographic = camera.orthographicHeight.has_value();
    element.require(!orthographic || isPositive(*camera.orthographicHeight),
                    "its orthographic height must be over 0 metres");
    const float nearPlane = camera.nearPlane.value_or(0.0f);
    element.require(!camera.nearPlane || isPositive(nearPlane) || (orthographic && nearPlane == 0.0f),
                    "its near plane must be over 0 metres");
    element.require(!camera.farPlane || (*camera.farPlane > nearPlane && isPositive(*camera.farPlane)),
                    "its far plane must be beyond its near plane");
}

void validateLight(const Light& light, const Scene& scene, const ErrorContext& element) {
    element.requireIndex("node", light.node, scene.nodes.size());
    element.require(light.type == LightType::point || light.type == LightType::spot ||
                        light.type == LightType::directional,
                    "its type must be point, spot or directional");
    element.requireWithin("its intensity", light.intensity, 0.0f, maxIntensity);
    for (int i = 0; i < 3; ++i) {
        element.require(light.color[i] >= 0.0f && std::isfinite(light.color[i]),
                        "its colour must be finite numbers, 0 or more");
        element.require(light.color[i] * light.intensity <= maxIntensity,
                        "its intensity times its colour must be at most 1e20");
    }
    element.require(!light.range || (*light.range > 0.0f && std::isfinite(*light.range)),
                    "its range must be over 0 metres");
    element.require(light.radius >= 0.0f && std::isfinite(light.radius),
                    "its radius must be 0 or more metres");
    element.require(allFinite(light.position), "its position must be finite numbers");
    if (light.type == LightType::point) return;
    element.require(isUnit(light.direction), "its direction must have unit length");
    if (light.type == LightType::directional) return;
    element.requireWithin("its outer cone angle", light.outerConeAngle, 0.0f,
                          std::numbers::pi_v<float> / 2.0f);
    element.require(light.innerConeAngle >= 0.0f && light.innerConeAngle < light.outerConeAngle,
                    "its inner cone angle must be 0 or more and less than the outer one");
}

bool isAffine(const glm::mat4& matrix) {
    return matrix[0][3] == 0.0f && matrix[1][3] == 0.0f && matrix[2][3] == 0.0f && matrix[3][3] == 1.0f;
}

bool isUnit(const glm::vec3& direction) {
    // False for a NaN; an infinite or huge length is too far from 1.
    return std::abs(glm::length(direction) - 1.0f) <= unitTolerance;
}

void requireTime(double time) {
    if (!std::isfinite(time)) throw Error(ErrorKind::badInput, {}, "the time must be a finite number");
}

void requireWorldMatrices(const Scene& scene, const std::vector<glm::mat4>& world) {
    ErrorContext("scene").requireCount("world matrices", world.size(), "nodes", scene.nodes.size());
}

void validate(const Scene& scene) {
    for (int axis = 0; axis < 3; ++axis)
        ErrorContext("scene").requireWithin("its origin", scene.origin[axis], -maxCoordinate, maxCoordinate);
    for (std::size_t i = 0; i < scene.images.size(); ++i) {
        validateImage(scene.images[i], ErrorContext("image", i, scene.images[i].name));
    }
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        validateMaterial(scene.materials[i], scene, ErrorContext("material", i, scene.materials[i].name));
    }
    validateMeshes(scene);
    for (std::size_t i = 0; i < scene.cages.size(); ++i) {
        validateCage(scene.cages[i], scene, ErrorContext("cage", i, scene.cages[i].name));
    }
    for (std::size_t i = 0; i < scene.skins.size(); ++i) {
        validateSkin(scene.skins[i], scene, ErrorContext("skin", i, scene.skins[i].name));
    }
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        validateNode(scene.nodes[i], i, scene, ErrorContext("node", i, scene.nodes[i].name));
    }
    validateDeformations(scene);
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        validateCamera(scene.cameras[i], scene, ErrorContext("camera", i, scene.cameras[i].name));
    }
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        validateLight(scene.lights[i], scene, ErrorContext("light", i, scene.lights[i].name));
    }
    for (std::size_t i = 0; i < scene.animations.size(); ++i) {
        validateAnimation(scene.animations[i], scene, ErrorContext("animation", i, scene.animations[i].name));
    }
    if (scene.environment) validateEnvironment(*scene.environment);
    validatePositions(scene);
}

}  // namespace candela
