// Frames that are parts of a larger picture (`FrameSettings::region`), and pixels that are not squares
// (`CameraView::aspect`).

#include "support/drawing_test.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"
#include "support/skies.h"

#include <candela/accumulator.h>
#include <candela/color.h>
#include <candela/picture_parts.h>
#include <candela/sampling.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace candela::test {
namespace {

constexpr int width = 160, height = 96;

std::vector<PicturePart> partsOfThePicture() {
    return pictureParts(width, height, 80);
}

template <typename T>
void copyPart(const PicturePart& from, int drawnWidth, const std::vector<T>& pixels, std::vector<T>& into) {
    for (int y = 0; y < from.height; ++y) {
        const auto first = pixels.begin() + 4 * ((y + from.top) * drawnWidth + from.left);
        std::copy(first, first + 4 * from.width, into.begin() + 4 * ((from.y + y) * width + from.x));
    }
}

Environment sky() {
    Environment environment;
    environment.picture = makeSky(32, [](const glm::dvec3& direction) {
        return glm::vec3(0.3 + 0.2 * direction.x, 0.5, 0.6 + 0.3 * direction.y);
    });
    return environment;
}

class RegionTest : public DrawingTest {
  protected:
    /// The share of values that differ by more than the rounding of the projection makes: a silhouette may
    /// take another pixel where it passes a pixel's centre.
    static double differing(const std::vector<float>& a, const std::vector<float>& b) {
        EXPECT_EQ(a.size(), b.size());
        std::size_t count = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            count += std::abs(a[i] - b[i]) > 1e-4f + 2e-3f * std::abs(b[i]);
        return double(count) / double(a.size());
    }
    static void copyInto(std::vector<float>& picture, const PicturePart& own, const HdrImage& drawn) {
        copyPart(own, drawn.width, drawn.rgba, picture);
    }
    static std::vector<float> assembled(GpuScene& scene, const CameraView& view,
                                        const FrameSettings& settings) {
        std::vector<float> picture(std::size_t(4 * width * height), -1.0f);
        for (const PicturePart& own : partsOfThePicture())
            copyInto(picture, own, renderer().render(scene, view, own.settings(settings)).radiance());
        return picture;
    }
};

TEST_F(RegionTest, partsMakeUpThePicture) {
    LitScene lit = spheresOnAFloor();
    lit.scene.environment = sky();
    GpuScene scene(context(), lit.scene);
    scene.setLights(lit.lights);
    for (const bool orthographic : {false, true}) {
        CameraView view = lit.view;
        view.shift = {0.1f, -0.07f};
        if (orthographic) view.orthographicHeight = 7.0f;
        for (const TileBackend backend : {TileBackend::cpu, TileBackend::compute}) {
            FrameSettings settings;
            settings.width = width;
            settings.height = height;
            settings.tileBackend = backend;
            const HdrImage whole = renderer().render(scene, view, settings).radiance();
            EXPECT_LT(differing(assembled(scene, view, settings), whole.rgba), 0.001)
                << toString(backend) << (orthographic ? " orthographic" : "");
        }
    }
}

TEST_F(RegionTest, linesAndPointsKeepTheirWidthAcrossTheBorders) {
    Scene described;
    Material material;
    material.unlit = true;
    Mesh mesh;
    mesh.positions = {{-3, -2, 0}, {3, 2, 0}, {-3, 1, 0}, {3, -1.5f, 0}};
    mesh.indices = {0, 1, 2, 3};
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0.0f));
    mesh.submeshes = {{0, 4, 0, Topology::lines}};
    described.meshes.push_back(mesh);
    described.materials.push_back(material);
    Node node;
    node.mesh = 0;
    described.nodes.push_back(node);
    GpuScene scene = upload(described);
    FrameSettings settings;
    settings.width = width;
    settings.height = height;
    settings.lineWidth = 7.0f;
    const CameraView view = lookAt({0, 0, 6}, {0, 0, 0}, 0.7f);
    const HdrImage whole = renderer().render(scene, view, settings).radiance();
    EXPECT_GT(std::ranges::count(whole.rgba, 1.0f), 1000);
    EXPECT_LT(differing(assembled(scene, view, settings), whole.rgba), 0.001);
}

TEST_F(RegionTest, ambientOcclusionAndDitherAreThoseOfThePicture) {
    LitScene lit = spheresOnAFloor();
    GpuScene scene(context(), lit.scene);
    scene.setLights(lit.lights);
    FrameSettings settings;
    settings.width = width;
    settings.height = height;
    settings.ambientOcclusion.rays = 4;
    const DisplayTransform display = ColorConfig::builtIn().displayTransform({});
    const Frame frame = renderer().render(scene, lit.view, settings);
    const std::vector<std::uint8_t> whole = frame.displayPicture(display);
    std::vector<float> occlusion;
    if (hasShadows()) occlusion = frame.aovs({"ambient_occlusion"})[0].values[0];
    std::vector<std::uint8_t> codes(whole.size());
    std::size_t others = 0, compared = 0;
    for (const PicturePart& own : partsOfThePicture()) {
        const Frame drawn = renderer().render(scene, lit.view, own.settings(settings));
        copyPart(own, drawn.width(), drawn.displayPicture(display), codes);
        if (!hasShadows()) continue;
        const std::vector<float> values = drawn.aovs({"ambient_occlusion"})[0].values[0];
        for (int y = 0; y < own.height; ++y) {
            for (int x = 0; x < own.width; ++x, ++compared) {
                const float a = values[std::size_t((y + own.top) * drawn.width() + x + own.left)];
                others += a != occlusion[std::size_t((own.y + y) * width + own.x + x)];
            }
        }
    }
    // A ray that passes an edge may meet another triangle after the rounding.
    EXPECT_LE(others, compared / 100);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) differing += whole[i] != codes[i];
    // With another dither a third of the codes differ.
    EXPECT_LT(double(differing), 0.005 * double(whole.size()));
}

TEST_F(RegionTest, samplesOfPartsMakeUpThePicture) {
    LitScene lit = spheresOnAFloor();
    GpuScene scene(context(), lit.scene);
    scene.setLights(lit.lights);
    FrameSettings settings;
    settings.width = width;
    settings.height = height;
    SamplingSettings sampling;
    sampling.count = 4;
    sampling.lens = Lens{1.4f, 5.0f, 0, 0.3f};
    const auto mean = [&](const FrameSettings& own) {
        Accumulator accumulator(context());
        accumulator.addSamples(renderer(), scene, lit.view, own, sampling, 0, 4);
        return accumulator.radiance();
    };
    const std::vector<float> whole = mean(settings).rgba;
    std::vector<float> picture(whole.size());
    for (const PicturePart& own : partsOfThePicture()) copyInto(picture, own, mean(own.settings(settings)));
    EXPECT_LT(differing(picture, whole), 0.001);
}

TEST_F(RegionTest, aspectsStretchThePicture) {
    LitScene lit = spheresOnAFloor();
    GpuScene scene(context(), lit.scene);
    scene.setLights(lit.lights);
    FrameSettings settings;
    settings.width = width;
    settings.height = height;
    settings.specularAntialiasing = false;  // depends on the size of pixels
    CameraView view = lit.view;
    view.aspect = 2.0f * width / height;  // a pixel is twice as wide as high
    const HdrImage stretched = renderer().render(scene, view, settings).radiance();
    FrameSettings larger = settings;
    larger.width *= 6;
    larger.height *= 3;
    const HdrImage reference = renderer().render(scene, lit.view, larger).radiance();
    std::size_t others = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            // Three times as fine, with 6 pixels for one across: the middle of a pixel is between two of
            // them.
            const glm::vec3 a =
                0.5f * (pixelOf(reference, 6 * x + 2, 3 * y + 1) + pixelOf(reference, 6 * x + 3, 3 * y + 1));
            const glm::vec3 b = pixelOf(stretched, x, y);
            others += glm::distance(a, b) > 0.02f + 0.05f * glm::length(a);
        }
    }
    EXPECT_LT(double(others), 0.06 * width * height) << "other than along silhouettes";
    for (const Technique technique : {Technique::volumes, Technique::fullscreen}) {
        settings.technique = technique;
        const HdrImage other = renderer().render(scene, view, settings).radiance();
        EXPECT_EQ(differing(other.rgba, stretched.rgba), 0.0) << toString(technique);
    }
}

TEST_F(RegionTest, partsCoverThePictureOnceAndFitTheDevice) {
    for (const auto& [wide, high, side] : {std::array{160, 96, 80}, std::array{1000, 77, 64},
                                           std::array{64, 64, 64}, std::array{5, 300, 130}}) {
        std::vector<int> covered(std::size_t(wide) * std::size_t(high), 0);
        for (const PicturePart& part : pictureParts(wide, high, side)) {
            EXPECT_LE(part.frameWidth, side);
            EXPECT_LE(part.frameHeight, side);
            EXPECT_GE(part.frameWidth, part.left + part.width);
            EXPECT_GE(part.frameHeight, part.top + part.height);
            FrameSettings picture;
            picture.width = wide;
            picture.height = high;
            const FrameSettings settings = part.settings(picture);
            EXPECT_EQ(settings.region->x % 16, 0);
            EXPECT_EQ((high - settings.region->y - settings.height) % 16, 0);
            for (int y = part.y; y < part.y + part.height; ++y)
                for (int x = part.x; x < part.x + part.width; ++x) ++covered[std::size_t(y * wide + x)];
        }
        EXPECT_EQ(std::ranges::count(covered, 1), std::ptrdiff_t(covered.size()));
    }
    EXPECT_EQ(pictureParts(64, 50, 64).size(), 1u);
    // 20 rows of 48 pixels, of frames of 80 with two margins of 16, and one of the 40 that are left.
    const std::vector<PicturePart> low = pictureParts(1000, 1000, 1000, 80);
    ASSERT_EQ(low.size(), 21u);
    int y = 0;
    for (const PicturePart& part : low) {
        EXPECT_EQ(part.frameWidth, 1000);
        EXPECT_LE(part.frameHeight, 80);
        EXPECT_EQ(part.y, y);
        y += part.height;
    }
    EXPECT_EQ(y, 1000);
    EXPECT_THROW(pictureParts(100, 100, 100, 63), Error);
    EXPECT_THROW(pictureParts(0, 5, 64), Error);
    EXPECT_THROW(pictureParts(100, 100, 63), Error);
}

TEST_F(RegionTest, refusesPartsThatAreNone) {
    GpuScene scene = upload(spheresOnAFloor().scene);
    FrameSettings settings;
    settings.width = settings.height = 16;
    settings.region = PictureRegion{0, 16, 0, 0};
    expectRefused([&] { renderer().render(scene, CameraView{}, settings); }, "1 to 1048576");
    settings.region = PictureRegion{64, 64, -2000000, 0};
    expectRefused([&] { renderer().render(scene, CameraView{}, settings); }, "within 1048576");
    CameraView bad;
    bad.aspect = 0.0f;
    settings.region.reset();
    expectRefused([&] { renderer().render(scene, bad, settings); }, "aspect");
}

}  // namespace
}  // namespace candela::test
