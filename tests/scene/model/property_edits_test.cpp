// Properties that animations and the frame callback change no longer.

#include "scene/model/frame_callback.h"

#include <candela/property_edits.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace candela::test {
namespace {

PropertyChannel channelOf(AnimatedProperty property, std::uint32_t element) {
    PropertyChannel channel;
    channel.property = property;
    channel.element = element;
    return channel;
}

const std::vector<PropertyChannel> allChannels{
    channelOf(AnimatedProperty::lightColor, 0), channelOf(AnimatedProperty::lightPosition, 1),
    channelOf(AnimatedProperty::verticalFov, 0), channelOf(AnimatedProperty::verticalFov, 1),
    channelOf(AnimatedProperty::roughness, 0)};

/// Sets all of these at each time, moves mesh 3, and moves node 2.
class AllChannels final : public FrameCallback {
  public:
    AllChannels() : FrameCallback(TimeSpan{1.0, 4.0}) {}
    bool movesMesh(std::uint32_t mesh) const override { return mesh == 3; }
    bool movesCage(std::uint32_t cage) const override { return cage == 5; }

  private:
    SceneUpdate evaluate(double seconds) const override {
        SceneUpdate update;
        update.properties = allChannels;
        update.nodes.push_back({2, glm::dmat4(seconds)});
        return update;
    }
};

Scene animatedScene() {
    Scene scene;
    scene.animations.resize(2);
    scene.animations[1].properties = allChannels;
    scene.frameCallback = std::make_shared<AllChannels>();
    return scene;
}

void expectLeft(const Scene& scene, const std::vector<std::size_t>& left) {
    const auto isLeft = [&](const std::vector<PropertyChannel>& channels) {
        ASSERT_EQ(channels.size(), left.size());
        for (std::size_t i = 0; i < left.size(); ++i) {
            EXPECT_EQ(channels[i].property, allChannels[left[i]].property);
            EXPECT_EQ(channels[i].element, allChannels[left[i]].element);
        }
    };
    isLeft(scene.animations[1].properties);
    isLeft(updateAt(scene, 2.0)->properties);
}

TEST(EndPropertyChanges, OfAKind) {
    Scene scene = animatedScene();
    endPropertyChanges(scene, AnimatedElement::light);
    expectLeft(scene, {2, 3, 4});
    endPropertyChanges(scene, AnimatedElement::material);
    expectLeft(scene, {2, 3});
}

TEST(EndPropertyChanges, OfAnElement) {
    Scene scene = animatedScene();
    endPropertyChanges(scene, AnimatedElement::camera, 1);
    expectLeft(scene, {0, 1, 2, 4});
}

TEST(EndPropertyChanges, LeavesTheRestOfTheFrameCallback) {
    Scene scene = animatedScene();
    endPropertyChanges(scene, AnimatedElement::light);
    EXPECT_EQ(updateAt(scene, 2.0)->nodes.at(0).local, glm::dmat4(2.0));
    EXPECT_EQ(updateAt(scene, 3.0)->nodes.at(0).local, glm::dmat4(3.0));
    EXPECT_TRUE(movesMesh(scene, 3));
    EXPECT_FALSE(movesMesh(scene, 5));
    EXPECT_TRUE(movesCage(scene, 5));
    EXPECT_EQ(frameCallbackSpan(scene).last, 4.0);
}

TEST(EndPropertyChanges, NeedsNoAnimation) {
    Scene scene;
    endPropertyChanges(scene, AnimatedElement::light);
    EXPECT_FALSE(isAnimated(scene));
}

}  // namespace
}  // namespace candela::test
