#pragma once

#include <candela/scene.h>

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace candela {

/// What a frame callback sets at one time, on top of the scene and its animations.
struct SceneUpdate {
    struct MeshVertices {
        std::uint32_t mesh = 0;
        std::vector<glm::vec3> positions, normals;  ///< One per vertex each.
    };
    struct CageVertices {
        std::uint32_t cage = 0;
        std::vector<glm::vec3> positions;
    };
    struct NodeMatrix {
        std::uint32_t node = 0;
        glm::dmat4 local{1.0};
    };
    std::vector<MeshVertices> meshes;         ///< All that the callback moves, in ascending order.
    std::vector<CageVertices> cages;          ///< Likewise.
    std::vector<NodeMatrix> nodes;            ///< In ascending order, each once.
    std::vector<PropertyChannel> properties;  ///< Of one key each, in range. Later ones apply.

    const MeshVertices* ofMesh(std::uint32_t mesh) const;
    const CageVertices* ofCage(std::uint32_t cage) const;
};

/// Changes a scene at every time; see `Scene::frameCallback`. Its functions may be called from several
/// threads at once.
class FrameCallback {
  public:
    explicit FrameCallback(const TimeSpan& span) : span_(span) {}
    virtual ~FrameCallback() = default;
    FrameCallback(const FrameCallback&) = delete;
    FrameCallback& operator=(const FrameCallback&) = delete;

    /// What it sets at a time, which is finite. The last time is kept, so that all that is asked of one time
    /// costs one evaluation. Throws `Error` when the callback fails.
    std::shared_ptr<const SceneUpdate> at(double seconds) const;
    const TimeSpan& span() const { return span_; }
    /// Does it move the vertices of a mesh, or of a cage?
    virtual bool movesMesh(std::uint32_t mesh) const = 0;
    virtual bool movesCage(std::uint32_t cage) const = 0;

  private:
    virtual SceneUpdate evaluate(double seconds) const = 0;

    TimeSpan span_;
    mutable std::mutex mutex_;
    mutable std::optional<double> lastTime_;
    mutable std::shared_ptr<const SceneUpdate> last_;
};

/// What the frame callback of a scene sets at `time`; null without one.
std::shared_ptr<const SceneUpdate> updateAt(const Scene& scene, double time);

inline bool movesMesh(const Scene& scene, std::uint32_t mesh) {
    return scene.frameCallback && scene.frameCallback->movesMesh(mesh);
}
inline bool movesCage(const Scene& scene, std::uint32_t cage) {
    return scene.frameCallback && scene.frameCallback->movesCage(cage);
}

}  // namespace candela
