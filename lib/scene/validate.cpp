#include "scene/finite.h"
#include "scene/limits.h"
#include "scene/validate_parts.h"

#include <candela/scene.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <numbers>

namespace candela {

namespace {

void validateTrs(const Trs& trs, const Element& element) {
    element.require(allFinite(trs.translation), "its translation must be finite numbers");
    element.require(allFinite(trs.scale), "its scale must be finite numbers");
    const float length = glm::length(trs.rotation);
    element.require(std::abs(length - 1.0f) <= unitTolerance,
                    "its rotation must be a quaternion of unit length");
}

void validateMatrix(const glm::mat4& matrix, const Element& element) {
    element.require(allFinite(matrix), "its matrix must be finite numbers");
    const bool affine =
        matrix[0][3] == 0.0f && matrix[1][3] == 0.0f && matrix[2][3] == 0.0f && matrix[3][3] == 1.0f;
    element.require(affine, "its matrix must be affine: a last row of 0, 0, 0, 1");
}

void validateNode(const Node& node, std::size_t index, const Scene& scene, const Element& element) {
    element.requireIndex("node", node.parent, scene.nodes.size());
    element.require(!node.parent || *node.parent < index, "its parent must stand before it");
    element.requireIndex("mesh", node.mesh, scene.meshes.size());
    if (const Trs* trs = std::get_if<Trs>(&node.transform)) {
        validateTrs(*trs, element);
    } else {
        validateMatrix(std::get<glm::mat4>(node.transform), element);
    }
}

void validateCamera(const Camera& camera, const Scene& scene, const Element& element) {
    element.requireIndex("node", camera.node, scene.nodes.size());
    element.require(camera.verticalFov > 0.0f && camera.verticalFov < std::numbers::pi_v<float>,
                    "its vertical field of view must lie between 0 and pi");
    element.require(camera.nearPlane > 0.0f && std::isfinite(camera.nearPlane),
                    "its near plane must be over 0 metres");
}

void validateLight(const Light& light, const Scene& scene, const Element& element) {
    element.requireIndex("node", light.node, scene.nodes.size());
    element.require(light.type == LightType::point || light.type == LightType::spot ||
                        light.type == LightType::directional,
                    "its type must be point, spot or directional");
    element.requireWithin("its intensity", light.intensity, 0.0f, greatestIntensity);
    for (int i = 0; i < 3; ++i) {
        element.require(light.color[i] >= 0.0f && std::isfinite(light.color[i]),
                        "its colour must be finite numbers, 0 or more");
        element.require(light.color[i] * light.intensity <= greatestIntensity,
                        "its intensity times its colour must be at most 1e20");
    }
    element.require(!light.range || (*light.range > 0.0f && std::isfinite(*light.range)),
                    "its range must be over 0 metres");
    element.require(allFinite(light.position), "its position must be finite numbers");
    if (light.type == LightType::point) return;
    element.require(isUnit(light.direction), "its direction must have unit length");
    if (light.type == LightType::directional) return;
    element.requireWithin("its outer cone angle", light.outerConeAngle, 0.0f,
                          std::numbers::pi_v<float> / 2.0f);
    element.require(light.innerConeAngle >= 0.0f && light.innerConeAngle < light.outerConeAngle,
                    "its inner cone angle must be 0 or more and less than the outer one");
}

bool isNear(const glm::vec3& position) {
    for (int i = 0; i < 3; ++i) {
        if (!(std::abs(position[i]) <= farthestCoordinate)) return false;
    }
    return true;
}

// Whether `node` places all vertices near enough; `box` is the mesh's own, and stands for its vertices.
bool isNear(const Mesh& mesh, const Bounds& box, const glm::mat4& node) {
    bool near = true;
    for (int corner = 0; corner < 8 && near; ++corner) {
        const glm::vec4 position((corner & 1) != 0 ? box.max.x : box.min.x,
                                 (corner & 2) != 0 ? box.max.y : box.min.y,
                                 (corner & 4) != 0 ? box.max.z : box.min.z, 1.0f);
        near = isNear(glm::vec3(node * position));
    }
    if (near) return true;
    for (const glm::vec3& position : mesh.positions) {
        if (!isNear(glm::vec3(node * glm::vec4(position, 1.0f)))) return false;
    }
    return true;
}

Bounds ownBounds(const Mesh& mesh) {
    Bounds box;
    for (const glm::vec3& position : mesh.positions) {
        box.min = glm::min(box.min, position);
        box.max = glm::max(box.max, position);
    }
    return box;
}

void validatePlaces(const Scene& scene) {
    constexpr const char* tooFar =
        "stands farther than 1e9 metres from the world's origin, or at no finite place";
    const std::vector<glm::mat4> world = worldTransforms(scene);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        Element("node", i, scene.nodes[i].name)
            .require(allFinite(world[i]), "its matrix in the world is not finite");
    }
    std::vector<Bounds> boxes;
    boxes.reserve(scene.meshes.size());
    for (const Mesh& mesh : scene.meshes) boxes.push_back(ownBounds(mesh));
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        if (!node.mesh || boxes[*node.mesh].empty()) continue;
        const Mesh& mesh = scene.meshes[*node.mesh];
        if (isNear(mesh, boxes[*node.mesh], world[i])) continue;
        Element("node", i, node.name).refuse(Element("mesh", *node.mesh, mesh.name).label() + " " + tooFar);
    }
    const std::vector<PlacedLight> lights = placeLights(scene, world);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const bool placed = lights[i].type == LightType::directional || isNear(lights[i].position);
        Element("light", i, scene.lights[i].name).require(placed, tooFar);
    }
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        const Camera& camera = scene.cameras[i];
        Element("camera", i, camera.name)
            .require(!camera.node || isNear(glm::vec3(world[*camera.node][3])), tooFar);
    }
}

}  // namespace

bool isUnit(const glm::vec3& direction) {
    // False for a NaN; an infinite or huge length is too far from 1.
    return std::abs(glm::length(direction) - 1.0f) <= unitTolerance;
}

void validate(const Scene& scene) {
    for (std::size_t i = 0; i < scene.images.size(); ++i) {
        validateImage(scene.images[i], Element("image", i, scene.images[i].name));
    }
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        validateMaterial(scene.materials[i], scene, Element("material", i, scene.materials[i].name));
    }
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        validateMesh(scene.meshes[i], scene, Element("mesh", i, scene.meshes[i].name));
    }
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        validateNode(scene.nodes[i], i, scene, Element("node", i, scene.nodes[i].name));
    }
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        validateCamera(scene.cameras[i], scene, Element("camera", i, scene.cameras[i].name));
    }
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        validateLight(scene.lights[i], scene, Element("light", i, scene.lights[i].name));
    }
    for (std::size_t i = 0; i < scene.animations.size(); ++i) {
        validateAnimation(scene.animations[i], scene, Element("animation", i, scene.animations[i].name));
    }
    validatePlaces(scene);
}

}  // namespace candela
