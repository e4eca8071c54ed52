#include <candela/scene.h>

#include "scene/model/animation.h"

#include <candela/error.h>

#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cassert>
#include <cmath>

namespace candela {

namespace {

glm::mat4 matrixOf(const Transform& trs) {
    const float length = glm::length(trs.rotation);
    // Files round quaternions; a rotation of another length would scale and shear.
    const glm::quat rotation = length > 0.0f ? trs.rotation / length : glm::quat(1.0f, 0.0f, 0.0f, 0.0f);
    glm::mat4 matrix = glm::mat4_cast(rotation);
    for (int axis = 0; axis < 3; ++axis) matrix[axis] *= trs.scale[axis];
    matrix[3] = glm::vec4(trs.translation, 1.0f);
    return matrix;
}

void enclose(const std::vector<glm::vec3>& points, const glm::mat4& worldFromPoints, Bounds& bounds) {
    for (const glm::vec3& point : points) {
        const glm::vec3 placed(worldFromPoints * glm::vec4(point, 1.0f));
        bounds.min = glm::min(bounds.min, placed);
        bounds.max = glm::max(bounds.max, placed);
    }
}

}  // namespace

glm::mat4 localMatrix(const std::variant<Transform, glm::mat4>& transform) {
    if (const Transform* trs = std::get_if<Transform>(&transform)) return matrixOf(*trs);
    return std::get<glm::mat4>(transform);
}

void Bounds::add(const Bounds& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
}

std::vector<glm::mat4> worldTransforms(const Scene& scene, double time) {
    if (!std::isfinite(time)) throw Error(ErrorKind::badInput, {}, "the time must be a finite number");
    const std::vector<PosedNode> posed = poseAnimatedNodes(scene, time);
    std::vector<glm::mat4> world(scene.nodes.size());
    auto pose = posed.begin();
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        const bool animated = pose != posed.end() && pose->node == i;
        const glm::mat4 local = animated ? matrixOf((pose++)->trs) : localMatrix(node.transform);
        assert(!node.parent || *node.parent < i);
        world[i] = node.parent ? world[*node.parent] * local : local;
    }
    return world;
}

Bounds nodeBounds(const Scene& scene, std::uint32_t node, const std::vector<glm::mat4>& world, double time) {
    assert(world.size() == scene.nodes.size());
    const Node& shown = scene.nodes[node];
    Bounds bounds;
    if (shown.mesh) enclose(scene.meshes[*shown.mesh].positions, world[node], bounds);
    if (shown.cage) {
        const PosedCage posed = poseCage(scene, node, world, time);
        enclose(posed.points, posed.worldFromPoints, bounds);
    }
    return bounds;
}

Bounds worldBounds(const Scene& scene, const std::vector<glm::mat4>& world, double time) {
    Bounds bounds;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) bounds.add(nodeBounds(scene, i, world, time));
    return bounds;
}

std::uint64_t triangleCount(const Scene& scene) {
    std::vector<std::uint64_t> ofMesh(scene.meshes.size());
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        const Mesh& mesh = scene.meshes[i];
        if (mesh.submeshes.empty()) ofMesh[i] = mesh.indices.size() / 3;
        for (const Submesh& submesh : mesh.submeshes) ofMesh[i] += submesh.indexCount / 3;
    }
    std::uint64_t count = 0;
    for (const Node& node : scene.nodes) {
        if (node.mesh) count += ofMesh[*node.mesh];
    }
    return count;
}

}  // namespace candela
