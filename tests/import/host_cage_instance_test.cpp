// What the host accepts and refuses of skins, of cage instances and of animated morph weights.
#include "expect_error.h"
#include "host_calls.h"
#include "import_samples.h"

#include <candela/scene.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

namespace candela {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

using Add = std::function<void(const candela_host&)>;

void expectRefused(const Add& addElements, const std::string& text) {
    EXPECT_EQ(expectError([&] { importedScene(addElements); }, ErrorKind::badInput, ""), "test: " + text);
}

// Two nodes, a cage and a skin.
void addRequiredElements(const candela_host& host) {
    add(host, samples::node());
    add(host, samples::node());
    add(host, samples::cage());
    add(host, samples::skin());
}

void expectSkinRefused(const std::function<void(candela_skin&)>& modify, const std::string& text) {
    expectRefused(
        [&](const candela_host& host) {
            addRequiredElements(host);
            add(host, modified(samples::skin(), modify));
        },
        "skin 1 'rig': " + text);
}

void expectInstanceRefused(const std::function<void(candela_cage_instance&)>& modify,
                           const std::string& text) {
    expectRefused(
        [&](const candela_host& host) {
            addRequiredElements(host);
            add(host, modified(samples::cageInstance(), modify));
        },
        text);
}

TEST(HostSkin, CopiesWhatIsAdded) {
    std::array<float, 32> matrices{};
    for (std::size_t i = 0; i < 16; ++i) matrices[i] = matrices[16 + i] = samples::identity[i];
    matrices[16 + 13] = 7.0f;
    const Scene scene = importedScene([&](const candela_host& host) {
        addRequiredElements(host);
        add(host,
            modified(samples::skin(), [&](candela_skin& s) { s.inverse_bind_matrices = matrices.data(); }));
    });
    ASSERT_EQ(scene.skins.size(), 2u);
    EXPECT_EQ(scene.skins[0].name, "rig");
    EXPECT_EQ(scene.skins[0].joints, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(scene.skins[0].inverseBindMatrices, std::vector(2, glm::mat4(1.0f))) << "NULL is identity";
    ASSERT_EQ(scene.skins[1].inverseBindMatrices.size(), 2u);
    EXPECT_EQ(scene.skins[1].inverseBindMatrices[1][3], glm::vec4(0, 7, 0, 1));
}

TEST(HostSkinRefuses, AndNamesTheJoint) {
    expectSkinRefused([](candela_skin& s) { s.joint_count = 0; },
                      "joint_count is 0, but 1 or more was expected");
    expectSkinRefused([](candela_skin& s) { s.joints = nullptr; }, "joints is NULL, but joint_count is 2");
    const std::int32_t none[] = {0, -1}, later[] = {2, 0};
    expectSkinRefused([&](candela_skin& s) { s.joints = none; }, "joint 1 is -1, but a node was expected");
    expectSkinRefused([&](candela_skin& s) { s.joints = later; },
                      "joint 0 is 2, but 2 were added so far and -1 is none");
    auto matrix = samples::identity;
    const auto single = [&](candela_skin& s) {
        s.joint_count = 1;
        s.inverse_bind_matrices = matrix.data();
    };
    matrix[7] = 2.0f;
    expectSkinRefused(single,
                      "inverse_bind_matrix 0 is not affine: the last number of column 1 is 2, but 0 was "
                      "expected");
    matrix[7] = nan;
    expectSkinRefused(single,
                      "inverse_bind_matrix 0 has the component nan, but finite numbers were expected");
}

TEST(HostCageInstance, CopiesWhatIsAdded) {
    const Scene scene = importedScene([](const candela_host& host) {
        addRequiredElements(host);
        add(host, samples::cageInstance());
        add(host, modified(samples::cageInstance(), [](candela_cage_instance& s) {
                s.node = 1;
                s.skin = -1;
                s.morph_weight_count = 0;
                s.morph_weights = nullptr;
            }));
    });
    const Node& shown = scene.nodes.at(0);
    EXPECT_EQ(shown.cage, 0u);
    EXPECT_EQ(shown.skin, 0u);
    EXPECT_EQ(shown.morphWeights, (std::vector<float>{0.25f, 0.5f}));
    const Node& plain = scene.nodes.at(1);
    EXPECT_TRUE(plain.cage);
    EXPECT_FALSE(plain.skin);
    EXPECT_TRUE(plain.morphWeights.empty());
}

TEST(HostCageInstanceRefuses, AndNamesTheNode) {
    expectInstanceRefused([](candela_cage_instance& s) { s.node = -1; },
                          "add_cage_instance: node is -1, but a node was expected");
    expectInstanceRefused([](candela_cage_instance& s) { s.node = 2; },
                          "add_cage_instance: node is 2, but 2 were added so far and -1 is none");
    expectInstanceRefused([](candela_cage_instance& s) { s.cage = -1; },
                          "node 0 'axle': cage is -1, but a cage was expected");
    expectInstanceRefused([](candela_cage_instance& s) { s.cage = 1; },
                          "node 0 'axle': cage is 1, but 1 were added so far and -1 is none");
    expectInstanceRefused([](candela_cage_instance& s) { s.skin = 1; },
                          "node 0 'axle': skin is 1, but 1 were added so far and -1 is none");
    expectInstanceRefused([](candela_cage_instance& s) { s.morph_weight_count = 1; },
                          "node 0 'axle': morph_weight_count is 1, but cage 0 'body' has 2 morph targets");
    expectInstanceRefused([](candela_cage_instance& s) { s.morph_weights = nullptr; },
                          "node 0 'axle': morph_weight is NULL, but 2 elements were expected");
    const float weights[] = {0.0f, nan};
    expectInstanceRefused(
        [&](candela_cage_instance& s) { s.morph_weights = weights; },
        "node 0 'axle': morph_weight 1 has the component nan, but finite numbers were expected");
}

TEST(HostCageInstanceRefuses, ASecondCage) {
    expectRefused(
        [](const candela_host& host) {
            addRequiredElements(host);
            add(host, samples::cageInstance());
            add(host, samples::cageInstance());
        },
        "node 0 'axle': it has an instance of cage 0 'body' already, and can not have another");
}

constexpr float morphKeys[] = {0, 0.5f, 1, 0};

void animateMorphWeights(candela_animation_channel& channel) {
    channel.path = CANDELA_ANIMATE_MORPH_WEIGHTS;
    channel.values = morphKeys;
}

void addAnimationOf(const candela_host& host, const candela_animation_channel& channel) {
    add(host, modified(samples::animation(), [&](candela_animation& a) { a.channels = &channel; }));
}

TEST(HostMorphAnimation, HasAWeightForEachTarget) {
    const Scene scene = importedScene([](const candela_host& host) {
        addRequiredElements(host);
        add(host, samples::cageInstance());
        addAnimationOf(host, modified(samples::channel, animateMorphWeights));
    });
    const AnimationChannel& channel = scene.animations.at(0).channels.at(0);
    EXPECT_EQ(channel.path, AnimationPath::morphWeights);
    EXPECT_EQ(channel.values, (std::vector<float>{0, 0.5f, 1, 0}));
}

// A node with a matrix cannot be animated, but its morph weights can.
TEST(HostMorphAnimation, AppliesToANodeWithAMatrix) {
    const Scene scene = importedScene([](const candela_host& host) {
        addRequiredElements(host);
        add(host, modified(samples::node(), [](candela_node& n) { n.matrix = samples::identity.data(); }));
        add(host, modified(samples::cageInstance(), [](candela_cage_instance& s) { s.node = 2; }));
        addAnimationOf(host, modified(samples::channel, [](candela_animation_channel& c) {
                           animateMorphWeights(c);
                           c.node = 2;
                       }));
    });
    EXPECT_EQ(scene.animations.at(0).channels.at(0).node, 2u);
}

TEST(HostMorphAnimation, NeedsACageWithTargets) {
    const std::string text =
        "animation 0 'roll': channel 0: node is 0, which has no mesh and no cage with morph targets";
    expectRefused(
        [](const candela_host& host) {
            addRequiredElements(host);
            addAnimationOf(host, modified(samples::channel, animateMorphWeights));
        },
        text);
    expectRefused(
        [](const candela_host& host) {
            addRequiredElements(host);
            add(host, modified(samples::cage(), [](candela_cage& c) { c.morph_target_count = 0; }));
            add(host, modified(samples::cageInstance(), [](candela_cage_instance& s) {
                    s.cage = 1;
                    s.morph_weight_count = 0;
                }));
            addAnimationOf(host, modified(samples::channel, animateMorphWeights));
        },
        text);
}

}  // namespace
}  // namespace candela
