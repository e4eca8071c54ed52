// Shadows of surfaces that change, and of scenes that are hard on single precision or large.

#include "occlusion/shadow_fixture.h"
#include "support/cage_scenes.h"
#include "support/random_rig.h"

#include <glm/gtc/matrix_transform.hpp>

#include <span>
#include <variant>
#include <vector>

namespace candela::test {
namespace {

/// Skins cast the shadows of where they stand, those out of view included.
TEST_F(ShadowTest, deformedMesh) {
    Scene scene = randomRig(5, {.vertices = 120, .joints = 8});
    place(scene, makeBox({6.0f, 0.1f, 6.0f}), grey(), at({0, -4.0f, 0}));
    poseRandomly(scene, 9);
    const std::vector<glm::mat4> world = worldTransforms(scene);
    std::vector<Triangle> triangles;
    Mesh posed = scene.meshes[*scene.nodes[0].mesh];
    const DeformedVertices vertices = evaluateDeformation(scene, 0, world);
    for (std::size_t i = 0; i < posed.indices.size(); i += 3) {
        Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k) triangle.corners[k] = vertices.positions[posed.indices[i + k]];
        triangles.push_back(triangle);
    }
    addTriangles(triangles, scene.meshes.back(), world.back());
    // The rig is behind the eye.
    const Tally tally =
        compare(scene, triangles, scatteredLights(6, 120), lookAt({0, -2.5f, 5}, {0, -4, 2}, 0.9f));
    EXPECT_GT(tally.blocked, 50);
}

/// The limit surface of a cube of sharp edges is the cube, also after its points have moved.
TEST_F(ShadowTest, subdividedSurfaceAfterAMove) {
    Scene scene = sceneOf(makeBox({4.0f, 0.1f, 4.0f}), grey(), at({0, -0.1f, 0}));
    const std::uint32_t cage = placeCage(scene, makeSharpCubeCage(0.4f), grey(), at({0, 1, 0}));
    GpuScene uploaded(context(), scene, subdividing(2));
    const CameraView view = lookAt({0, 3, 6}, {0, 0.5f, 0}, 0.9f);
    const auto expectCubeAt = [&](const glm::mat4& matrix) {
        std::vector<Triangle> triangles = trianglesOf(scene);
        addTriangles(triangles, makeBox(glm::vec3(0.4f)), matrix);
        const Tally tally = compare(uploaded, triangles, scatteredLights(4, 140), view);
        EXPECT_GT(tally.blocked, 200);
    };
    expectCubeAt(at({0, 1, 0}));
    std::vector<glm::vec3> points = scene.cages[0].positions;
    for (glm::vec3& point : points) point = 1.5f * point + glm::vec3(0.7f, 0.2f, 0.3f);
    uploaded.setCagePoints(cage, points);
    expectCubeAt(glm::scale(at({0.7f, 1.2f, 0.3f}), glm::vec3(1.5f)));
}

/// From inside of a closed box.
TEST_F(ShadowTest, cameraInAClosedBox) {
    const Scene scene = sceneOf(makeBox({2, 2, 2}), [] {
        Material material = grey();
        material.doubleSided = true;
        return material;
    }());
    const CameraView view = lookAt({0.5f, 0.3f, 1.0f}, {-1, 0, -2}, 1.0f);
    GpuScene outside = upload(scene, std::vector{pointLight({0, 5, 0}, 0.0f, glm::vec3(100.0f)),
                                                 directionalLight({0.3f, -1, 0.2f}, glm::vec3(5.0f))});
    const HdrImage dark = drawnWith(outside, view, Shadows::on);
    for (std::size_t i = 0; i < dark.rgba.size(); i += 4) ASSERT_EQ(dark.rgba[i], 0.0f) << i / 4;
    GpuScene inside = upload(scene, std::vector{pointLight({0.2f, 1.5f, -0.3f}, 0.0f, glm::vec3(10.0f))});
    EXPECT_EQ(drawnWith(inside, view, Shadows::on).rgba, drawnWith(inside, view, Shadows::off).rgba);
}

/// A scene 500 km away, with the origin there, has the shadows of one at the origin.
TEST_F(ShadowTest, fiveHundredKilometresAway) {
    const Scene scene = boxesOnAFloor();
    Scene far = scene;
    far.origin = {5.0e5, 0.0, -3.0e5};
    for (Node& node : far.nodes) {
        glm::mat4& matrix = std::get<glm::mat4>(node.transform);
        const glm::dvec3 position = glm::dvec3(matrix[3]) + far.origin;
        matrix[3] = glm::vec4(glm::vec3(position), 1.0f);
        node.translationRemainder = position - glm::dvec3(glm::vec3(position));
    }
    const std::vector<WorldLight> lights = scatteredLights(5, 160);
    const CameraView view = lookAt({0, 3, 6}, {0, 0.5f, 0}, 0.9f);
    GpuScene nearby = upload(scene, lights), away = upload(far, lights);
    EXPECT_EQ(drawnWith(away, view, Shadows::on).rgba, drawnWith(nearby, view, Shadows::on).rgba);
}

/// 65,536 lights give what they give in sixteen parts.
TEST_F(ShadowTest, manyLights) {
    const Scene scene = boxesOnAFloor();
    std::vector<WorldLight> lights = scatteredLights(65536, 180);
    for (WorldLight& light : lights) light.range = 1.0f;
    const CameraView view = lookAt({0, 3, 6}, {0, 0.5f, 0}, 0.9f);
    GpuScene all = upload(scene, lights);
    const HdrImage whole = drawnWith(all, view, Shadows::on);
    std::vector<double> sum(whole.rgba.size());
    for (std::size_t part = 0; part < 16; ++part) {
        all.setLights(std::span(lights).subspan(part * 4096, 4096));
        const HdrImage picture = drawnWith(all, view, Shadows::on);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += picture.rgba[i];
    }
    for (std::size_t i = 0; i < sum.size(); i += 4) {
        // Thousands of lights a pixel, each sum rounded: 2^-24 of it times the square root of their number.
        ASSERT_NEAR(whole.rgba[i], sum[i], 2e-5 * sum[i]) << i / 4;
    }
}

}  // namespace
}  // namespace candela::test
