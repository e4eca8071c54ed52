#include <candela/error.h>
#include <candela/refined_cage.h>
#include <candela/scene.h>

#include "dice.h"
#include "sample_cage_scene.h"
#include "base/error_context.h"
#include "support/fuzz_iterations.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>

namespace candela {
namespace {

void spoilTopology(Cage& cage, Dice& dice) {
    switch (dice.below(7)) {
        case 0:
            dice.pick(cage.faceSizes) = dice.index();
            break;
        case 1:
            dice.pick(cage.faceVertices) = dice.index();
            break;
        case 2:
            std::swap(dice.pick(cage.faceVertices), dice.pick(cage.faceVertices));
            break;
        case 3:
            cage.faceVertices.resize(dice.below(30));
            break;
        case 4:
            cage.faceUvs.assign(dice.once(2) ? cage.faceVertices.size() : dice.below(30), dice.index());
            break;
        case 5:
            cage.positions.resize(dice.below(12));
            break;
        default:
            cage.scheme = static_cast<SubdivisionScheme>(dice.below(4));
            break;
    }
}

void spoilTags(Cage& cage, Dice& dice) {
    switch (dice.below(6)) {
        case 0:
            cage.creases.push_back({dice.index(), dice.index(), dice.number()});
            break;
        case 1:
            cage.corners.push_back({dice.index(), dice.number()});
            break;
        case 2:
            cage.holes.assign(dice.below(8), dice.index());
            break;
        case 3:
            cage.faceMaterials.assign(dice.once(2) ? cage.faceSizes.size() : dice.below(8), dice.index());
            break;
        case 4:
            cage.level = dice.index();
            break;
        default:
            cage.faceVaryingInterpolation = static_cast<FaceVaryingInterpolation>(dice.below(8));
            break;
    }
}

void spoilMotion(Cage& cage, Dice& dice) {
    switch (dice.below(6)) {
        case 0:
            cage.influenceCount = dice.index();
            break;
        case 1:
            if (!cage.joints.empty()) dice.pick(cage.joints) = dice.index();
            break;
        case 2:
            if (!cage.jointWeights.empty()) dice.pick(cage.jointWeights) = dice.number();
            break;
        case 3:
            cage.morphTargets.resize(dice.below(4));
            break;
        case 4:
            if (!cage.morphTargets.empty()) cage.morphTargets[0].offsets.resize(dice.below(12));
            break;
        default:
            if (!cage.positions.empty()) dice.spoil(dice.pick(cage.positions));
            break;
    }
}

void spoilShown(Node& node, Dice& dice) {
    if (!node.cage) node.cage.emplace();
    switch (dice.below(3)) {
        case 0:
            node.cage->cage = dice.index();
            break;
        case 1:
            node.cage->skin = dice.index();
            break;
        default:
            node.cage->morphWeights.assign(dice.below(4), dice.number());
            break;
    }
}

void spoilSkin(Skin& skin, Dice& dice) {
    switch (dice.below(4)) {
        case 0:
            dice.pick(skin.joints) = dice.index();
            break;
        case 1:
            skin.joints.resize(1 + dice.below(3));
            break;
        case 2:
            skin.inverseBindMatrices.resize(1 + dice.below(3), glm::mat4(1.0f));
            break;
        default:
            dice.spoil(dice.pick(skin.inverseBindMatrices)[static_cast<int>(dice.below(4))]);
            break;
    }
}

void spoilChannel(AnimationChannel& channel, Dice& dice) {
    switch (dice.below(4)) {
        case 0:
            channel.node = dice.index();
            break;
        case 1:
            channel.path = static_cast<AnimationPath>(dice.below(5));
            break;
        case 2:
            channel.interpolation = static_cast<Interpolation>(dice.below(4));
            break;
        default:
            dice.pick(channel.values) = dice.number();
            break;
    }
}

Scene oddScene(Dice& dice) {
    Scene scene = sampleCageScene();
    if (dice.once(2)) scene.animations.clear();
    for (std::uint32_t changes = 1 + dice.below(2); changes > 0; --changes) {
        switch (dice.below(6)) {
            case 0:
                spoilTopology(dice.pick(scene.cages), dice);
                break;
            case 1:
                spoilTags(dice.pick(scene.cages), dice);
                break;
            case 2:
                spoilMotion(dice.pick(scene.cages), dice);
                break;
            case 3:
                spoilShown(dice.pick(scene.nodes), dice);
                break;
            case 4:
                spoilSkin(scene.skins[0], dice);
                break;
            default:
                if (!scene.animations.empty()) spoilChannel(dice.pick(scene.animations[0].channels), dice);
                break;
        }
    }
    return scene;
}

bool isValid(const Scene& scene) {
    try {
        validate(scene);
        return true;
    } catch (const Error&) {
        return false;
    }
}

void expectNearPlaces(const Scene& scene) {
    const std::vector<glm::mat4> world = worldTransforms(scene);
    for (std::uint32_t node = 0; node < scene.nodes.size(); ++node) {
        if (!scene.nodes[node].cage) continue;
        const PosedCage posed = poseCage(scene, node, world);
        ASSERT_EQ(posed.points.size(), scene.cages[scene.nodes[node].cage->cage].positions.size());
        for (const glm::vec3& point : posed.points) {
            const glm::vec3 place(posed.worldFromPoints * glm::vec4(point, 1.0f));
            for (int axis = 0; axis < 3; ++axis) ASSERT_LE(std::abs(place[axis]), 1e9f);
        }
    }
    ASSERT_TRUE(allFinite(frameBounds(worldBounds(scene, world), 1.5f).worldFromCamera));
}

void expectSoundPolygons(const Cage& cage) {
    const RefinedCage polygons = cagePolygons(cage);
    for (const std::uint32_t vertex : polygons.faceVertices) ASSERT_LT(vertex, polygons.vertexCount());
    for (const std::uint32_t face : polygons.cageFaces) ASSERT_LT(face, cage.faceSizes.size());
    for (const std::uint32_t point : polygons.positions.columns) ASSERT_LT(point, cage.positions.size());
    for (const std::uint32_t uv : polygons.uvs.columns) ASSERT_LT(uv, cage.uvs.size());
}

// What validation lets through can be posed at any time and drawn as polygons, and never crashes.
TEST(CageFuzz, ValidCagesAreUsableAndOthersAreRefused) {
    std::uint32_t valid = 0;
    const std::uint32_t rounds = candela_test::fuzzIterations<std::uint32_t>(20'000);
    for (std::uint32_t seed = 0; seed < rounds; ++seed) {
        Dice dice(seed);
        const Scene scene = oddScene(dice);
        if (!isValid(scene)) continue;
        ++valid;
        expectNearPlaces(scene);
        for (const Cage& cage : scene.cages) expectSoundPolygons(cage);
        for (const double time : {-1e300, 0.25, 1e300}) {
            worldBounds(scene, worldTransforms(scene, time), time);
        }
        if (HasFatalFailure()) FAIL() << "seed " << seed;
    }
    // The test means something only if both ways are taken often.
    EXPECT_GT(valid, rounds / 20);
    EXPECT_LT(valid, rounds * 19 / 20);
}

}  // namespace
}  // namespace candela
