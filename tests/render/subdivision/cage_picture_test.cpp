// Images of cages: creases, seams, levels, materials.

#include "gbuffer/gbuffer_drawing.h"
#include "support/cage_scenes.h"

#include <candela/error.h>

#include <glm/gtc/matrix_transform.hpp>

#include <numbers>

namespace candela::test {
namespace {

constexpr int side = 96;

FrameRequest inputsOf(const CameraView& view, int pixels = side) {
    return {pixels, pixels, view, BrdfModel::course, Technique::fullscreen};
}

/// Looks along -Z from afar at the square of 2 m around the origin.
const CameraView far = lookAt({0, 0, 100}, {0, 0, 0}, 2.0f * std::atan(0.01f));

/// Rotates a cube so that an edge faces the camera, with faces to the left and to the right.
const glm::mat4 edgeOn = glm::rotate(glm::mat4(1.0f), std::numbers::pi_v<float> / 4.0f, {0, 1, 0});

class CagePictureTest : public DrawingTest {
  protected:
    static GpuScene uploadCages(const Scene& scene, const GpuSceneOptions& options) {
        return GpuScene(context(), scene, options);
    }
    static AovReader reader(auto&& scene, const CameraView& view) {
        render(scene, inputsOf(view));
        return aovs(side);
    }
};

TEST_F(CagePictureTest, infiniteCreasesAreSharp) {
    GpuScene scene = uploadCages(sceneOfCage(makeSharpCubeCage(0.6f), Material{}, edgeOn), subdividing(4));
    const AovReader picture = reader(scene, far);
    const float slope = std::sqrt(0.5f);
    for (const int y : {side / 3, side / 2, 2 * side / 3}) {
        // The edge lies between the two middle columns; faces are flat up to it.
        for (const int distance : {1, 2, 10, 30}) {
            expectNormal(picture.vector("N", side / 2 - distance, y), {-slope, 0, slope});
            expectNormal(picture.vector("N", side / 2 + distance - 1, y), {slope, 0, slope});
        }
    }
}

TEST_F(CagePictureTest, edgesWithoutCreasesAreSmooth) {
    GpuScene scene = uploadCages(sceneOfCage(makeCubeCage(0.8f), Material{}, edgeOn), subdividing(5));
    const AovReader picture = reader(scene, far);
    int compared = 0;
    for (int x = 1; x < side; ++x) {
        if (picture.scalar("Z", x, side / 2) == 0.0f || picture.scalar("Z", x - 1, side / 2) == 0.0f)
            continue;
        const glm::vec3 a = picture.vector("N", x - 1, side / 2), b = picture.vector("N", x, side / 2);
        // The surface curves no more than a sphere of half its width of 40 pixels; pixels near its
        // silhouette cover more of it and are left out.
        if (a.z < 0.5f || b.z < 0.5f) continue;
        EXPECT_LT(glm::distance(a, b), 2.0f * 2.0f / 40.0f) << x;
        ++compared;
    }
    EXPECT_GT(compared, 20);
    // The row lies half a pixel off the middle.
    const glm::vec3 left = picture.vector("N", side / 2 - 1, side / 2);
    expectNormal(0.5f * (left + picture.vector("N", side / 2, side / 2)), {0, 0, 1}, 1.0f / 40.0f);
}

TEST_F(CagePictureTest, withoutASubdividerThePolygonsAreDrawn) {
    const Scene scene = sceneOfCage(makeCubeCage(0.6f), Material{}, edgeOn);
    GpuScene uploaded = uploadCages(scene, {});
    const AovReader picture = reader(uploaded, far);
    const float slope = std::sqrt(0.5f);
    expectNormal(picture.vector("N", side / 2 - 2, side / 2), {-slope, 0, slope});
    expectNormal(picture.vector("N", side / 2 + 1, side / 2), {slope, 0, slope});
    const CageReport report = uploaded.cageReport();
    EXPECT_FALSE(report.subdivided);
    EXPECT_EQ(report.triangles, 12u);
    EXPECT_EQ(report.maxLevel, 0u);
    EXPECT_EQ(uploaded.state().levelOf(0), 0u);
}

TEST_F(CagePictureTest, closedSurfaceHasNoCracks) {
    for (const std::uint32_t level : {1u, 2u, 4u}) {
        for (std::uint32_t seed = 0; seed < 6; ++seed) {
            // Seams and creases create seam vertices.
            Cage cage = seed % 2 == 0 ? makeCubeCage(1.0f) : makeSharpCubeCage(0.7f);
            cage.positions = jittered(cage.positions, 0.1f, 100 * seed);
            const glm::mat4 rotation =
                glm::rotate(glm::mat4(1.0f), 1.0f + float(seed), hashedDirection(seed, 5));
            GpuScene scene = uploadCages(sceneOfCage(cage, Material{}, rotation), subdividing(level));
            render(scene, inputsOf(far, 400));
            const HdrImage picture = lastFrame().radiance();
            int covered = 0;
            for (int y = 0; y < 400; ++y) {
                // Nearly convex: each row of it is one run of pixels.
                int runs = 0;
                float last = 0.0f;
                for (int x = 0; x < 400; ++x) {
                    const float alpha = picture.rgba[4 * (std::size_t(y) * 400 + std::size_t(x)) + 3];
                    runs += alpha > last;
                    covered += alpha > 0.0f;
                    last = alpha;
                }
                EXPECT_LE(runs, 1) << "row " << y << ", level " << level << ", seed " << seed;
            }
            EXPECT_GT(covered, 20000);
        }
    }
}

TEST_F(CagePictureTest, facesHaveTheirMaterials) {
    Scene scene = sceneOfCage(makeSharpCubeCage(0.6f), Material{}, edgeOn);
    const glm::vec3 colors[] = {{0.8f, 0.1f, 0.2f}, {0.1f, 0.7f, 0.3f}};
    for (const glm::vec3& color : colors) {
        Material material;
        material.baseColor = glm::vec4(color, 1.0f);
        scene.materials.push_back(material);
    }
    // The face towards +Z is rotated to the right, that towards -X to the left.
    scene.cages[0].faceMaterials = {2u, std::nullopt, std::nullopt, 1u, std::nullopt, std::nullopt};
    const AovReader picture = reader(uploadCages(scene, subdividing(2)), far);
    expectColor(picture.vector("base_color", side / 4, side / 2), colors[0]);
    expectColor(picture.vector("base_color", 3 * side / 4, side / 2), colors[1]);
}

TEST_F(CagePictureTest, texturesAndNormalMapsAreThoseOfAMesh) {
    Material material;
    material.baseColorTexture = nearestOf(0);
    material.normalTexture = nearestOf(1);
    const auto withImages = [&](Scene scene) {
        scene.images = {
            makeImage(4, 4, [](auto x, auto y) { return glm::u8vec4(60 * x, 60 * y, 90, 255); }),
            makeImage(4, 4, [](auto x, auto y) { return glm::u8vec4(90 + 25 * x, 80 + 30 * y, 220, 255); })};
        return scene;
    };
    const glm::mat4 rotation = glm::rotate(glm::mat4(1.0f), 0.7f, glm::vec3(0, 0, 1));
    for (const float mirror : {1.0f, -1.0f}) {
        const glm::mat4 transform = glm::scale(rotation, {mirror, 1.0f, 1.0f});
        const AovReader expected =
            reader(upload(withImages(sceneOf(makeQuad(0.7f), material, transform))), far);
        for (const auto evaluator : {VertexEvaluator::compute, VertexEvaluator::cpu}) {
            GpuSceneOptions options = subdividing(3);
            options.vertexEvaluator = evaluator;
            GpuScene cage =
                uploadCages(withImages(sceneOfCage(makeSheetCage(0.7f, 3), material, transform)), options);
            const AovReader actual = reader(cage, far);
            for (int y = 20; y < 80; y += 7) {
                for (int x = 20; x < 80; x += 7) {
                    if (expected.scalar("Z", x, y) == 0.0f) continue;
                    expectColor(actual.vector("base_color", x, y), expected.vector("base_color", x, y),
                                1e-3f);
                    // Both are packed: two errors.
                    expectNormal(actual.vector("N", x, y), expected.vector("N", x, y), 2.0f * normalError);
                }
            }
        }
    }
}

/// Draws the cube from `distance` and returns its level.
class CageLodTest : public CagePictureTest {
  protected:
    static std::uint32_t levelFrom(GpuScene& scene, float distance) {
        render(scene, inputsOf(lookAt({0, 0, distance}, {0, 0, 0}, 0.8f)));
        const CageReport report = scene.cageReport();
        EXPECT_EQ(report.minLevel, report.maxLevel);
        return report.maxLevel;
    }
    static GpuScene cube(const SubdivisionSettings& settings = {}) {
        GpuSceneOptions options = subdividing();
        options.subdivision = settings;
        return GpuScene(context(), sceneOfCage(makeCubeCage(1.0f), Material{}), options);
    }
};

TEST_F(CageLodTest, levelGrowsAsTheCameraApproaches) {
    GpuScene scene = cube();
    EXPECT_EQ(levelFrom(scene, 200.0f), 1u);
    std::uint32_t last = 1;
    for (float distance = 60.0f; distance > 2.0f; distance *= 0.8f) {
        const std::uint32_t level = levelFrom(scene, distance);
        EXPECT_GE(level, last);
        last = level;
    }
    EXPECT_GE(last, 3u);
    EXPECT_EQ(scene.cageReport().triangles, 2u * 6u << 2u * last);
    EXPECT_GT(scene.cageReport().tableBytes, 0u);
}

TEST_F(CageLodTest, oscillatingCameraDoesNotPop) {
    GpuScene scene = cube();
    std::uint32_t near = levelFrom(scene, 3.0f);
    float threshold = 3.0f;
    while (levelFrom(scene, threshold) == near) threshold *= 1.01f;
    int changes = 0;
    std::uint32_t last = levelFrom(scene, threshold);
    for (int step = 0; step < 40; ++step) {
        const std::uint32_t level = levelFrom(scene, threshold * (step % 2 == 0 ? 0.95f : 1.05f));
        changes += level != last;
        last = level;
    }
    EXPECT_LE(changes, 1);
}

TEST_F(CageLodTest, limitsClampTheLevel) {
    SubdivisionSettings settings;
    settings.edgePixels = 1.0f;
    settings.maxLevel = 3;
    GpuScene byLevel = cube(settings);
    EXPECT_EQ(levelFrom(byLevel, 3.0f), 3u);
    EXPECT_EQ(byLevel.cageReport().lodClamped, 1u);
    settings.maxLevel = 8;
    settings.maxVertices = 98;  // 6 × 16 + 2: level 2.
    GpuScene byVertices = cube(settings);
    EXPECT_EQ(levelFrom(byVertices, 3.0f), 2u);
    EXPECT_EQ(byVertices.cageReport().lodClamped, 1u);
    EXPECT_EQ(levelFrom(byVertices, 500.0f), 1u);
    EXPECT_EQ(byVertices.cageReport().lodClamped, 0u);
}

TEST_F(CageLodTest, levelsCanBeFixed) {
    SubdivisionSettings settings;
    settings.level = 2;
    GpuScene scene = cube(settings);
    EXPECT_EQ(levelFrom(scene, 2.5f), 2u);
    EXPECT_EQ(levelFrom(scene, 500.0f), 2u);
    EXPECT_EQ(scene.state().levelOf(0), 2u);
    settings.level.reset();
    scene.setSubdivision(settings);
    EXPECT_GT(levelFrom(scene, 2.5f), 2u) << "takes effect with the next frame";
    settings.maxLevel = 0;
    EXPECT_THROW(scene.setSubdivision(settings), Error);

    Scene stated = sceneOfCage(makeCubeCage(1.0f), Material{});
    stated.cages[0].level = 4;
    GpuScene byCage(context(), stated, subdividing());
    EXPECT_EQ(levelFrom(byCage, 500.0f), 4u);
}

TEST_F(CageLodTest, cameraInsideTheCageGetsTheMaximumLevel) {
    GpuScene scene = cube();
    EXPECT_EQ(levelFrom(scene, 0.1f), 5u);
    EXPECT_EQ(levelFrom(scene, 1.0f), 5u);
}

TEST_F(CagePictureTest, rejectedCageFailsAtUpload) {
    // A polygon of more corners than OpenSubdiv takes.
    Cage cage;
    for (std::uint32_t i = 0; i < 70000; ++i) {
        const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / 70000.0f;
        cage.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0f);
        cage.faceVertices.push_back(i);
    }
    cage.faceSizes = {70000};
    cage.name = "wheel";
    try {
        uploadCages(sceneOfCage(cage, Material{}), subdividing());
        FAIL() << "the subdivider takes no such polygon";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::badInput);
        EXPECT_NE(std::string(error.what()).find("wheel"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace candela::test
