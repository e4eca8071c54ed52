#pragma once

#include "support/random_elements.h"

#include <candela/error.h>
#include <candela/gpu_scene.h>
#include <candela/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <vector>

namespace candela::test {

/// A scene as values and on the device, which get the same edits. Removed elements stay as empty ones in the
/// values, so that the others keep their indices; lights are listed anew.
class LiveScene {
  public:
    LiveScene(const Context& context, std::uint32_t seed) : context_(context), random_(seed) {
        scene_.images.push_back(randomImage(random_));
        for (int i = 0; i < 3; ++i) scene_.materials.push_back(randomMaterial(random_, 0));
        Mesh floor = planeMesh(6, 6, 3);
        floor.submeshes[0].material = 0;
        for (glm::vec3& p : floor.positions) p.y -= 1.0f;
        scene_.meshes.push_back(floor);
        for (int i = 0; i < 3; ++i) {
            scene_.meshes.push_back(randomMesh(random_));
            scene_.meshes.back().submeshes[0].material = static_cast<std::uint32_t>(i);
        }
        for (std::uint32_t i = 0; i < 4; ++i) {
            Node& node = scene_.nodes.emplace_back();
            node.mesh = i;
            if (i > 0) node.transform = randomPlace(random_);
        }
        for (int i = 0; i < 4; ++i) lights_.push_back(randomLight(random_, std::nullopt));
        for (const auto& light : lights_) scene_.lights.push_back(*light);
        gpuScene_.emplace(context, scene_);
        for (std::uint32_t i = 0; i < 4; ++i) nodes_.push_back(NodeHandle(i));
        for (std::uint32_t i = 0; i < 4; ++i) meshes_.push_back(MeshHandle(i));
        for (std::uint32_t i = 0; i < 3; ++i) materials_.push_back(MaterialHandle(i));
        for (std::uint32_t i = 0; i < 4; ++i) lightHandles_.push_back(LightHandle(i));
        images_.push_back(ImageHandle(0));
    }

    GpuScene& onDevice() { return *gpuScene_; }

    /// The scene anew. The place of the default material, which no material gets, is an unused one.
    GpuScene anew() const {
        Scene scene = scene_;
        scene.lights.clear();
        for (const auto& light : lights_) {
            if (light) scene.lights.push_back(*light);
        }
        return GpuScene(context_, scene, {.vertexDetail = VertexDetail::always});
    }

    void edit() {
        switch (random_() % 14) {
            case 0:
                return addNode();
            case 1:
                return removeNode();
            case 2:
                return addMesh();
            case 3:
                return replaceMesh();
            case 4:
                return removeMesh();
            case 5:
                return addLight();
            case 6:
                return removeLight();
            case 7:
                return setLight();
            case 8:
                return addMaterial();
            case 9:
                return addImage();
            case 10:
                return replaceImage();
            case 11:
                return setPixels();
            case 12:
                return setPositions();
            default:
                return moveNodes();
        }
    }

  private:
    template <typename Element>
    static void put(std::vector<Element>& elements, std::uint32_t index, const Element& element) {
        if (index >= elements.size()) elements.resize(index + 1);
        elements[index] = element;
    }
    template <typename Handles>
    auto anyOf(const Handles& handles) {
        return handles[random_() % handles.size()];
    }
    Mesh meshWithMaterial() {
        Mesh mesh = randomMesh(random_);
        if (random_() % 6 != 0) mesh.submeshes[0].material = anyOf(materials_).index;
        return mesh;
    }

    void addNode() {
        Node node;
        node.mesh = anyOf(meshes_).index;
        if (random_() % 3 == 0) node.parent = anyOf(nodes_).index;
        node.transform = randomPlace(random_);
        node.visible = random_() % 6 != 0;
        node.castsShadow = random_() % 5 != 0;
        const NodeHandle handle = gpuScene_->addNode(node);
        put(scene_.nodes, handle.index, node);
        nodes_.push_back(handle);
    }
    void removeNode() {
        if (nodes_.size() < 3) return;
        const NodeHandle root = anyOf(nodes_);
        gpuScene_->removeNode(root);
        std::vector<bool> gone(scene_.nodes.size(), false);
        gone[root.index] = true;
        for (std::size_t i = 0; i < gone.size(); ++i) {
            if (scene_.nodes[i].parent && gone[*scene_.nodes[i].parent]) gone[i] = true;
            if (gone[i]) scene_.nodes[i] = {};
        }
        std::erase_if(nodes_, [&](const NodeHandle& handle) { return gone[handle.index]; });
        std::erase_if(lightHandles_, [&](const LightHandle& handle) {
            auto& light = lights_[handle.index];
            const bool goes = light->node && gone[*light->node];
            if (goes) light.reset();
            return goes;
        });
        if (nodes_.empty()) addNode();
    }
    void addMesh() {
        const Mesh mesh = meshWithMaterial();
        const MeshHandle handle = gpuScene_->addMesh(mesh);
        put(scene_.meshes, handle.index, mesh);
        meshes_.push_back(handle);
    }
    void replaceMesh() {
        const MeshHandle handle = anyOf(meshes_);
        const Mesh mesh = meshWithMaterial();
        gpuScene_->replaceMesh(handle, mesh);
        scene_.meshes[handle.index] = mesh;
    }
    void removeMesh() {
        if (meshes_.size() < 2) return;
        const MeshHandle handle = anyOf(meshes_);
        const bool isShown =
            std::ranges::any_of(scene_.nodes, [&](const Node& node) { return node.mesh == handle.index; });
        if (isShown) {
            EXPECT_THROW(gpuScene_->removeMesh(handle), Error);
            return;
        }
        gpuScene_->removeMesh(handle);
        scene_.meshes[handle.index] = {};
        std::erase(meshes_, handle);
    }
    void addLight() {
        const auto node = random_() % 2 == 0 ? std::optional(anyOf(nodes_).index) : std::nullopt;
        const Light light = randomLight(random_, node);
        const LightHandle handle = gpuScene_->addLight(light);
        if (handle.index >= lights_.size()) lights_.resize(handle.index + 1);
        lights_[handle.index] = light;
        lightHandles_.push_back(handle);
    }
    void removeLight() {
        if (lightHandles_.empty()) return;
        const LightHandle handle = anyOf(lightHandles_);
        gpuScene_->removeLight(handle);
        lights_[handle.index].reset();
        std::erase(lightHandles_, handle);
    }
    void setLight() {
        if (lightHandles_.empty()) return;
        const LightHandle handle = anyOf(lightHandles_);
        Light light = randomLight(random_, lights_[handle.index]->node);
        if (random_() % 2 == 0) {
            light = *lights_[handle.index];
            light.intensity *= 0.8f;
            light.position.x += 0.1f;
        }
        gpuScene_->setLight(handle, light);
        lights_[handle.index] = light;
    }
    void addMaterial() {
        const Material material = randomMaterial(random_, anyOf(images_).index);
        if (random_() % 2 == 0) {
            const MaterialHandle changed = anyOf(materials_);
            gpuScene_->setMaterial(changed, material);
            scene_.materials[changed.index] = material;
            return;
        }
        const MaterialHandle handle = gpuScene_->addMaterial(material);
        put(scene_.materials, handle.index, material);
        materials_.push_back(handle);
        const MaterialHandle unused = gpuScene_->addMaterial({});
        put(scene_.materials, unused.index, {});
        gpuScene_->removeMaterial(unused);
        EXPECT_THROW(gpuScene_->setMaterial(unused, {}), Error);
    }
    void addImage() {
        const Image image = randomImage(random_);
        const ImageHandle handle = gpuScene_->addImage(image);
        put(scene_.images, handle.index, image);
        images_.push_back(handle);
    }
    void replaceImage() {
        const ImageHandle handle = anyOf(images_);
        const Image image = randomImage(random_);
        gpuScene_->replaceImage(handle, image);
        scene_.images[handle.index] = image;
    }
    void setPixels() {
        const ImageHandle handle = anyOf(images_);
        Image& image = scene_.images[handle.index];
        const ImageRegion region{2, 3, 1 + random_() % (image.width - 2), 1 + random_() % 5};
        std::vector<std::byte> pixels(region.width * region.height * 4u);
        for (std::byte& byte : pixels) byte = static_cast<std::byte>(random_() % 256);
        gpuScene_->setPixels(handle, region, pixels);
        for (std::uint32_t row = 0; row < region.height; ++row) {
            std::memcpy(image.pixels.data() + ((region.y + row) * image.width + region.x) * 4u,
                        pixels.data() + row * region.width * 4u, region.width * 4u);
        }
    }
    void setPositions() {
        const MeshHandle handle = anyOf(meshes_);
        Mesh& mesh = scene_.meshes[handle.index];
        for (glm::vec3& position : mesh.positions) position *= 0.95f + 0.1f * random_.unit();
        const bool normalsToo = random_() % 2 == 0;
        if (normalsToo)
            for (glm::vec3& normal : mesh.normals) normal = -normal;
        gpuScene_->setPositions(
            handle, mesh.positions,
            normalsToo ? std::span<const glm::vec3>(mesh.normals) : std::span<const glm::vec3>());
    }
    void moveNodes() {
        std::vector<GpuScene::NodeTransform> transforms;
        for (const NodeHandle& node : nodes_) {
            if (random_() % 2 == 0) continue;
            transforms.push_back({node, randomPlace(random_)});
            scene_.nodes[node.index].transform = transforms.back().local;
        }
        gpuScene_->setTransforms(transforms);
    }

    const Context& context_;
    Random random_;
    Scene scene_;
    std::vector<std::optional<Light>> lights_;
    std::optional<GpuScene> gpuScene_;
    std::vector<NodeHandle> nodes_;
    std::vector<MeshHandle> meshes_;
    std::vector<MaterialHandle> materials_;
    std::vector<ImageHandle> images_;
    std::vector<LightHandle> lightHandles_;
};

}  // namespace candela::test
