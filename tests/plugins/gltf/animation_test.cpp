#include <gtest/gtest.h>

#include "loading.h"

namespace candela_test {
namespace {

/// One animated node, times 0, 1 and 3 in accessor 0 and the values in accessor 1.
template <typename T>
GltfFile animatedFile(const std::string& path, const std::string& type, const std::vector<T>& values,
                      const std::string& interpolation, const std::string& more = "") {
    GltfFile file;
    file.addData<float>("SCALAR", {0, 1, 3});
    file.addData<T>(type, values, more);
    file.add("nodes", "{}");
    file.add("nodes", "{}");
    file.add("animations", R"({"name":"walk","samplers":[{"input":0,"output":1,"interpolation":")" +
                               interpolation + R"("}],"channels":[{"sampler":0,"target":{"node":1,"path":")" +
                               path + "\"}}]}");
    return file;
}

candela::AnimationChannel channelOf(const GltfFile& file) {
    return load(file).scene.animations.at(0).channels.at(0);
}

TEST(Animation, linearTranslation) {
    const std::vector<float> values{0, 0, 0, 1, 2, 3, 4, 5, 6};
    const candela::ImportedScene imported =
        load(animatedFile<float>("translation", "VEC3", values, "LINEAR"));
    ASSERT_EQ(imported.scene.animations.size(), 1u);
    EXPECT_EQ(imported.scene.animations[0].name, "walk");
    const candela::AnimationChannel& channel = imported.scene.animations[0].channels.at(0);
    EXPECT_EQ(channel.node, 1u);
    EXPECT_EQ(channel.path, candela::AnimationPath::translation);
    EXPECT_EQ(channel.interpolation, candela::Interpolation::linear);
    EXPECT_EQ(channel.times, (std::vector<float>{0, 1, 3}));
    EXPECT_EQ(channel.values, values);
}

TEST(Animation, stepScale) {
    const candela::AnimationChannel channel =
        channelOf(animatedFile<float>("scale", "VEC3", {1, 1, 1, 2, 2, 2, 3, 3, 3}, "STEP"));
    EXPECT_EQ(channel.path, candela::AnimationPath::scale);
    EXPECT_EQ(channel.interpolation, candela::Interpolation::step);
}

TEST(Animation, cubicSplineHasThreeValuesPerKey) {
    std::vector<float> values(27);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
    const candela::AnimationChannel channel =
        channelOf(animatedFile<float>("translation", "VEC3", values, "CUBICSPLINE"));
    EXPECT_EQ(channel.interpolation, candela::Interpolation::cubicSpline);
    EXPECT_EQ(channel.values, values);
}

template <typename T>
std::vector<float> rotationsAs(T one) {
    return channelOf(animatedFile<T>("rotation", "VEC4", {0, 0, 0, one, one, 0, 0, 0, 0, one, 0, 0}, "LINEAR",
                                     std::is_same_v<T, float> ? "" : R"("normalized":true)"))
        .values;
}

TEST(Animation, rotationsOfEveryType) {
    const std::vector<float> expected{0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0};
    EXPECT_EQ(rotationsAs<float>(1.0f), expected);
    EXPECT_EQ(rotationsAs<std::int8_t>(127), expected);
    EXPECT_EQ(rotationsAs<std::uint8_t>(255), expected);
    EXPECT_EQ(rotationsAs<std::int16_t>(32767), expected);
    EXPECT_EQ(rotationsAs<std::uint16_t>(65535), expected);
}

TEST(Animation, interpolationIsLinearByDefault) {
    GltfFile file;
    file.addData<float>("SCALAR", {0});
    file.addData<float>("VEC3", {1, 2, 3});
    file.add("nodes", "{}");
    file.add("animations", R"({"samplers":[{"input":0,"output":1}],
                               "channels":[{"sampler":0,"target":{"node":0,"path":"scale"}}]})");
    EXPECT_EQ(channelOf(file).interpolation, candela::Interpolation::linear);
}

TEST(Animation, weightsOfANodeWithoutTargetsAreNoted) {
    const candela::ImportedScene imported =
        load(animatedFile<float>("weights", "SCALAR", {0, 1, 0}, "LINEAR"));
    EXPECT_TRUE(imported.scene.animations.empty());
    EXPECT_TRUE(hasNote(imported, "animation 0 'walk', channel 0: node 1 has no mesh with morph targets"));
}

TEST(Animation, channelsWithoutANodeAreIgnored) {
    GltfFile file;
    file.addData<float>("SCALAR", {0});
    file.addData<float>("VEC3", {1, 2, 3});
    file.add("nodes", "{}");
    file.add("animations", R"({"samplers":[{"input":0,"output":1}],
                               "channels":[{"sampler":0,"target":{"path":"pointer"}},
                                           {"sampler":0,"target":{"node":0,"path":"scale"}}]})");
    EXPECT_EQ(load(file).scene.animations.at(0).channels.size(), 1u);
}

TEST(Animation, ofNodesOutsideTheSceneIsOmitted) {
    GltfFile file = animatedFile<float>("scale", "VEC3", {1, 1, 1, 2, 2, 2, 3, 3, 3}, "STEP");
    file.add("scenes", R"({"nodes":[0]})");
    EXPECT_TRUE(load(file).scene.animations.empty());
}

}  // namespace
}  // namespace candela_test
