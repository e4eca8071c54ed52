// The functions of a GpuScene that add, remove and replace elements.

#include "render/gpu_scene/gpu_scene_state.h"

namespace candela {

NodeHandle GpuScene::addNode(const Node& node) {
    requireContext();
    return state().addNode(node);
}

void GpuScene::removeNode(NodeHandle node) {
    requireContext();
    state().removeNode(state().nodeSlots.indexOf(node));
}

MeshHandle GpuScene::addMesh(const Mesh& mesh) {
    requireContext();
    return state().addMesh(mesh);
}

void GpuScene::replaceMesh(MeshHandle handle, const Mesh& mesh) {
    requireContext();
    state().replaceMesh(state().meshSlots.indexOf(handle), mesh);
}

void GpuScene::removeMesh(MeshHandle handle) {
    state().removeMesh(state().meshSlots.indexOf(handle));
}

void GpuScene::setPositions(MeshHandle handle, std::span<const glm::vec3> positions,
                            std::span<const glm::vec3> normals) {
    requireContext();
    state().setPositions(state().meshSlots.indexOf(handle), positions, normals);
}

void GpuScene::setPositions(MeshHandle handle, const BufferRange& vertices, const Bounds& bounds) {
    requireContext();
    state().setPositions(state().meshSlots.indexOf(handle), vertices, bounds);
}

CageHandle GpuScene::addCage(const Cage& cage) {
    requireContext();
    return state().addCage(cage);
}

void GpuScene::replaceCage(CageHandle handle, const Cage& cage) {
    requireContext();
    state().replaceCage(state().cageSlots.indexOf(handle), cage);
}

void GpuScene::removeCage(CageHandle handle) {
    requireContext();
    state().removeCage(state().cageSlots.indexOf(handle));
}

MaterialHandle GpuScene::addMaterial(const Material& material) {
    requireContext();
    return state().addMaterial(material);
}

void GpuScene::removeMaterial(MaterialHandle handle) {
    state().removeMaterial(state().materialSlots.indexOf(handle));
}

ImageHandle GpuScene::addImage(const Image& image) {
    return state().addImage(image);
}

void GpuScene::replaceImage(ImageHandle handle, const Image& image) {
    requireContext();
    state().replaceImage(state().imageSlots.indexOf(handle), image);
}

void GpuScene::removeImage(ImageHandle handle) {
    requireContext();
    state().removeImage(state().imageSlots.indexOf(handle));
}

void GpuScene::setPixels(ImageHandle handle, const ImageRegion& region, std::span<const std::byte> pixels) {
    requireContext();
    state().setPixels(state().imageSlots.indexOf(handle), region, pixels);
}

void GpuScene::setPixels(ImageHandle handle, const ImageRegion& region, const BufferRange& pixels) {
    requireContext();
    state().setPixels(state().imageSlots.indexOf(handle), region, pixels);
}

LightHandle GpuScene::addLight(const Light& light) {
    return state().addLight(light);
}

void GpuScene::setLight(LightHandle handle, const Light& light) {
    state().setLight(state().lightSlots.indexOf(handle), light);
}

void GpuScene::removeLight(LightHandle handle) {
    state().removeLight(state().lightSlots.indexOf(handle));
}

void GpuScene::setLights(const BufferRange& records, std::uint64_t count) {
    requireContext();
    state().setLights(records, count);
}

}  // namespace candela
