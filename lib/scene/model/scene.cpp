#include <candela/scene.h>

#include "scene/geometry/topology.h"
#include "scene/model/animation.h"
#include "scene/model/deformation.h"
#include "scene/model/frame_callback.h"
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

glm::dvec3 exactTranslation(const Node& node) {
    const auto* parts = std::get_if<Transform>(&node.transform);
    const glm::vec3 translation =
        parts ? parts->translation : glm::vec3(std::get<glm::mat4>(node.transform)[3]);
    return glm::dvec3(translation) + node.translationRemainder;
}

glm::dmat4 exactLocalMatrix(const std::variant<Transform, glm::mat4>& transform,
                            const glm::dvec3& translation) {
    glm::dmat4 matrix(1.0);
    if (const auto* parts = std::get_if<Transform>(&transform)) {
        const glm::dquat quaternion(parts->rotation);
        const double length = glm::length(quaternion);
        if (length > 0.0) matrix = glm::mat4_cast(quaternion / length);
        for (int axis = 0; axis < 3; ++axis) matrix[axis] *= static_cast<double>(parts->scale[axis]);
    } else {
        matrix = glm::dmat4(std::get<glm::mat4>(transform));
    }
    matrix[3] = glm::dvec4(translation, 1.0);
    return matrix;
}

namespace {

/// For each node the local matrix that the frame callback gives it; null: none. Empty where it gives none.
std::vector<const glm::dmat4*> givenMatrices(const Scene& scene, const SceneUpdate* update) {
    if (!update || update->nodes.empty()) return {};
    std::vector<const glm::dmat4*> given(scene.nodes.size(), nullptr);
    for (const SceneUpdate::NodeMatrix& node : update->nodes) {
        ErrorContext("frame callback").requireIndex("node", node.node, scene.nodes.size());
        given[node.node] = &node.local;
    }
    return given;
}

std::vector<glm::mat4> farWorldTransforms(const Scene& scene, const std::vector<PosedNode>& posed,
                                          const std::vector<const glm::dmat4*>& given) {
    std::vector<glm::dmat4> exact(scene.nodes.size());
    std::vector<glm::mat4> world(scene.nodes.size());
    auto pose = posed.begin();
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        const bool animated = pose != posed.end() && pose->node == i;
        glm::dmat4 local = animated ? exactLocalMatrix(pose->transform, pose->translation)
                                    : exactLocalMatrix(node.transform, exactTranslation(node));
        if (animated) ++pose;
        if (!given.empty() && given[i]) local = *given[i];
        exact[i] = node.parent ? exact[*node.parent] * local : exactRootMatrix(scene, local);
        world[i] = glm::mat4(exact[i]);
    }
    return world;
}

}  // namespace

std::vector<glm::mat4> worldTransforms(const Scene& scene, double time) {
    requireTime(time);
    const std::vector<PosedNode> posed = poseAnimatedNodes(scene, time);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        ErrorContext("node", i, scene.nodes[i].name)
            .require(!scene.nodes[i].parent || *scene.nodes[i].parent < i, "its parent must precede it");
    }
    const std::shared_ptr<const SceneUpdate> update = updateAt(scene, time);
    const std::vector<const glm::dmat4*> given = givenMatrices(scene, update.get());
    if (isFar(scene)) return farWorldTransforms(scene, posed, given);
    std::vector<glm::mat4> world(scene.nodes.size());
    auto pose = posed.begin();
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        const bool animated = pose != posed.end() && pose->node == i;
        glm::mat4 local = animated ? matrixOf((pose++)->transform) : localMatrix(node.transform);
        if (!given.empty() && given[i]) local = glm::mat4(*given[i]);
        world[i] = node.parent ? world[*node.parent] * local : local;
    }
    return world;
}

std::uint64_t triangleCount(const Mesh& mesh) {
    std::uint64_t count = 0;
    forEachTriangleRun(mesh, [&](std::size_t, std::size_t indices) { count += indices / 3; });
    return count;
}

namespace {

std::uint64_t elementCount(const Mesh& mesh, Topology topology) {
    if (topology == Topology::triangles) return triangleCount(mesh);
    std::uint64_t count = 0;
    for (const Submesh& submesh : mesh.submeshes) {
        if (submesh.topology == topology) count += submesh.indexCount / cornersOf(topology);
    }
    return count;
}

}  // namespace

std::uint64_t triangleCount(const Scene& scene) {
    return elementCount(scene, Topology::triangles);
}

std::uint64_t elementCount(const Scene& scene, Topology topology) {
    std::vector<std::uint64_t> ofMesh;
    ofMesh.reserve(scene.meshes.size());
    for (const Mesh& mesh : scene.meshes) ofMesh.push_back(elementCount(mesh, topology));
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        ErrorContext("node", i, node.name).requireIndex("mesh", node.mesh, scene.meshes.size());
        if (node.mesh) count += ofMesh[*node.mesh];
    }
    return count;
}

}  // namespace candela
