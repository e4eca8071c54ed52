// Edits of the nodes of a GpuScene.

#include "render/gpu_scene/gpu_scene_state.h"
#include "scene/validate/scene_rules.h"

#include <candela/error.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace candela {

void GpuScene::State::setTransforms(std::span<const NodeTransform> nodeTransforms) {
    for (const NodeTransform& transform : nodeTransforms) {
        const std::uint32_t node = nodeSlots.indexOf(transform.node);
        const ErrorContext context = nodeContext(node);
        context.require(allFinite(transform.local), "its matrix must be finite numbers");
        context.require(isAffine(transform.local), "its matrix must be affine: a last row of 0, 0, 0, 1");
    }
    for (const NodeTransform& transform : nodeTransforms)
        transforms.setLocal(transform.node.index, transform.local);
}

void GpuScene::State::setVisibilities(std::span<const NodeVisibility> visibilities) {
    for (const NodeVisibility& visibility : visibilities) nodeSlots.indexOf(visibility.node);
    for (const NodeVisibility& visibility : visibilities)
        setVisibility(visibility.node.index, visibility.visibility);
}

void GpuScene::State::requireNode(const Node& node, std::uint32_t index, const ErrorContext& element) const {
    validateNode(node, index, sceneState, element);
    nodeSlots.requireAlive(node.parent, element);
    meshSlots.requireAlive(node.mesh, element);
    const auto isZero = [](float weight) { return weight == 0.0f; };
    const bool hasWeights = !std::ranges::all_of(node.morphWeights, isZero);
    if (node.cage && (node.skin || hasWeights))
        element.refuse("a node that is added can not show a deformed cage", ErrorKind::unsupported);
    element.requireEach("morph weight", node.morphWeights, "must be a finite number of at most 1e9",
                        [](float weight) { return std::abs(weight) <= maxAnimated; });
    if (node.cage && !node.morphWeights.empty())
        element.requireCount("morph weights", node.morphWeights.size(), "morph targets",
                             sceneState.cages[*node.cage].morphTargets.size());
    if (!node.mesh) {
        element.require(!node.skin, "has a skin, but no mesh");
        return;
    }
    const MeshParts& parts = meshParts[*node.mesh];
    if (!node.morphWeights.empty())
        element.requireCount("morph weights", node.morphWeights.size(), "morph targets",
                             parts.morphTargetCount);
    if (node.skin) {
        element.require(parts.jointCount > 0, "has a skin, but no joint moves a vertex of its mesh");
        element.require(parts.jointCount <= sceneState.skins[*node.skin].joints.size(),
                        "its mesh names a joint that its skin does not have");
    }
    if ((node.skin || hasWeights) && !deformations.keeps(*node.mesh))
        element.refuse("no node of the scene that was uploaded shows its mesh deformed: it can not be now",
                       ErrorKind::unsupported);
}

/// Makes the place of a new node.
void GpuScene::State::appendNode(std::uint32_t index) {
    if (index < sceneState.nodes.size()) return;
    sceneState.nodes.emplace_back();
    instances.addNode();
    isHidden_.push_back(false);
    isVisible_.push_back(true);
}

NodeHandle GpuScene::State::addNode(const Node& node) {
    const std::uint32_t index = nodeSlots.next(node.parent);
    requireNode(node, index, ErrorContext("node", index, node.name));
    appendNode(index);
    if (node.mesh) prepareDraws(meshParts[*node.mesh]);
    if (node.cage) prepareDraws(cages.tables(*node.cage).materials());
    nodeSlots.add(node.parent);
    sceneState.nodes[index] = node;
    if (node.mesh) showMesh(index, *node.mesh);
    if (node.cage) showCage(index);
    isVisible_[index] = node.visible && (!node.parent || isVisible_[*node.parent]);
    transforms.add(index);
    applyVisibility(index);
    return {index, nodeSlots.generation(index)};
}

void GpuScene::State::showMesh(std::uint32_t node, std::uint32_t mesh) {
    const MeshParts& parts = meshParts[mesh];
    const auto elementsOf = parts.hasOnlyTriangles() ? GpuInstances::Elements::trianglesOnly
                                                     : GpuInstances::Elements::linesOrPoints;
    const std::uint32_t instance = instances.addMesh(node, mesh, elementsOf);
    DrawGeometry geometry;
    MeshPlace place = meshes.places()[mesh];
    const std::vector<float>& weights = sceneState.nodes[node].morphWeights;
    const bool isMorphed = std::ranges::any_of(weights, [](float weight) { return weight != 0.0f; });
    if (sceneState.nodes[node].skin || isMorphed) {
        geometry = {DrawGeometry::Kind::deformedMesh, deformations.add(node)};
        deformations.describe(geometry.index, meshes, draws.records(), defaultDetail_);
        place.baseVertex = 0;
    }
    draws.addMesh(instance, geometry, mesh, parts, place, sceneState.materials, images);
    ++meshUsers_[mesh];
    countElements(parts, 1);
}

void GpuScene::State::hideMesh(std::uint32_t node) {
    const std::uint32_t instance = *instances.meshOf(node), mesh = *instances[instance].mesh;
    draws.remove(instance);
    if (const std::optional<std::uint32_t> deformed = deformations.ofNode(node))
        deformations.remove(*deformed);
    instances.removeMesh(node);
    --meshUsers_[mesh];
    countElements(meshParts[mesh], -1);
}

void GpuScene::State::countElements(const MeshParts& parts, int sign) {
    for (const Topology topology : {Topology::triangles, Topology::lines, Topology::points}) {
        const std::uint64_t count = parts.elements(topology);
        elements[static_cast<std::size_t>(topology)] += sign > 0 ? count : ~count + 1;
    }
}

void GpuScene::State::removeNode(std::uint32_t root) {
    std::vector<std::uint32_t> removed{root};
    for (std::size_t i = 0; i < removed.size(); ++i)
        transforms.forEachChild(removed[i], [&](std::uint32_t child) { removed.push_back(child); });
    for (const std::uint32_t node : removed) {
        const ErrorContext context = nodeContext(node);
        for (std::size_t skin = 0; skin < sceneState.skins.size(); ++skin) {
            const auto& joints = sceneState.skins[skin].joints;
            if (std::ranges::find(joints, node) != joints.end())
                context.refuse("is a joint of skin " + std::to_string(skin) + " and can not be removed");
        }
    }
    // Children before parents.
    for (auto node = removed.rbegin(); node != removed.rend(); ++node) eraseNode(*node);
}

void GpuScene::State::eraseNode(std::uint32_t node) {
    if (node < nodeLights_.size()) {
        for (const std::uint32_t light : std::vector(nodeLights_[node])) removeLight(light);
    }
    if (instances.meshOf(node)) hideMesh(node);
    if (instances.cageOf(node)) hideCage(node);
    nodeTracks_.remove(node);
    sceneState.nodes[node] = {};
    transforms.remove(node);
    isHidden_[node] = false;
    isVisible_[node] = true;
    nodeSlots.remove(node);
}

}  // namespace candela
