#include "base/error_context.h"
#include "base/thread_pool.h"
#include "import/abi_import.h"
#include "scene/model/animation.h"
#include "scene/model/deformation.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace candela {
namespace {

/// A float is off by half a millimetre there.
constexpr double maxDistance = 8192.0;
constexpr double maxDistanceInSizes = 100.0;

/// Of the vertices of a mesh or a cage so many are looked at.
constexpr std::size_t maxSamples = 1024;

/// Where something stands, and how far it reaches around that.
struct Place {
    glm::dvec3 center{0.0};
    double radius = 0.0;
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// The median of the centers along each axis, and of the reaches: outliers do not move them.
Place middleOf(const std::vector<Place>& places) {
    Place middle;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (const Place& place : places) values.push_back(place.center[axis]);
        middle.center[axis] = median(std::move(values));
    }
    std::vector<double> reaches;
    for (const Place& place : places)
        reaches.push_back(glm::distance(place.center, middle.center) + place.radius);
    middle.radius = median(std::move(reaches));
    return middle;
}

/// The place of the vertices that faces use, in their own frame; none without faces.
std::optional<Place> placeOf(const std::vector<glm::vec3>& points, const std::vector<std::uint32_t>& used) {
    const std::size_t step = (used.size() + maxSamples - 1) / maxSamples;
    std::vector<Place> samples;
    for (std::size_t i = 0; i < used.size(); i += step) {
        if (used[i] >= points.size()) continue;  // `validate` refuses it.
        const glm::dvec3 point(points[used[i]]);
        if (allFinite(point)) samples.push_back({point, 0.0});
    }
    if (samples.empty()) return std::nullopt;
    return middleOf(samples);
}

Place placed(const Place& place, const glm::dmat4& world) {
    double stretch = 0.0;
    for (int axis = 0; axis < 3; ++axis) stretch = std::max(stretch, glm::length(glm::dvec3(world[axis])));
    return {glm::dvec3(world * glm::dvec4(place.center, 1.0)), stretch * place.radius};
}

std::vector<glm::dmat4> fileMatrices(const Scene& scene) {
    std::vector<glm::dmat4> world(scene.nodes.size());
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        const glm::dmat4 local = exactLocalMatrix(node.transform, exactTranslation(node));
        world[i] = node.parent ? world[*node.parent] * local : local;
    }
    return world;
}

std::vector<Place> placesOf(const Scene& scene) {
    std::vector<std::optional<Place>> meshes(scene.meshes.size()), cages;
    const std::shared_ptr<ThreadPool> pool = ThreadPool::shared();
    pool->run(meshes.size(), [&](std::size_t i, unsigned) {
        meshes[i] = placeOf(scene.meshes[i].positions, scene.meshes[i].indices);
    });
    for (const Cage& cage : scene.cages) cages.push_back(placeOf(cage.positions, cage.faceVertices));
    const std::vector<glm::dmat4> world = fileMatrices(scene);
    std::vector<Place> places;
    const auto add = [&](const std::optional<Place>& place, const glm::dmat4& matrix) {
        if (!place) return;
        const Place there = placed(*place, matrix);
        if (allFinite(there.center) && allFinite(there.radius)) places.push_back(there);
    };
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        // What a skin moves is placed by the joints.
        bool skinned = false;
        const auto addShape = [&](const auto& shape, const std::optional<Place>& place) {
            if (!isSkinned(node, shape)) return add(place, world[i]);
            skinned = true;
        };
        if (node.mesh) addShape(scene.meshes[*node.mesh], meshes[*node.mesh]);
        if (node.cage) addShape(scene.cages[*node.cage], cages[*node.cage]);
        if (!skinned) continue;
        for (const std::uint32_t joint : scene.skins[*node.skin].joints) add(Place{}, world[joint]);
    }
    return places;
}

void moveToWorldSpace(Scene& scene) {
    for (Light& light : scene.lights) {
        if (!light.node) light.position = glm::vec3(glm::dvec3(light.position) - scene.origin);
    }
    std::optional<std::uint32_t> root;
    for (Camera& camera : scene.cameras) {
        if (camera.node) continue;
        if (!root) {
            root = static_cast<std::uint32_t>(scene.nodes.size());
            scene.nodes.emplace_back();
        }
        camera.node = root;
    }
}

}  // namespace

void chooseOrigin(Scene& scene) {
    const std::vector<Place> places = placesOf(scene);
    if (places.empty()) return;
    const auto [middle, size] = middleOf(places);
    const double distance = std::max({std::abs(middle.x), std::abs(middle.y), std::abs(middle.z)});
    const bool isFarAway = distance > maxDistance || (size > 0.0 && distance > maxDistanceInSizes * size);
    if (!isFarAway || !(distance <= 1e9)) return;
    // A number of a float, so that vertices with large coordinates lose no digits when it is subtracted.
    for (int axis = 0; axis < 3; ++axis) scene.origin[axis] = static_cast<float>(middle[axis]);
    moveToWorldSpace(scene);
}

}  // namespace candela
