#include <candela/error.h>
#include <candela/scene.h>

#include "dice.h"
#include "sample_scene.h"
#include "scene/geometry/normals.h"
#include "scene/geometry/tangents.h"
#include "base/error_context.h"
#include "support/fuzz_iterations.h"

#include <gtest/gtest.h>

#include <cmath>

namespace candela {
namespace {

void spoilMesh(Mesh& mesh, Dice& dice) {
    switch (dice.below(9)) {
        case 0:
            dice.spoil(dice.pick(mesh.positions));
            break;
        case 1:
            dice.spoil(dice.pick(mesh.normals));
            break;
        case 2:
            dice.spoil(dice.pick(mesh.uv0));
            break;
        case 3:
            dice.pick(mesh.indices) = dice.index();
            break;
        case 4:
            dice.pick(mesh.submeshes).firstIndex = dice.index();
            break;
        case 5:
            dice.pick(mesh.submeshes).indexCount = dice.index();
            break;
        case 6:
            dice.pick(mesh.submeshes).material = dice.index();
            break;
        case 7:
            mesh.uv1.resize(dice.below(6));
            break;
        default:
            dice.spoil(dice.pick(mesh.tangents));
            break;
    }
}

void spoilNode(Node& node, Dice& dice) {
    switch (dice.below(5)) {
        case 0:
            node.parent = dice.index();
            break;
        case 1:
            node.mesh = dice.index();
            break;
        case 2: {
            glm::mat4 matrix(1.0f);
            dice.spoil(matrix[static_cast<int>(dice.below(4))]);
            node.transform = matrix;
            break;
        }
        default: {
            Transform trs;
            dice.spoil(trs.translation);
            if (dice.once(2)) dice.spoil(trs.scale);
            if (dice.once(2)) trs.rotation = glm::quat(dice.number(), 0.0f, dice.number(), 0.0f);
            node.transform = trs;
        }
    }
}

void spoilLight(Light& light, Dice& dice) {
    switch (dice.below(7)) {
        case 0:
            dice.spoil(light.color);
            break;
        case 1:
            light.intensity = dice.number();
            break;
        case 2:
            light.range = dice.number();
            break;
        case 3:
            light.outerConeAngle = dice.number();
            break;
        case 4:
            dice.spoil(light.position);
            break;
        case 5:
            dice.spoil(light.direction);
            break;
        default:
            light.node = dice.index();
            break;
    }
}

void spoilChannel(AnimationChannel& channel, Dice& dice) {
    switch (dice.below(6)) {
        case 0:
            channel.node = dice.index();
            break;
        case 1:
            channel.path = static_cast<AnimationPath>(dice.below(5));
            break;
        case 2:
            channel.interpolation = static_cast<Interpolation>(dice.below(4));
            break;
        case 3:
            channel.times.assign(dice.below(3), dice.number());
            break;
        case 4:
            channel.values.resize(dice.below(20));
            break;
        default:
            dice.pick(channel.values) = dice.number();
            break;
    }
}

void spoilMaterial(Material& material, Dice& dice) {
    switch (dice.below(5)) {
        case 0:
            dice.spoil(material.baseColor);
            break;
        case 1:
            dice.spoil(material.emission);
            break;
        case 2:
            material.roughness = dice.number();
            break;
        case 3:
            material.baseColorTexture->image = dice.index();
            break;
        default:
            material.baseColorTexture->uvSet = dice.index();
            break;
    }
}

void spoilCamera(Camera& camera, Dice& dice) {
    if (dice.once(2)) camera.verticalFov = dice.number();
    if (dice.once(2)) camera.nearPlane = dice.number();
    if (dice.once(4)) camera.node = dice.index();
}

Scene oddScene(Dice& dice) {
    Scene scene = sampleScene();
    if (dice.once(2)) scene.animations.clear();
    for (std::uint32_t changes = 1 + dice.below(2); changes > 0; --changes) {
        switch (dice.below(7)) {
            case 0:
                spoilMesh(scene.meshes[0], dice);
                break;
            case 1:
                spoilMaterial(scene.materials[0], dice);
                break;
            case 2:
                spoilLight(dice.pick(scene.lights), dice);
                break;
            case 3:
                spoilCamera(scene.cameras[0], dice);
                break;
            case 4:
                if (!scene.animations.empty()) spoilChannel(dice.pick(scene.animations[0].channels), dice);
                break;
            default:
                spoilNode(dice.pick(scene.nodes), dice);
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

// What validation lets through gives finite places, at any time, and never crashes.
void expectUsable(const Scene& scene) {
    const std::vector<glm::mat4> atStart = worldTransforms(scene);
    for (const glm::mat4& matrix : atStart) ASSERT_TRUE(allFinite(matrix));
    for (const WorldLight& light : worldLights(scene, atStart)) {
        ASSERT_TRUE(allFinite(light.position) && allFinite(light.intensity));
        ASSERT_TRUE(light.type == LightType::point || std::abs(glm::length(light.direction) - 1.0f) < 1e-5f);
    }
    const CameraView view = frameBounds(worldBounds(scene, atStart), 1.5f);
    ASSERT_TRUE(allFinite(view.worldFromCamera) && view.nearPlane > 0.0f);
    ASSERT_TRUE(allFinite(cameraView(scene, 0, atStart).worldFromCamera));
    EXPECT_LE(triangleCount(scene), 6u);
    for (const double time : {-1e300, 0.25, 1e300}) worldTransforms(scene, time);
}

TEST(SceneFuzz, ValidScenesAreUsableAndOthersAreRefused) {
    std::uint32_t valid = 0;
    const std::uint32_t rounds = candela_test::fuzzIterations<std::uint32_t>(20'000);
    for (std::uint32_t seed = 0; seed < rounds; ++seed) {
        Dice dice(seed);
        const Scene scene = oddScene(dice);
        if (!isValid(scene)) continue;
        ++valid;
        expectUsable(scene);
        if (HasFatalFailure()) FAIL() << "seed " << seed;
    }
    // The test means something only if both ways are taken often.
    EXPECT_GT(valid, rounds / 20);
    EXPECT_LT(valid, rounds * 19 / 20);
}

TEST(SceneFuzz, NormalsAndTangentsOfOddMeshesAreSoundOrRefused) {
    for (std::uint32_t seed = 0; seed < 20'000; ++seed) {
        Dice dice(seed);
        Mesh mesh = sampleScene().meshes[0];
        for (std::uint32_t changes = dice.below(6); changes > 0; --changes) spoilMesh(mesh, dice);
        try {
            if (dice.once(2)) {
                makeFlatNormals(mesh);
            } else {
                replaceZeroNormals(mesh);
            }
            for (const glm::vec3& normal : mesh.normals) ASSERT_TRUE(allFinite(normal)) << "seed " << seed;
            makeTangents(mesh, dice.below(2));
        } catch (const Error&) {
            continue;
        }
        ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
        for (const glm::vec4& tangent : mesh.tangents) {
            ASSERT_NEAR(glm::length(glm::vec3(tangent)), 1.0f, 1e-5f) << "seed " << seed;
        }
    }
}

}  // namespace
}  // namespace candela
