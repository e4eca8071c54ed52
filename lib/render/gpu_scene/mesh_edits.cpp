// Edits of the meshes of a GpuScene.

#include "gl/state_guard.h"
#include "render/culling/triangle_filter.h"
#include "render/gpu_scene/buffer_source.h"
#include "render/gpu_scene/gpu_scene_state.h"
#include "scene/model/frame_callback.h"
#include "scene/validate/scene_rules.h"

#include <candela/error.h>

#include <algorithm>

namespace candela {

template <typename Visit>
void GpuScene::State::forEachInstanceOf(std::uint32_t mesh, const Visit& visit) {
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        if (!instances[i].isRemoved && instances[i].mesh == mesh) visit(i);
    }
}

/// A mesh that comes in the place of another, or as a new one.
void GpuScene::State::requireMesh(const Mesh& mesh, const ErrorContext& element) const {
    validateMesh(mesh, sceneState, element);
    bool readsDetail = !mesh.colors.empty();
    for (const Submesh& submesh : mesh.submeshes) {
        materialSlots.requireAlive(submesh.material, element);
        if (submesh.material) requireDetail(sceneState.materials[*submesh.material], element);
    }
    if (!mesh.furtherUvs.empty())
        element.refuse("a mesh that is added can not have more than two sets of texture coordinates",
                       ErrorKind::unsupported);
    if (readsDetail && !meshes.hasDetail())
        element.refuse("has colours, but the scene was made without (GpuSceneOptions::vertexDetail)",
                       ErrorKind::unsupported);
}

void GpuScene::State::requireRigid(std::uint32_t mesh, const ErrorContext& element) const {
    element.require(!deformations.deforms(mesh), "a node shows it deformed: it can not be changed");
    element.require(!movesMesh(sceneState, mesh),
                    "the scene's frame callback moves its vertices: it can not be changed");
}

MeshHandle GpuScene::State::addMesh(const Mesh& mesh) {
    const std::uint32_t index = meshSlots.next();
    requireMesh(mesh, ErrorContext("mesh", index, mesh.name));
    if (meshes.set(index, mesh) == GpuMeshes::Buffers::replaced) redescribe();
    meshSlots.add();
    if (index >= sceneState.meshes.size()) {
        sceneState.meshes.resize(index + 1);
        meshParts.resize(index + 1);
        meshUsers_.resize(index + 1);
    }
    takeMesh(index, mesh);
    return {index, meshSlots.generation(index)};
}

void GpuScene::State::takeMesh(std::uint32_t index, const Mesh& mesh) {
    const MeshParts before = std::exchange(meshParts[index], partsOf(mesh));
    Mesh& kept = sceneState.meshes[index];
    kept = {};
    kept.name = mesh.name;
    kept.morphTargets.resize(mesh.morphTargets.size());
    clusters.replace(index, mesh);
    deformations.setMesh(index, mesh);
    updateCommonUvs(before);
    updateCommonUvs(meshParts[index]);
}

/// Of the materials of a mesh that has come or gone.
void GpuScene::State::updateCommonUvs(const MeshParts& parts) {
    for (const MeshParts::Part& part : parts.parts) {
        if (part.material) materials.setCommonUvs(*part.material, commonUvsOf(*part.material));
    }
}

UvSets GpuScene::State::commonUvsOf(std::uint32_t material) const {
    UvSets common = ~UvSets{0};
    for (const MeshParts& mesh : meshParts) {
        for (const MeshParts::Part& part : mesh.parts) {
            if (part.material == material) common &= mesh.uvs;
        }
    }
    for (const Cage& cage : sceneState.cages) {
        if (std::ranges::find(cage.faceMaterials, material) != cage.faceMaterials.end())
            common &= cage.uvs.empty() ? 0u : 1u;
    }
    return common;
}

void GpuScene::State::replaceMesh(std::uint32_t index, const Mesh& mesh) {
    const ErrorContext element("mesh", index, mesh.name);
    requireRigid(index, element);
    requireMesh(mesh, element);
    prepareDraws(partsOf(mesh));
    if (meshes.set(index, mesh) == GpuMeshes::Buffers::replaced) redescribe();
    const MeshParts before = meshParts[index];
    takeMesh(index, mesh);
    const MeshParts& parts = meshParts[index];
    forEachInstanceOf(index, [&](std::uint32_t instance) {
        countElements(before, -1);
        countElements(parts, 1);
        draws.remove(instance);
        draws.addMesh(instance, {}, index, parts, meshes.places()[index], sceneState.materials, images);
        draws.setWinding(instance, instances.winding(instance));
        instances.setElements(instance, parts.hasOnlyTriangles() ? GpuInstances::Elements::trianglesOnly
                                                                 : GpuInstances::Elements::linesOrPoints);
        place(instance, transforms.world()[instances[instance].node], meshes.places()[index].sphere);
    });
    rangeRuleChanged_ = true;
}

void GpuScene::State::removeMesh(std::uint32_t index) {
    const ErrorContext element("mesh", index, sceneState.meshes[index].name);
    element.require(meshUsers_[index] == 0, "a node shows it: it can not be removed");
    requireRigid(index, element);
    meshes.remove(index);
    takeMesh(index, {});
    meshSlots.remove(index);
}

void GpuScene::State::setPositions(std::uint32_t index, std::span<const glm::vec3> positions,
                                   std::span<const glm::vec3> normals) {
    const ErrorContext element("mesh", index, sceneState.meshes[index].name);
    requireRigid(index, element);
    const std::uint32_t vertices = meshes.places()[index].vertexCount;
    element.requireCount("positions", positions.size(), "vertices", vertices);
    if (!normals.empty()) element.requireCount("normals", normals.size(), "vertices", vertices);
    element.requireEachFinite("position", positions);
    const bool mayLackNormals = !meshParts[index].hasOnlyTriangles();
    element.requireEach("normal", normals, "does not have unit length", [&](const glm::vec3& normal) {
        return isUnit(normal) || (mayLackNormals && normal == glm::vec3(0.0f));
    });
    moveVertices(index, positions, normals);
    deformations.setMesh(index, {});
}

void GpuScene::State::moveVertices(std::uint32_t index, std::span<const glm::vec3> positions,
                                   std::span<const glm::vec3> normals) {
    meshes.setSurface(index, positions, normals);
    if (meshes.access() == GpuMeshes::Access::deviceAndCpu) {
        const MeshPlace& at = meshes.places()[index];
        clusters.move(index, {positions, meshes.mappedIndices().subspan(at.firstIndex, at.indexCount)});
    } else {
        clusters.forget(index);
    }
    forEachInstanceOf(index, [&](std::uint32_t instance) {
        place(instance, transforms.world()[instances[instance].node], meshes.places()[index].sphere);
    });
    rangeRuleChanged_ = true;
}

void GpuScene::State::setPositions(std::uint32_t index, const BufferRange& vertices, const Bounds& bounds) {
    const ErrorContext element("mesh", index, sceneState.meshes[index].name);
    requireRigid(index, element);
    element.requireFinite("the lower corner of its bounds", bounds.min);
    element.requireFinite("the upper corner of its bounds", bounds.max);
    element.require(!bounds.empty(), "its bounds must not be empty");
    requireBytes(vertices, std::uint64_t{meshes.places()[index].vertexCount} * GpuMeshes::surfaceBytes(),
                 "the vertices of a mesh");
    const glm::vec3 corners[] = {bounds.min, bounds.max};
    meshes.copySurface(index, vertices, boundingSphere(corners));
    clusters.replace(index, {});
    deformations.setMesh(index, {});
    forEachInstanceOf(index, [&](std::uint32_t instance) {
        place(instance, transforms.world()[instances[instance].node], meshes.places()[index].sphere);
    });
    rangeRuleChanged_ = true;
}

void GpuScene::State::prepareDraws(const MeshParts& parts) {
    if (draws.isPrepared(parts)) return;
    const gl::StateGuard pixelStorage(*binding, "a GpuScene");
    draws.prepare(parts, sceneState.materials, images);
}

/// Tells all vertex arrays where the meshes are.
void GpuScene::State::redescribe() {
    describeMeshes(vertexArray);
    if (meshes.hasFurtherUvs()) {
        describeMeshes(furtherUvArray);
        meshes.describeFurtherUvs(furtherUvArray);
    }
    deformations.describe(meshes, draws.records(), defaultDetail_);
    triangleFilter->describeMeshes();
}

}  // namespace candela
