#include <candela/error.h>
#include <candela/refined_cage.h>
#include <candela/scene.h>

#include "base/error_context.h"
#include "fuzz_input.h"
#include "sample_cage_scene.h"
#include "support/fuzz_iterations.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>

#include <cmath>

namespace candela {
namespace {

void corruptTopology(Cage& cage, FuzzInput& fuzz) {
    switch (fuzz.below(7)) {
        case 0:
            fuzz.setOne(cage.faceSizes, fuzz.index());
            break;
        case 1:
            fuzz.setOne(cage.faceVertices, fuzz.index());
            break;
        case 2:
            if (!cage.faceVertices.empty())
                std::swap(fuzz.pick(cage.faceVertices), fuzz.pick(cage.faceVertices));
            break;
        case 3:
            cage.faceVertices.resize(fuzz.below(30));
            break;
        case 4:
            cage.faceUvs.assign(fuzz.once(2) ? cage.faceVertices.size() : fuzz.below(30), fuzz.index());
            break;
        case 5:
            cage.positions.resize(fuzz.below(12));
            break;
        default:
            cage.scheme = static_cast<SubdivisionScheme>(fuzz.below(4));
            break;
    }
}

void corruptTags(Cage& cage, FuzzInput& fuzz) {
    switch (fuzz.below(6)) {
        case 0:
            cage.creases.push_back({fuzz.index(), fuzz.index(), fuzz.number()});
            break;
        case 1:
            cage.corners.push_back({fuzz.index(), fuzz.number()});
            break;
        case 2:
            cage.holes.assign(fuzz.below(8), fuzz.index());
            break;
        case 3:
            cage.faceMaterials.assign(fuzz.once(2) ? cage.faceSizes.size() : fuzz.below(8), fuzz.index());
            break;
        case 4:
            cage.level = fuzz.index();
            break;
        default:
            cage.faceVaryingInterpolation = static_cast<FaceVaryingInterpolation>(fuzz.below(8));
            break;
    }
}

void corruptMotion(Cage& cage, FuzzInput& fuzz) {
    switch (fuzz.below(6)) {
        case 0:
            cage.influenceCount = fuzz.index();
            break;
        case 1:
            fuzz.setOne(cage.joints, fuzz.index());
            break;
        case 2:
            fuzz.setOne(cage.jointWeights, fuzz.number());
            break;
        case 3:
            cage.morphTargets.resize(fuzz.below(4));
            break;
        case 4:
            if (!cage.morphTargets.empty()) cage.morphTargets[0].offsets.resize(fuzz.below(12));
            break;
        default:
            if (!cage.positions.empty()) fuzz.corrupt(fuzz.pick(cage.positions));
            break;
    }
}

void corruptInstance(Node& node, FuzzInput& fuzz) {
    if (!node.cage) node.cage = 0;
    switch (fuzz.below(3)) {
        case 0:
            node.cage = fuzz.index();
            break;
        case 1:
            node.skin = fuzz.index();
            break;
        default:
            node.morphWeights.assign(fuzz.below(4), fuzz.number());
            break;
    }
}

void corruptSkin(Skin& skin, FuzzInput& fuzz) {
    switch (fuzz.below(4)) {
        case 0:
            fuzz.setOne(skin.joints, fuzz.index());
            break;
        case 1:
            skin.joints.resize(1 + fuzz.below(3));
            break;
        case 2:
            skin.inverseBindMatrices.resize(1 + fuzz.below(3), glm::mat4(1.0f));
            break;
        default:
            fuzz.corrupt(fuzz.pick(skin.inverseBindMatrices)[static_cast<int>(fuzz.below(4))]);
            break;
    }
}

void corruptChannel(AnimationChannel& channel, FuzzInput& fuzz) {
    switch (fuzz.below(4)) {
        case 0:
            channel.node = fuzz.index();
            break;
        case 1:
            channel.path = static_cast<AnimationPath>(fuzz.below(5));
            break;
        case 2:
            channel.interpolation = static_cast<Interpolation>(fuzz.below(4));
            break;
        default:
            fuzz.setOne(channel.values, fuzz.number());
            break;
    }
}

Scene randomScene(FuzzInput& fuzz) {
    Scene scene = sampleCageScene();
    if (fuzz.once(2)) scene.animations.clear();
    for (std::uint32_t changes = 1 + fuzz.below(2); changes > 0; --changes) {
        switch (fuzz.below(6)) {
            case 0:
                corruptTopology(fuzz.pick(scene.cages), fuzz);
                break;
            case 1:
                corruptTags(fuzz.pick(scene.cages), fuzz);
                break;
            case 2:
                corruptMotion(fuzz.pick(scene.cages), fuzz);
                break;
            case 3:
                corruptInstance(fuzz.pick(scene.nodes), fuzz);
                break;
            case 4:
                corruptSkin(scene.skins[0], fuzz);
                break;
            default:
                if (!scene.animations.empty()) corruptChannel(fuzz.pick(scene.animations[0].channels), fuzz);
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

void expectPositionsInRange(const Scene& scene) {
    const std::vector<glm::mat4> world = worldTransforms(scene);
    for (std::uint32_t node = 0; node < scene.nodes.size(); ++node) {
        if (!scene.nodes[node].cage) continue;
        const PosedPoints posed = poseCage(scene, node, world);
        ASSERT_EQ(posed.points.size(), scene.cages[*scene.nodes[node].cage].positions.size());
        for (const glm::vec3& point : posed.points) {
            const glm::vec3 position(posed.worldFromPoints * glm::vec4(point, 1.0f));
            for (int axis = 0; axis < 3; ++axis) ASSERT_LE(std::abs(position[axis]), 1e9f);
        }
    }
    ASSERT_TRUE(allFinite(frameBounds(worldBounds(scene, world), 1.5f).worldFromCamera));
}

void expectValidPolygons(const Cage& cage) {
    const RefinedCage polygons = cagePolygons(cage);
    for (const std::uint32_t vertex : polygons.faceVertices) ASSERT_LT(vertex, polygons.vertexCount());
    for (const std::uint32_t face : polygons.cageFaces) ASSERT_LT(face, cage.faceSizes.size());
    for (const std::uint32_t point : polygons.positions.controlIndices)
        ASSERT_LT(point, cage.positions.size());
    for (const std::uint32_t uv : polygons.uvs.controlIndices) ASSERT_LT(uv, cage.uvs.size());
}

// Scenes that pass validation can be posed at any time and drawn as polygons.
TEST(CageFuzz, ValidCagesAreUsableAndOthersAreRefused) {
    std::uint32_t valid = 0;
    const std::uint32_t rounds = candela_test::fuzzIterations<std::uint32_t>(20'000);
    for (std::uint32_t seed = 0; seed < rounds; ++seed) {
        FuzzInput fuzz(seed);
        const Scene scene = randomScene(fuzz);
        if (!isValid(scene)) continue;
        ++valid;
        expectPositionsInRange(scene);
        for (const Cage& cage : scene.cages) expectValidPolygons(cage);
        for (const double time : {-1e300, 0.25, 1e300}) {
            worldBounds(scene, worldTransforms(scene, time), time);
        }
        if (HasFatalFailure()) FAIL() << "seed " << seed;
    }
    // The scenes have to exercise both outcomes.
    EXPECT_GT(valid, rounds / 20);
    EXPECT_LT(valid, rounds * 19 / 20);
}

}  // namespace
}  // namespace candela
