#include <candela/property_edits.h>

#include "scene/model/frame_callback.h"

#include <memory>
#include <utility>
#include <vector>

namespace candela {

namespace {

/// Properties of an element, or of all of a kind.
struct EndedElement {
    AnimatedElement kind;
    std::optional<std::uint32_t> index;

    bool has(const PropertyChannel& channel) const {
        return elementOf(channel.property) == kind && (!index || channel.element == *index);
    }
};

/// A frame callback without what it does to some properties.
class PartOfFrameCallback final : public FrameCallback {
  public:
    PartOfFrameCallback(std::shared_ptr<const FrameCallback> whole, const EndedElement& ended)
        : FrameCallback(whole->span()), whole_(std::move(whole)), ended_(ended) {}

    bool movesMesh(std::uint32_t mesh) const override { return whole_->movesMesh(mesh); }
    bool movesCage(std::uint32_t cage) const override { return whole_->movesCage(cage); }

  private:
    SceneUpdate evaluate(double seconds) const override {
        SceneUpdate update = *whole_->at(seconds);
        std::erase_if(update.properties, [&](const PropertyChannel& channel) { return ended_.has(channel); });
        return update;
    }

    std::shared_ptr<const FrameCallback> whole_;
    EndedElement ended_;
};

}  // namespace

void endPropertyChanges(Scene& scene, AnimatedElement kind, std::optional<std::uint32_t> index) {
    const EndedElement ended{kind, index};
    for (Animation& animation : scene.animations)
        std::erase_if(animation.properties, [&](const PropertyChannel& channel) { return ended.has(channel); });
    if (scene.frameCallback)
        scene.frameCallback = std::make_shared<PartOfFrameCallback>(std::move(scene.frameCallback), ended);
}

}  // namespace candela
