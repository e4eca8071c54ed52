#include <candela/error.h>
#include <candela/scene.h>

#include "base/error_context.h"
#include "fuzz_input.h"
#include "sample_scene.h"
#include "scene/geometry/normals.h"
#include "scene/geometry/tangents.h"
#include "support/fuzz_iterations.h"

#include <gtest/gtest.h>

#include <cmath>

namespace candela {
namespace {

void corruptMesh(Mesh& mesh, FuzzInput& fuzz) {
    switch (fuzz.below(9)) {
        case 0:
            fuzz.corrupt(fuzz.pick(mesh.positions));
            break;
        case 1:
            fuzz.corrupt(fuzz.pick(mesh.normals));
            break;
        case 2:
            fuzz.corrupt(fuzz.pick(mesh.uv0));
            break;
        case 3:
            fuzz.setOne(mesh.indices, fuzz.index());
            break;
        case 4:
            fuzz.pick(mesh.submeshes).firstIndex = fuzz.index();
            break;
        case 5:
            fuzz.pick(mesh.submeshes).indexCount = fuzz.index();
            break;
        case 6:
            fuzz.pick(mesh.submeshes).material = fuzz.index();
            break;
        case 7:
            mesh.uv1.resize(fuzz.below(6));
            mesh.furtherUvs.resize(fuzz.below(4), std::vector<glm::vec2>(fuzz.below(6)));
            break;
        default:
            fuzz.corrupt(fuzz.pick(mesh.tangents));
            break;
    }
}

void corruptNode(Node& node, FuzzInput& fuzz) {
    switch (fuzz.below(5)) {
        case 0:
            node.parent = fuzz.index();
            break;
        case 1:
            node.mesh = fuzz.index();
            break;
        case 2: {
            glm::mat4 matrix(1.0f);
            fuzz.corrupt(matrix[static_cast<int>(fuzz.below(4))]);
            node.transform = matrix;
            break;
        }
        default: {
            Transform trs;
            fuzz.corrupt(trs.translation);
            if (fuzz.once(2)) fuzz.corrupt(trs.scale);
            if (fuzz.once(2)) trs.rotation = glm::quat(fuzz.number(), 0.0f, fuzz.number(), 0.0f);
            node.transform = trs;
        }
    }
}

void corruptLight(Light& light, FuzzInput& fuzz) {
    switch (fuzz.below(8)) {
        case 0:
            fuzz.corrupt(light.color);
            break;
        case 1:
            light.intensity = fuzz.number();
            break;
        case 2:
            light.range = fuzz.number();
            break;
        case 3:
            light.outerConeAngle = fuzz.number();
            break;
        case 4:
            fuzz.corrupt(light.position);
            break;
        case 5:
            fuzz.corrupt(light.direction);
            break;
        case 6:
            light.radius = fuzz.number();
            break;
        default:
            light.node = fuzz.index();
            break;
    }
}

void corruptChannel(AnimationChannel& channel, FuzzInput& fuzz) {
    switch (fuzz.below(6)) {
        case 0:
            channel.node = fuzz.index();
            break;
        case 1:
            channel.path = static_cast<AnimationPath>(fuzz.below(5));
            break;
        case 2:
            channel.interpolation = static_cast<Interpolation>(fuzz.below(4));
            break;
        case 3:
            channel.times.assign(fuzz.below(3), fuzz.number());
            break;
        case 4:
            channel.values.resize(fuzz.below(20));
            break;
        default:
            fuzz.setOne(channel.values, fuzz.number());
            break;
    }
}

void corruptProperty(PropertyChannel& channel, FuzzInput& fuzz) {
    switch (fuzz.below(6)) {
        case 0:
            channel.property = static_cast<AnimatedProperty>(fuzz.below(44));
            channel.values.resize(2 * (1 + fuzz.below(4)));
            break;
        case 1:
            channel.element = fuzz.index();
            break;
        case 2:
            channel.texture = static_cast<TextureSlot>(fuzz.below(21));
            break;
        case 3:
            channel.interpolation = static_cast<Interpolation>(fuzz.below(4));
            break;
        case 4:
            channel.times.assign(fuzz.below(3), fuzz.number());
            break;
        default:
            fuzz.setOne(channel.values, fuzz.number());
            break;
    }
}

void corruptMaterial(Material& material, FuzzInput& fuzz) {
    switch (fuzz.below(5)) {
        case 0:
            fuzz.corrupt(material.baseColor);
            break;
        case 1:
            fuzz.corrupt(material.emission);
            break;
        case 2:
            material.roughness = fuzz.number();
            break;
        case 3:
            material.baseColorTexture->image = fuzz.index();
            break;
        default:
            material.baseColorTexture->uvSet = fuzz.index();
            break;
    }
}

void corruptCamera(Camera& camera, FuzzInput& fuzz) {
    if (fuzz.once(2)) camera.verticalFov = fuzz.number();
    if (fuzz.once(2)) camera.nearPlane = fuzz.number();
    if (fuzz.once(4)) camera.node = fuzz.index();
}

Scene randomScene(FuzzInput& fuzz) {
    Scene scene = sampleScene();
    scene.animations[0].properties.push_back(
        {AnimatedProperty::lightIntensity, 1, {}, Interpolation::linear, {0, 1}, {0, 5}});
    if (fuzz.once(2)) scene.animations.clear();
    for (std::uint32_t changes = 1 + fuzz.below(2); changes > 0; --changes) {
        switch (fuzz.below(8)) {
            case 5:
                if (!scene.animations.empty()) corruptProperty(scene.animations[0].properties[0], fuzz);
                break;
            case 0:
                corruptMesh(scene.meshes[0], fuzz);
                break;
            case 1:
                corruptMaterial(scene.materials[0], fuzz);
                break;
            case 2:
                corruptLight(fuzz.pick(scene.lights), fuzz);
                break;
            case 3:
                corruptCamera(scene.cameras[0], fuzz);
                break;
            case 4:
                if (!scene.animations.empty()) corruptChannel(fuzz.pick(scene.animations[0].channels), fuzz);
                break;
            default:
                corruptNode(fuzz.pick(scene.nodes), fuzz);
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

// Scenes that pass validation give finite positions at any time.
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
    for (const double time : {-1e300, 0.25, 1e300}) {
        worldTransforms(scene, time);
        Scene posed = scene;
        poseProperties(posed, time);
        ASSERT_NO_THROW(validate(posed));
    }
}

TEST(SceneFuzz, ValidScenesAreUsableAndOthersAreRefused) {
    std::uint32_t valid = 0;
    const std::uint32_t rounds = candela_test::fuzzIterations<std::uint32_t>(20'000);
    for (std::uint32_t seed = 0; seed < rounds; ++seed) {
        FuzzInput fuzz(seed);
        const Scene scene = randomScene(fuzz);
        if (!isValid(scene)) continue;
        ++valid;
        expectUsable(scene);
        if (HasFatalFailure()) FAIL() << "seed " << seed;
    }
    // The scenes have to exercise both outcomes.
    EXPECT_GT(valid, rounds / 20);
    EXPECT_LT(valid, rounds * 19 / 20);
}

TEST(SceneFuzz, NormalsAndTangentsOfCorruptMeshesAreValidOrRefused) {
    const std::uint32_t rounds = candela_test::fuzzIterations<std::uint32_t>(20'000);
    for (std::uint32_t seed = 0; seed < rounds; ++seed) {
        FuzzInput fuzz(seed);
        Mesh mesh = sampleScene().meshes[0];
        for (std::uint32_t changes = fuzz.below(6); changes > 0; --changes) corruptMesh(mesh, fuzz);
        try {
            if (fuzz.once(2)) {
                generateFlatNormals(mesh);
            } else {
                replaceZeroNormals(mesh);
            }
            for (const glm::vec3& normal : mesh.normals) ASSERT_TRUE(allFinite(normal)) << "seed " << seed;
            generateTangents(mesh, fuzz.below(2));
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
