#include "render/debug/motion.h"

#include "base/thread_pool.h"
#include "scene/model/view_window.h"

#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <cstddef>

namespace candela {

namespace {

/// From the world to pixels of the picture, y down.
class Projector {
  public:
    Projector(const CameraView& view, const FramePixels& pixels)
        : cameraFromWorld_(glm::inverse(glm::dmat4(view.worldFromCamera))),
          window_(pixels.pictureWindow(view)),
          size_(pixels.pictureWidth, pixels.pictureHeight),
          orthographic_(view.orthographicHeight.has_value()) {}

    /// Not a number behind the eye.
    glm::dvec2 pixel(const glm::dvec3& position) const {
        const glm::dvec3 c(cameraFromWorld_ * glm::dvec4(position, 1.0));
        if (!orthographic_ && c.z >= 0.0) return glm::dvec2(NAN);
        const glm::dvec2 across = orthographic_ ? glm::dvec2(c) : glm::dvec2(c) / -c.z;
        const glm::dvec2 place = 0.5 * across / window_.halfExtent - window_.shift;
        return {(0.5 + place.x) * size_.x, (0.5 - place.y) * size_.y};
    }

  private:
    glm::dmat4 cameraFromWorld_;
    ViewWindow window_;
    glm::dvec2 size_;
    bool orthographic_;
};

/// Where the surfaces of instances were.
class Past {
  public:
    explicit Past(const MotionInputs& inputs) : previous_(inputs.previousPositions) {
        const GpuInstances& instances = inputs.instances;
        waysBack_.assign(instances.size(), glm::dmat4(1.0));
        for (std::uint32_t i = 0; i < waysBack_.size(); ++i) {
            const glm::mat4 now = instances.worldFromLocal(i), before = instances.keptWorldFromLocal(i);
            worldFromLocal_.emplace_back(before);
            if (now != before) waysBack_[i] = glm::dmat4(before) * glm::inverse(glm::dmat4(now));
        }
    }

    /// Of what pixel `pixel` shows at `position`.
    glm::dvec3 position(std::uint32_t instance, std::size_t pixel, const glm::dvec3& position) const {
        if (previous_.empty() || previous_[4 * pixel + 3] == 0.0f)
            return glm::dvec3(waysBack_[instance] * glm::dvec4(position, 1.0));
        const float* local = &previous_[4 * pixel];
        return glm::dvec3(worldFromLocal_[instance] * glm::dvec4(local[0], local[1], local[2], 1.0));
    }

  private:
    std::span<const float> previous_;
    /// From where instances are to where they were; the unit matrix where they have not moved.
    std::vector<glm::dmat4> waysBack_;
    std::vector<glm::dmat4> worldFromLocal_;
};

}  // namespace

std::vector<float> motionOf(const MotionInputs& inputs) {
    const Projector now(inputs.view, inputs.pixels), before(inputs.previousView, inputs.pixels);
    const Past past(inputs);
    const auto width = static_cast<std::size_t>(inputs.pixels.width);
    std::vector<float> motion(4 * inputs.ids.size(), 0.0f);
    ThreadPool::shared()->run(static_cast<std::size_t>(inputs.pixels.height), [&](std::size_t y, unsigned) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t i = y * width + x;
            const std::uint32_t instance = inputs.ids[i].instance;
            if (instance == 0 || !(inputs.depth[i] > 0.0f)) continue;
            const glm::dvec3 position(
                worldPosition(inputs.frame, static_cast<int>(x), static_cast<int>(y), inputs.depth[i]));
            const glm::dvec3 then = past.position(instance - 1, i, position);
            const glm::dvec2 way = now.pixel(position) - before.pixel(then);
            if (!std::isfinite(way.x) || !std::isfinite(way.y)) continue;
            motion[4 * i] = static_cast<float>(way.x);
            motion[4 * i + 1] = static_cast<float>(way.y);
        }
    });
    return motion;
}

}  // namespace candela
