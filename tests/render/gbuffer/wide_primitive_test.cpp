// Points and lines: which pixels they cover, and how they are lit.

#include "gbuffer/gbuffer_drawing.h"

#include <glm/gtc/matrix_transform.hpp>

#include <set>
#include <utility>
#include <vector>

namespace candela::test {
namespace {

using Pixels = std::set<std::pair<int, int>>;

/// The place in the plane z = 0 that the centre of a pixel shows.
glm::vec3 centerOf(int x, int y) {
    return {2.0f * (static_cast<float>(x) + 0.5f) / size - 1.0f,
            1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / size, 0.0f};
}

/// Without normals unless there is one for all.
Mesh meshOf(Topology topology, std::vector<glm::vec3> positions, const glm::vec3& normal = glm::vec3(0.0f)) {
    Mesh mesh;
    mesh.normals.assign(positions.size(), normal);
    for (std::uint32_t i = 0; i < positions.size(); ++i) mesh.indices.push_back(i);
    mesh.positions = std::move(positions);
    mesh.submeshes.push_back({0, static_cast<std::uint32_t>(mesh.indices.size()), 0, topology});
    return mesh;
}

/// From one pixel to the other, inclusive.
void addRectangle(Pixels& pixels, int left, int top, int right, int bottom) {
    for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) pixels.insert({x, y});
    }
}

Pixels rectangle(int left, int top, int right, int bottom) {
    Pixels pixels;
    addRectangle(pixels, left, top, right, bottom);
    return pixels;
}

class WidePrimitiveTest : public GBufferTest {
  protected:
    struct Sizes {
        float points = 3.0f, lines = 1.0f;
    };
    static FrameSettings settingsOf(const Sizes& sizes) {
        FrameSettings settings = frameOf(front).settings();
        settings.pointSize = sizes.points;
        settings.lineWidth = sizes.lines;
        return settings;
    }
    static Pixels covered(GpuScene& scene, const Sizes& sizes, const CameraView& view = front) {
        const HdrImage picture = renderer().render(scene, view, settingsOf(sizes)).radiance();
        Pixels pixels;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                if (picture.rgba[4 * static_cast<std::size_t>(y * size + x) + 3] > 0.0f)
                    pixels.insert({x, y});
            }
        }
        return pixels;
    }
    static Pixels covered(const Mesh& mesh, const Sizes& sizes, const CameraView& view = front) {
        GpuScene scene = upload(sceneOf(mesh, Material{}));
        return covered(scene, sizes, view);
    }
};

TEST_F(WidePrimitiveTest, aPointCoversASquare) {
    const Mesh point = meshOf(Topology::points, {centerOf(10, 20)});
    for (const int reach : {0, 1, 3}) {
        EXPECT_EQ(covered(point, {.points = static_cast<float>(2 * reach + 1)}),
                  rectangle(10 - reach, 20 - reach, 10 + reach, 20 + reach));
    }
}

TEST_F(WidePrimitiveTest, linesCoverRectanglesWithBothEnds) {
    for (const int reach : {0, 1, 2}) {
        const Sizes sizes{.lines = static_cast<float>(2 * reach + 1)};
        EXPECT_EQ(covered(meshOf(Topology::lines, {centerOf(5, 9), centerOf(20, 9)}), sizes),
                  rectangle(5 - reach, 9 - reach, 20 + reach, 9 + reach));
        EXPECT_EQ(covered(meshOf(Topology::lines, {centerOf(7, 25), centerOf(7, 4)}), sizes),
                  rectangle(7 - reach, 4 - reach, 7 + reach, 25 + reach));
    }
}

TEST_F(WidePrimitiveTest, diagonalsHaveTheirWidth) {
    // Pixels whose centres are less than half of the width beside the line.
    constexpr float width = 3.0f;
    const Pixels pixels =
        covered(meshOf(Topology::lines, {centerOf(4, 4), centerOf(28, 28)}), {.lines = width});
    for (int y = 8; y <= 24; ++y) {
        for (int x = 0; x < size; ++x) {
            const float distance = std::abs(static_cast<float>(x - y)) / std::sqrt(2.0f);
            EXPECT_EQ(pixels.contains({x, y}), distance < 0.5f * width) << x << ", " << y;
        }
    }
}

TEST_F(WidePrimitiveTest, aLineWithoutLengthIsASquare) {
    EXPECT_EQ(covered(meshOf(Topology::lines, {centerOf(5, 6), centerOf(5, 6)}), {.lines = 3.0f}),
              rectangle(4, 5, 6, 7));
}

TEST_F(WidePrimitiveTest, severalSubmeshesOfAMesh) {
    Mesh mesh = makeQuad(0.1f);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& position : {centerOf(2, 2), centerOf(2, 8), centerOf(30, 30)}) {
        mesh.positions.push_back(position);
        mesh.normals.emplace_back(0.0f);
        mesh.tangents.emplace_back(1, 0, 0, 1);
        mesh.uv0.emplace_back(0.0f);
    }
    for (std::uint32_t i = 0; i < 3; ++i) mesh.indices.push_back(first + i);
    mesh.submeshes = {{0, 6, 0}, {6, 2, 0, Topology::lines}, {8, 1, 0, Topology::points}};
    Pixels expected = rectangle(middle - 1, middle - 1, middle + 1, middle + 1);  // 0.2 m are 3.3 pixels.
    addRectangle(expected, 2, 2, 2, 8);
    addRectangle(expected, 29, 29, 31, 31);
    EXPECT_EQ(covered(mesh, {}), expected);
    const Scene scene = sceneOf(mesh, Material{});
    EXPECT_EQ(triangleCount(scene), 2u);
    const GpuScene uploaded = upload(scene);
    EXPECT_EQ(uploaded.elementCount(Topology::triangles), 2u);
    EXPECT_EQ(uploaded.elementCount(Topology::lines), 1u);
    EXPECT_EQ(uploaded.elementCount(Topology::points), 1u);
}

TEST_F(WidePrimitiveTest, aLineThroughTheNearPlaneIsClipped) {
    // From half a metre below the middle to far behind the eye: on the screen straight down.
    const Mesh line = meshOf(Topology::lines, {{0.0f, -0.5f, 0.0f}, {0.0f, -0.5f, 50.0f}});
    const int first = static_cast<int>(size * 0.75f);
    EXPECT_EQ(covered(line, {}), rectangle(middle, first, middle, size - 1));
    const Mesh behind = meshOf(Topology::lines, {{0.0f, -0.5f, 3.0f}, {0.0f, -0.5f, 50.0f}});
    EXPECT_EQ(covered(behind, {}), Pixels{});
    CameraView parallel = front;
    parallel.orthographicHeight = 2.0f;
    EXPECT_EQ(covered(line, {}, parallel), rectangle(middle, first, middle, first));
}

TEST_F(WidePrimitiveTest, depthIsThatOfTheLine) {
    const glm::vec3 a(-0.9f, 0.0f, -1.0f), b(0.9f, 0.0f, 1.0f);
    GpuScene scene = upload(sceneOf(meshOf(Topology::lines, {a, b}), Material{}));
    FrameSettings settings = settingsOf({.lines = 5.0f});
    const AovReader reader(renderer().render(scene, front, settings).aovs({"Z", "P"}), size);
    for (int x = 9; x < 20; ++x) {
        // The point of the line at this column.
        const float across = centerOf(x, middle).x / 3.0f;
        const float t = (across * (3.0f - a.z) - a.x) / (b.x - a.x + across * (b.z - a.z));
        const glm::vec3 expected = glm::mix(a, b, t);
        for (const int y : {middle - 2, middle, middle + 2}) {
            // Both ends round to 1/256 pixel.
            EXPECT_NEAR(reader.scalar("Z", x, y), 3.0f - expected.z, 2e-3f);
        }
        EXPECT_LT(glm::distance(reader.vector("P", x, middle), expected), 2e-3f);
    }
}

TEST_F(WidePrimitiveTest, withoutNormalsTheyShowBaseColourAndEmission) {
    Material material;
    material.baseColor = {0.25f, 0.5f, 1.0f, 1.0f};
    material.emission = {0.0f, 2.0f, 0.0f};
    const std::vector<WorldLight> lights{pointLight({0, 0, 1}, 10.0f, glm::vec3(5.0f))};
    for (const Topology topology : {Topology::points, Topology::lines}) {
        Mesh mesh = meshOf(topology, {{-0.5f, 0, 0}, {0.5f, 0, 0}});
        mesh.colors.assign(2, {0.5f, 0.25f, 1.0f, 1.0f});
        GpuScene scene = upload(sceneOf(mesh, material), lights);
        const Frame frame = renderer().render(scene, front, settingsOf({}));
        const int x = static_cast<int>(size * 0.25f);
        EXPECT_LT(glm::distance(pixelOf(frame.radiance(), x, middle), glm::vec3(0.125f, 2.125f, 1.0f)),
                  1e-6f);
        const auto probe = frame.probe(x, middle);
        ASSERT_TRUE(probe);
        EXPECT_EQ(probe->node, 0u);
        EXPECT_EQ(probe->normal, glm::vec3(0.0f));
    }
}

TEST_F(WidePrimitiveTest, withNormalsTheyAreLitAsSurfacesAre) {
    Material material;
    material.baseColor = {0.25f, 0.5f, 1.0f, 1.0f};
    const std::vector<WorldLight> lights{pointLight({0.5f, 0.5f, 1}, 10.0f, glm::vec3(5.0f))};
    const glm::vec3 expected =
        pixelOf(drawn(upload(sceneOf(makeQuad(1.0f), material), lights), frameOf(front)), middle, middle);
    ASSERT_GT(expected.x, 0.1f);
    for (const Shadows shadows : {Shadows::off, Shadows::automatic}) {
        for (const Topology topology : {Topology::points, Topology::lines}) {
            Material masked = material;  // Selects the textured program.
            masked.alphaMode = AlphaMode::mask;
            for (const Material& one : {material, masked}) {
                const Mesh mesh = meshOf(topology, {{0, 0, 0}, {0.5f, 0, 0}}, {0, 0, 1});
                GpuScene scene = upload(sceneOf(mesh, one), lights);
                FrameSettings settings = settingsOf({});
                settings.shadows = shadows;
                const glm::vec3 lit =
                    pixelOf(renderer().render(scene, front, settings).radiance(), middle, middle);
                // The textured program packs the base colour that the plain one is given packed.
                EXPECT_LT(glm::distance(lit, expected), 1e-3f * expected.x);
            }
        }
    }
}

TEST_F(WidePrimitiveTest, theyAreSeenFromAllSidesAndMirrored) {
    const CameraView behind = lookAt({0, 0, -3}, {0, 0, 0}, front.verticalFov);
    const Mesh mesh = meshOf(Topology::points, {{0, 0, 0}}, {0, 0, 1});
    EXPECT_EQ(covered(mesh, {.points = 1.0f}, behind), rectangle(middle, middle, middle, middle));
    const Scene mirrored = sceneOf(mesh, Material{}, glm::scale(glm::mat4(1.0f), {-1, 1, 1}));
    const AovReader reader = surfaces(mirrored);
    expectNormal(reader.vector("N", middle, middle), {0, 0, 1});
}

TEST_F(WidePrimitiveTest, masksLeaveThemOut) {
    Material material;
    material.alphaMode = AlphaMode::mask;
    material.alphaCutoff = 0.5f;
    Mesh mesh = meshOf(Topology::points, {centerOf(5, 5), centerOf(25, 5)});
    mesh.colors = {{1, 1, 1, 0.4f}, {1, 1, 1, 0.6f}};
    GpuScene scene = upload(sceneOf(mesh, material));
    EXPECT_EQ(covered(scene, {}), rectangle(24, 4, 26, 6));
}

TEST_F(WidePrimitiveTest, thoseBesideThePictureReachIntoIt) {
    const glm::vec3 outside = centerOf(-2, 10);
    EXPECT_EQ(covered(meshOf(Topology::points, {outside}), {.points = 7.0f}), rectangle(0, 7, 1, 13));
    EXPECT_EQ(covered(meshOf(Topology::points, {outside}), {.points = 3.0f}), Pixels{});
}

TEST_F(WidePrimitiveTest, theyCastNoShadows) {
    if (!hasShadows()) GTEST_SKIP() << "built without shadows";
    Scene scene = sceneOf(makeQuad(1.0f), Material{});
    FrameRequest request = frameOf(front);
    const std::vector<WorldLight> lights{pointLight({0, 0, 2}, 10.0f, glm::vec3(1.0f))};
    const HdrImage expected = drawn(upload(scene, lights), request);
    // Outside of the view, between the light and the surface.
    place(scene, meshOf(Topology::lines, {{-0.4f, 0.1f, 1.9f}, {0.4f, 0.1f, 1.9f}}), Material{},
          glm::translate(glm::mat4(1.0f), {0.0f, 1.0f, 0.0f}));
    request.shadows = Shadows::on;
    const HdrImage picture = drawn(upload(scene, lights), request);
    EXPECT_EQ(picture.rgba, expected.rgba);
}

TEST_F(WidePrimitiveTest, morphTargetsMoveThem) {
    Mesh mesh = meshOf(Topology::points, {centerOf(5, 5)});
    MorphTarget target;
    target.offsets = {centerOf(25, 20) - centerOf(5, 5)};
    mesh.morphTargets.push_back(target);
    Scene scene = sceneOf(mesh, Material{});
    scene.nodes[0].morphWeights = {1.0f};
    GpuScene uploaded = upload(scene);
    EXPECT_EQ(covered(uploaded, {}), rectangle(24, 19, 26, 21));
}

TEST_F(WidePrimitiveTest, wireframesAreOfTriangles) {
    GpuScene scene = upload(sceneOf(meshOf(Topology::lines, {{-1, 0, 0}, {1, 0, 0}}), Material{}));
    FrameSettings settings = settingsOf({});
    settings.overlays.wireframe = true;
    EXPECT_NO_THROW(renderer().render(scene, front, settings));
}

TEST_F(WidePrimitiveTest, sizesOutOfRangeAreErrors) {
    GpuScene scene = upload({});
    for (const float pixels : {0.0f, -1.0f, INFINITY, NAN}) {
        expectRefused([&] { renderer().render(scene, front, settingsOf({.points = pixels})); },
                      "the number has to be finite and over 0");
        expectRefused([&] { renderer().render(scene, front, settingsOf({.lines = pixels})); },
                      "the number has to be finite and over 0");
    }
}

}  // namespace
}  // namespace candela::test
