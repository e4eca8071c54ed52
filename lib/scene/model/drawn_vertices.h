#pragma once

#include "scene/model/deformation.h"
#include "scene/model/frame_callback.h"

#include <candela/scene.h>

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace candela {

/// The vertices that the faces of a mesh or a cage use.
struct UsedVertices {
    std::size_t count = 0;
    std::vector<std::uint32_t> indices;  ///< Empty where all vertices are used.
};

/// The vertices of what the nodes of a scene show. What is found of a mesh or a cage is kept for its other
/// nodes. The scene has to outlive the object, and `world` comes from `worldTransforms` of `time`.
class DrawnVertices {
  public:
    explicit DrawnVertices(const Scene& scene)
        : scene_(scene), meshes_(scene.meshes.size()), cages_(scene.cages.size()) {}

    /// Calls `visit` with the place of each vertex that node `node` itself shows, in world space. The node
    /// and what it refers to exist.
    template <typename Visit>
    void forEach(std::uint32_t node, const std::vector<glm::mat4>& world, double time, const Visit& visit) {
        const Node& element = scene_.nodes[node];
        if (element.mesh) {
            const Mesh& mesh = scene_.meshes[*element.mesh];
            const UsedVertices& used = ofMesh(*element.mesh);
            if (candela::isDeformed(element, mesh) || movesMesh(scene_, *element.mesh)) {
                visitPosed(poseMesh(scene_, node, world, time), used, visit);
            } else if (spansAPlane(world[node])) {
                visitPoints(mesh.positions, used, world[node], visit);
            }
        }
        if (element.cage) visitPosed(poseCage(scene_, node, world, time), ofCage(*element.cage), visit);
    }

    /// The number of vertices that `forEach` visits at most.
    std::size_t count(std::uint32_t node);

    /// Whether the points of the mesh or the cage of node `node` move in its own frame.
    bool isDeformed(std::uint32_t node) const;

  private:
    const UsedVertices& ofMesh(std::uint32_t mesh);
    const UsedVertices& ofCage(std::uint32_t cage);
    /// Whether a matrix leaves surfaces a size: not if it flattens space to a line or a point.
    static bool spansAPlane(const glm::mat4& matrix);

    template <typename Visit>
    static void visitPosed(const PosedPoints& posed, const UsedVertices& used, const Visit& visit) {
        if (spansAPlane(posed.worldFromPoints)) visitPoints(posed.points, used, posed.worldFromPoints, visit);
    }
    template <typename Visit>
    static void visitPoints(const std::vector<glm::vec3>& points, const UsedVertices& used,
                            const glm::mat4& worldFromPoints, const Visit& visit) {
        const auto place = [&](const glm::vec3& point) {
            visit(glm::vec3(worldFromPoints * glm::vec4(point, 1.0f)));
        };
        if (used.count == points.size()) {
            for (const glm::vec3& point : points) place(point);
        } else {
            for (const std::uint32_t index : used.indices) place(points[index]);
        }
    }

    const Scene& scene_;
    std::vector<std::optional<UsedVertices>> meshes_, cages_;
};

}  // namespace candela
