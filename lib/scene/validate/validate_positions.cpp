#include "base/error_context.h"
#include "base/runs.h"
#include "scene/model/deformation.h"
#include "scene/model/frame_callback.h"
#include "scene/validate/scene_rules.h"

#include <glm/common.hpp>

#include <cmath>
#include <cstddef>
#include <mutex>
#include <vector>

namespace candela {

namespace {

constexpr const char* tooFar =
    "is farther than 1e9 metres from the world's origin, or its position is not finite";

bool isNear(const glm::vec3& position) {
    for (int i = 0; i < 3; ++i) {
        if (!(std::abs(position[i]) <= maxCoordinate)) return false;
    }
    return true;
}

Bounds ownBounds(const std::vector<glm::vec3>& points) {
    Bounds box;
    std::mutex mutex;
    inRuns(points.size(), [&](std::size_t first, std::size_t end) {
        Bounds part;
        for (std::size_t i = first; i < end; ++i) {
            part.min = glm::min(part.min, points[i]);
            part.max = glm::max(part.max, points[i]);
        }
        const std::lock_guard lock(mutex);
        box.add(part);
    });
    return box;
}

bool areNear(const std::vector<glm::vec3>& points, const glm::mat4& world) {
    for (const glm::vec3& point : points) {
        if (!isNear(glm::vec3(world * glm::vec4(point, 1.0f)))) return false;
    }
    return true;
}

// Points that several nodes may instance, and their box, which usually replaces a test of each point.
class BoxedPoints {
  public:
    BoxedPoints(const std::vector<glm::vec3>& points, const Bounds& box) : points_(points), box_(box) {}

    bool areNear(const glm::mat4& world) const {
        return points_.empty() || boxIsNear(world) || candela::areNear(points_, world);
    }

  private:
    bool boxIsNear(const glm::mat4& world) const {
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec4 position((corner & 1) != 0 ? box_.max.x : box_.min.x,
                                     (corner & 2) != 0 ? box_.max.y : box_.min.y,
                                     (corner & 4) != 0 ? box_.max.z : box_.min.z, 1.0f);
            if (!isNear(glm::vec3(world * position))) return false;
        }
        return true;
    }

    const std::vector<glm::vec3>& points_;
    Bounds box_;
};

/// The positions of meshes or cages, each with its box.
template <typename Shape>
std::vector<BoxedPoints> boxed(const std::vector<Shape>& shapes) {
    std::vector<Bounds> boxes(shapes.size());
    forEachElement(
        shapes.size(), [&](std::size_t i) { return shapes[i].positions.size(); },
        [&](std::size_t i) { boxes[i] = ownBounds(shapes[i].positions); });
    std::vector<BoxedPoints> points;
    points.reserve(shapes.size());
    for (std::size_t i = 0; i < shapes.size(); ++i) points.emplace_back(shapes[i].positions, boxes[i]);
    return points;
}

void validateMeshPositions(const Scene& scene, const std::vector<glm::mat4>& world) {
    const std::vector<BoxedPoints> meshes = boxed(scene.meshes);
    const auto stands = [&](std::uint32_t i) {
        const Node& node = scene.nodes[i];
        const Mesh& mesh = scene.meshes[*node.mesh];
        if (!isDeformed(node, mesh) && !movesMesh(scene, *node.mesh))
            return meshes[*node.mesh].areNear(world[i]);
        const PosedPoints posed = poseMesh(scene, i, world);
        return areNear(posed.points, posed.worldFromPoints);
    };
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        if (!node.mesh || stands(i)) continue;
        const ErrorContext mesh("mesh", *node.mesh, scene.meshes[*node.mesh].name);
        ErrorContext("node", i, node.name).refuse(mesh.label() + " " + tooFar);
    }
}

void validateCagePositions(const Scene& scene, const std::vector<glm::mat4>& world) {
    const std::vector<BoxedPoints> cages = boxed(scene.cages);
    const auto stands = [&](std::uint32_t node) {
        const Cage& cage = scene.cages[*scene.nodes[node].cage];
        if (!isDeformed(scene.nodes[node], cage) && !movesCage(scene, *scene.nodes[node].cage))
            return cages[*scene.nodes[node].cage].areNear(world[node]);
        const PosedPoints posed = poseCage(scene, node, world);
        return areNear(posed.points, posed.worldFromPoints);
    };
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        if (!node.cage || stands(i)) continue;
        const ErrorContext cage("cage", *node.cage, scene.cages[*node.cage].name);
        ErrorContext("node", i, node.name).refuse(cage.label() + " " + tooFar);
    }
}

}  // namespace

void validatePositions(const Scene& scene) {
    const std::vector<glm::mat4> world = worldTransforms(scene);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        ErrorContext("node", i, scene.nodes[i].name)
            .require(allFinite(world[i]), "its matrix in the world is not finite");
    }
    validateMeshPositions(scene, world);
    validateCagePositions(scene, world);
    const std::vector<WorldLight> lights = worldLights(scene, world);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const bool placed = lights[i].type == LightType::directional || isNear(lights[i].position);
        ErrorContext("light", i, scene.lights[i].name).require(placed, tooFar);
    }
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        const Camera& camera = scene.cameras[i];
        ErrorContext("camera", i, camera.name)
            .require(!camera.node || isNear(glm::vec3(world[*camera.node][3])), tooFar);
    }
}

}  // namespace candela
