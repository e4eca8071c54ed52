// Edits of the cages of a GpuScene.

#include "gl/state_guard.h"
#include "render/gpu_scene/gpu_scene_state.h"
#include "scene/model/frame_callback.h"
#include "scene/validate/scene_rules.h"

#include <candela/error.h>

#include <algorithm>
#include <utility>

namespace candela {

void GpuScene::State::prepareDraws(const CageMaterials& parts) {
    if (draws.isPrepared(parts.materials)) return;
    const gl::StateGuard pixelStorage(*binding, "a GpuScene");
    draws.prepare(parts.materials, sceneState.materials, images);
}

void GpuScene::State::showCage(std::uint32_t node) {
    const std::uint32_t cageInstance = cages.addInstance(node);
    const std::uint32_t instance = instances.addCage(node, cageInstance);
    const std::uint32_t index = cages.instances()[cageInstance].surface;
    const LimitSurface& surface = cages.surface(index);
    draws.addCage(instance, index, surface.tables().materials().materials, sceneState.materials, images);
    // One that others show already has its level.
    if (surface.level()) draws.setRanges(instance, surface.ranges());
}

void GpuScene::State::hideCage(std::uint32_t node) {
    const std::uint32_t instance = *instances.cageOf(node);
    draws.remove(instance);
    cages.removeInstance(instances[instance].cageInstance);
    instances.removeCage(node);
}

void GpuScene::State::requireCage(const Cage& cage, const ErrorContext& element) const {
    validateCage(cage, sceneState, element);
    for (const std::optional<std::uint32_t>& material : cage.faceMaterials)
        materialSlots.requireAlive(material, element);
}

void GpuScene::State::requireStill(std::uint32_t cage, const ErrorContext& element) const {
    element.require(!movesCage(sceneState, cage),
                    "the scene's frame callback moves its vertices: it can not be changed");
}

void GpuScene::State::takeCage(std::uint32_t index, const Cage& cage, std::unique_ptr<CageTables> tables) {
    const Cage before = std::exchange(sceneState.cages[index], cage);
    sceneState.cages[index].variants.clear();
    cages.setTables(index, std::move(tables));
    for (const Cage* changed : {&before, &cage}) {
        std::vector<std::optional<std::uint32_t>> used = changed->faceMaterials;
        std::ranges::sort(used);
        used.erase(std::unique(used.begin(), used.end()), used.end());
        for (const std::optional<std::uint32_t>& material : used) {
            if (material) materials.setCommonUvs(*material, commonUvsOf(*material));
        }
    }
}

std::vector<std::uint32_t> GpuScene::State::nodesOfCage(std::uint32_t index) const {
    std::vector<std::uint32_t> nodes;
    for (const GpuCages::Instance& instance : cages.instances()) {
        if (!instance.isRemoved && instance.cage == index) nodes.push_back(instance.node);
    }
    std::ranges::sort(nodes);
    return nodes;
}

CageHandle GpuScene::State::addCage(const Cage& cage) {
    const std::uint32_t index = cageSlots.next();
    requireCage(cage, ErrorContext("cage", index, cage.name));
    std::unique_ptr<CageTables> tables = cages.makeTables(cage);
    cageSlots.add();
    if (index >= sceneState.cages.size()) sceneState.cages.resize(index + 1);
    takeCage(index, cage, std::move(tables));
    return {index, cageSlots.generation(index)};
}

void GpuScene::State::replaceCage(std::uint32_t index, const Cage& cage) {
    const ErrorContext element("cage", index, cage.name);
    for (const GpuCages::Instance& instance : cages.instances())
        element.require(instance.isRemoved || instance.cage != index || !instance.isDeformed,
                        "a node shows it deformed: it can not be replaced");
    requireStill(index, element);
    requireCage(cage, element);
    std::unique_ptr<CageTables> tables = cages.makeTables(cage);
    prepareDraws(tables->materials());
    const std::vector<std::uint32_t> nodes = nodesOfCage(index);
    for (const std::uint32_t node : nodes) hideCage(node);
    takeCage(index, cage, std::move(tables));
    for (const std::uint32_t node : nodes) {
        showCage(node);
        applyVisibility(node);
    }
}

void GpuScene::State::removeCage(std::uint32_t index) {
    const ErrorContext element("cage", index, sceneState.cages[index].name);
    element.require(nodesOfCage(index).empty(), "a node shows it: it can not be removed");
    requireStill(index, element);
    takeCage(index, {}, nullptr);
    cageSlots.remove(index);
}

}  // namespace candela
