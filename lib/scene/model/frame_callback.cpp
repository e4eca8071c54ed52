#include "scene/model/frame_callback.h"

#include <algorithm>

namespace candela {

namespace {

template <typename Vertices>
const Vertices* find(const std::vector<Vertices>& list, std::uint32_t Vertices::*index, std::uint32_t value) {
    const auto found = std::ranges::lower_bound(list, value, {}, index);
    return found != list.end() && (*found).*index == value ? &*found : nullptr;
}

}  // namespace

const SceneUpdate::MeshVertices* SceneUpdate::ofMesh(std::uint32_t mesh) const {
    return find(meshes, &MeshVertices::mesh, mesh);
}

const SceneUpdate::CageVertices* SceneUpdate::ofCage(std::uint32_t cage) const {
    return find(cages, &CageVertices::cage, cage);
}

std::shared_ptr<const SceneUpdate> FrameCallback::at(double seconds) const {
    const std::lock_guard lock(mutex_);
    if (lastTime_ == seconds) return last_;
    auto update = std::make_shared<const SceneUpdate>(evaluate(seconds));
    lastTime_ = seconds;
    last_ = update;
    return update;
}

std::shared_ptr<const SceneUpdate> updateAt(const Scene& scene, double time) {
    return scene.frameCallback ? scene.frameCallback->at(time) : nullptr;
}

bool isAnimated(const Scene& scene) {
    return !scene.animations.empty() || scene.frameCallback != nullptr;
}

TimeSpan frameCallbackSpan(const Scene& scene) {
    return scene.frameCallback ? scene.frameCallback->span() : TimeSpan{};
}

}  // namespace candela
