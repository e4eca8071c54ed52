#include <candela/scene.h>

#include "scene/model/animation.h"
#include "scene/validate/scene_rules.h"

#include <candela/error.h>

#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace candela {

namespace {

glm::mat4 matrixOf(const Transform& transform) {
    const float length = glm::length(transform.rotation);
    // Files round quaternions; a rotation of another length would scale and shear.
    const glm::quat rotation =
        length > 0.0f ? transform.rotation / length : glm::quat(1.0f, 0.0f, 0.0f, 0.0f);
    glm::mat4 matrix = glm::mat4_cast(rotation);
    for (int axis = 0; axis < 3; ++axis) matrix[axis] *= transform.scale[axis];
    matrix[3] = glm::vec4(transform.translation, 1.0f);
    return matrix;
}

}  // namespace

glm::mat4 localMatrix(const std::variant<Transform, glm::mat4>& transform) {
    if (const auto* parts = std::get_if<Transform>(&transform)) return matrixOf(*parts);
    return std::get<glm::mat4>(transform);
}

std::vector<glm::mat4> worldTransforms(const Scene& scene, double time) {
    requireTime(time);
    const std::vector<PosedNode> posed = poseAnimatedNodes(scene, time);
    std::vector<glm::mat4> world(scene.nodes.size());
    auto pose = posed.begin();
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        ErrorContext("node", i, node.name)
            .require(!node.parent || *node.parent < i, "its parent must precede it");
        const bool animated = pose != posed.end() && pose->node == i;
        const glm::mat4 local = animated ? matrixOf((pose++)->transform) : localMatrix(node.transform);
        world[i] = node.parent ? world[*node.parent] * local : local;
    }
    return world;
}

std::uint64_t triangleCount(const Mesh& mesh) {
    if (mesh.submeshes.empty()) return mesh.indices.size() / 3;
    std::uint64_t count = 0;
    for (const Submesh& submesh : mesh.submeshes) count += submesh.indexCount / 3;
    return count;
}

std::uint64_t triangleCount(const Scene& scene) {
    std::vector<std::uint64_t> ofMesh;
    ofMesh.reserve(scene.meshes.size());
    for (const Mesh& mesh : scene.meshes) ofMesh.push_back(triangleCount(mesh));
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        ErrorContext("node", i, node.name).requireIndex("mesh", node.mesh, scene.meshes.size());
        if (node.mesh) count += ofMesh[*node.mesh];
    }
    return count;
}

}  // namespace candela
