// Panoramas from the faces of a cube, against the directions that they show.

#include "support/drawing_test.h"
#include "support/procedural_scene.h"
#include "support/skies.h"

#include <candela/panorama.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>

namespace candela::test {
namespace {

constexpr double pi = std::numbers::pi;

/// The direction of a pixel of a panorama, camera space.
glm::dvec3 directionOf(int x, int y, int width) {
    const double longitude = 2 * pi * ((x + 0.5) / width - 0.5),
                 latitude = pi * (0.5 - (y + 0.5) * 2 / width);
    return {std::cos(latitude) * std::sin(longitude), std::sin(latitude),
            -std::cos(latitude) * std::cos(longitude)};
}

/// Smooth, and different in every direction.
glm::vec3 smooth(const glm::dvec3& d) {
    return {1.0 + 0.5 * d.x, 1.0 + 0.5 * d.y * d.z, 1.0 + 0.5 * std::sin(2.0 * d.z + d.x)};
}

TEST(PanoramaTest, showsEachDirectionWhereItStands) {
    // Faces that hold the radiance of their pixels' directions exactly.
    for (const int width : {64, 200}) {
        const PanoramaFaces faces = panoramaFaces(CameraView{}, width);
        std::array<HdrImage, 6> pictures;
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            const glm::dmat3 axes(faces.views[i].worldFromCamera);
            const double extent = std::tan(0.5 * double(faces.views[i].verticalFov));
            pictures[i] = {faces.size, faces.size, {}};
            for (int y = 0; y < faces.size; ++y) {
                for (int x = 0; x < faces.size; ++x) {
                    const double across = extent * (2 * (x + 0.5) / faces.size - 1);
                    const double along = extent * (1 - 2 * (y + 0.5) / faces.size);
                    const glm::vec3 color = smooth(glm::normalize(axes * glm::dvec3(across, along, -1)));
                    pictures[i].rgba.insert(pictures[i].rgba.end(), {color.x, color.y, color.z, 1.0f});
                }
            }
        }
        const HdrImage picture = panorama(pictures, width);
        ASSERT_EQ(picture.height, width / 2);
        double largest = 0.0;
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < width; ++x) {
                const glm::vec3 expected = smooth(directionOf(x, y, width)), is = pixelOf(picture, x, y);
                largest = std::max(largest, double(glm::distance(is, expected)));
            }
        }
        // Linear interpolation errs by h²/8 times the second derivative: here at most 4 x 0.5 a channel, with
        // steps of 2 pi / width. Twice, for two directions.
        const double step = 2 * pi / width;
        EXPECT_LT(largest, 2 * step * step / 8 * 2.0 * std::sqrt(3.0)) << width;
    }
}

TEST(PanoramaTest, refusesWhatIsNoPanorama) {
    EXPECT_THROW(panoramaFaces(CameraView{}, 3), Error);
    EXPECT_THROW(panoramaFaces(CameraView{}, 65), Error);
    CameraView flat;
    flat.orthographicHeight = 1.0f;
    EXPECT_THROW(panoramaFaces(flat, 64), Error);
    const std::array<HdrImage, 6> empty{};
    EXPECT_THROW(panorama(empty, 64), Error);
}

/// Depths of the faces of a cube of planes at a distance: constant, so that distances are known.
TEST(PanoramaTest, depthsBecomeDistancesAndIdsStayWhole) {
    constexpr int width = 128;
    constexpr float distance = 2.5f;
    const int size = panoramaFaces(CameraView{}, width).size;
    const std::size_t count = std::size_t(size) * std::size_t(size);
    std::array<std::vector<Aov>, 6> faces;
    for (std::size_t i = 0; i < faces.size(); ++i)
        faces[i] = {{"Z", {"Z"}, {std::vector<float>(count, distance)}},
                    {"node_id", {"node_id"}, {std::vector<float>(count, float(i + 1))}},
                    {"N", {"N.X", "N.Y", "N.Z"}, std::vector(3, std::vector<float>(count, 0.25f))}};
    const std::vector<Aov> aovs = panoramaAovs(faces, width);
    ASSERT_EQ(aovs.size(), 3u);
    ASSERT_EQ(aovs[2].channels, faces[0][2].channels);
    for (int y = 0; y < width / 2; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t pixel = std::size_t(y) * width + std::size_t(x);
            const glm::dvec3 size3 = glm::abs(directionOf(x, y, width));
            const double expected = distance / std::max({size3.x, size3.y, size3.z});
            // Of the nearest pixel of the face, half a pixel away at most in each direction: the distance
            // grows by at most sqrt(2) a unit of the face, whose pixels are at most 2 / (width / pi) wide.
            ASSERT_NEAR(aovs[0].values[0][pixel], expected, distance * std::sqrt(2.0) * pi / width)
                << x << ", " << y;
            const float id = aovs[1].values[0][pixel];
            ASSERT_TRUE(id >= 1.0f && id <= 6.0f && id == std::round(id));
            ASSERT_FLOAT_EQ(aovs[2].values[1][pixel], 0.25f);
        }
    }
    // Ahead is the fifth face.
    EXPECT_EQ(aovs[1].values[0][32 * width + 64], 5.0f);
    std::array<std::vector<Aov>, 6> wrong = faces;
    wrong[3].pop_back();
    EXPECT_THROW(panoramaAovs(wrong, width), Error);
    wrong = faces;
    wrong[2][0].values[0].pop_back();
    EXPECT_THROW(panoramaAovs(wrong, width), Error);
    for (std::vector<Aov>& face : wrong) face = {{"motion", {"motion.X", "motion.Y"}, {}}};
    EXPECT_THROW(panoramaAovs(wrong, width), Error);
}

class PanoramaPictureTest : public DrawingTest {};

TEST_F(PanoramaPictureTest, facesMeetWithoutASeam) {
    // An environment seen from a turned camera: the panorama shows it turned back.
    Scene described = sceneOf(makeQuad(0.01f), Material{}, glm::translate(glm::mat4(1.0f), {0, 50, 0}));
    Environment environment;
    environment.picture = makeSky(512, smooth);
    described.environment = environment;
    GpuScene scene(context(), described);
    const CameraView view = lookAt({0, 0, 0}, {0.4f, 0.3f, -1.0f}, 0.8f);
    constexpr int width = 256;
    const PanoramaFaces faces = panoramaFaces(view, width);
    FrameSettings settings;
    settings.width = settings.height = faces.size;
    std::array<HdrImage, 6> pictures;
    renderer().renderViews(scene, faces.views, settings,
                           [&](std::size_t i, const Frame& frame) { pictures[i] = frame.radiance(); });
    const HdrImage picture = panorama(pictures, width);
    const glm::dmat3 axes(view.worldFromCamera);
    double largest = 0.0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < width; ++x)
            largest = std::max(largest, double(glm::distance(pixelOf(picture, x, y),
                                                             smooth(axes * directionOf(x, y, width)))));
    // The same bound, and that of the environment's own picture, of half the step.
    const double step = 2 * pi / width;
    EXPECT_LT(largest, 2 * step * step / 8 * 2.0 * std::sqrt(3.0) * 1.25);
}

}  // namespace
}  // namespace candela::test
