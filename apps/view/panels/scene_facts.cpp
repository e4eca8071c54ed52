#include "panels/scene_facts.h"

#include <algorithm>

namespace {

void add(std::string& words, const char* word) {
    words += (words.empty() ? "" : ", ") + std::string(word);
}

class MaterialList {
  public:
    explicit MaterialList(std::size_t count) : met_(count, false) {}

    void add(const std::optional<std::uint32_t>& material) {
        if (!material || met_[*material]) return;
        met_[*material] = true;
        list_.push_back(*material);
    }
    std::vector<std::uint32_t> take() { return std::move(list_); }

  private:
    std::vector<bool> met_;
    std::vector<std::uint32_t> list_;
};

}  // namespace

std::vector<std::string> kindsOfNodes(const candela::Scene& scene) {
    std::vector<std::string> kinds(scene.nodes.size());
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        if (scene.nodes[i].mesh) add(kinds[i], "mesh");
        if (scene.nodes[i].cage) add(kinds[i], "cage");
    }
    for (const candela::Light& light : scene.lights)
        if (light.node && !kinds[*light.node].ends_with("light")) add(kinds[*light.node], "light");
    for (const candela::Camera& camera : scene.cameras)
        if (camera.node && !kinds[*camera.node].ends_with("camera")) add(kinds[*camera.node], "camera");
    return kinds;
}

std::vector<std::uint32_t> materialsOfNode(const candela::Scene& scene, std::uint32_t node) {
    MaterialList list(scene.materials.size());
    const candela::Node& shown = scene.nodes[node];
    if (shown.mesh)
        for (const candela::Submesh& submesh : scene.meshes[*shown.mesh].submeshes)
            list.add(submesh.material);
    if (shown.cage)
        for (const auto& material : scene.cages[shown.cage->cage].faceMaterials) list.add(material);
    return list.take();
}

double lastKeyTime(const candela::Scene& scene) {
    float last = 0.0f;
    for (const candela::Animation& animation : scene.animations)
        for (const candela::AnimationChannel& channel : animation.channels)
            last = std::max(last, channel.times.back());
    return last;
}
