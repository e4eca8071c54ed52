// Which animations play, and which pose a time shows.

#include "common/scene_selection.h"

#include <candela/error.h>

#include <gtest/gtest.h>

namespace {

candela::Animation endingAt(const char* name, float time) {
    candela::Animation animation{name, {}};
    animation.channels.resize(1);
    animation.channels[0].times = {0.0f, time};
    return animation;
}

/// "Idle" of 1 s, "Walk" of 2.5 s and one without a name of 4 s.
candela::Scene threeClips() {
    candela::Scene scene;
    scene.animations = {endingAt("Idle", 1.0f), endingAt("Walk", 2.5f), endingAt("", 4.0f)};
    return scene;
}

using Indices = std::vector<std::uint32_t>;

Indices selected(const candela::Scene& scene, std::optional<std::string> selection) {
    SceneOptions options;
    options.scene = "clips.gltf";
    options.animation = std::move(selection);
    return selectedAnimations(scene, options);
}

TEST(AnimationSelection, IsTheFirstByDefault) {
    EXPECT_EQ(selected(threeClips(), std::nullopt), Indices{0});
    EXPECT_EQ(selected({}, std::nullopt), Indices{});
}

TEST(AnimationSelection, TakesNamesNumbersAllAndNone) {
    candela::Scene scene = threeClips();
    EXPECT_EQ(selected(scene, "Walk"), Indices{1});
    EXPECT_EQ(selected(scene, "2"), Indices{2});
    EXPECT_EQ(selected(scene, "all"), (Indices{0, 1, 2}));
    EXPECT_EQ(selected(scene, "none"), Indices{});
    scene.animations[2].name = "1";
    EXPECT_EQ(selected(scene, "1"), Indices{2}) << "names go before numbers";
}

TEST(AnimationSelection, ListsTheAnimationsWhereNoneHasTheName) {
    for (const char* text : {"Run", "3", "-1", ""}) {
        try {
            selected(threeClips(), text);
            FAIL() << text;
        } catch (const candela::Error& error) {
            EXPECT_EQ(error.path(), "clips.gltf");
            EXPECT_NE(std::string(error.what()).find("there are 0 \"Idle\", 1 \"Walk\", 2"),
                      std::string::npos)
                << error.what();
        }
    }
    EXPECT_THROW(selected({}, "0"), candela::Error);
    EXPECT_EQ(selected({}, "all"), Indices{});
}

TEST(AnimationSelection, NotesWhatTheDefaultLeavesOut) {
    candela::Scene scene = threeClips();
    SceneOptions options;
    const std::optional<std::string> note = selectAnimations(scene, options);
    ASSERT_TRUE(note);
    EXPECT_NE(note->find("only 0 \"Idle\" plays"), std::string::npos) << *note;
    EXPECT_NE(note->find("1 \"Walk\", 2"), std::string::npos) << *note;
    EXPECT_TRUE(scene.animations[0].plays);
    EXPECT_FALSE(scene.animations[1].plays);
    options.animation = "Walk";
    EXPECT_FALSE(selectAnimations(scene, options));
    EXPECT_FALSE(scene.animations[0].plays);
    EXPECT_TRUE(scene.animations[1].plays);
    scene.animations.resize(1);
    options.animation.reset();
    EXPECT_FALSE(selectAnimations(scene, options)) << "nothing is left out";
}

TEST(PoseTime, HoldsOrRepeats) {
    candela::Scene scene = threeClips();
    SceneOptions options;
    EXPECT_EQ(lastKeyTime(scene), 4.0);
    playOnly(scene, {0, 1});
    EXPECT_EQ(lastKeyTime(scene), 2.5);
    EXPECT_EQ(poseTime(scene, options, 3.0), 3.0);
    options.repeatAnimations = true;
    EXPECT_EQ(poseTime(scene, options, 2.0), 2.0);
    EXPECT_EQ(poseTime(scene, options, 3.0), 0.5);
    EXPECT_EQ(poseTime(scene, options, -0.5), 2.0);
    scene.animations[1].properties.emplace_back().times = {0.0f, 8.0f};
    EXPECT_EQ(lastKeyTime(scene), 8.0);
    playOnly(scene, {});
    EXPECT_EQ(lastKeyTime(scene), 0.0);
    EXPECT_EQ(poseTime(scene, options, 3.0), 3.0);
}

}  // namespace
