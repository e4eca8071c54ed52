// The probe names the node of every pixel and equals the AOVs there.

#include "support/cage_scenes.h"
#include "support/drawing_test.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"

#include <candela/error.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <map>

namespace candela::test {
namespace {

constexpr int width = 61, height = 44;

FrameRequest frameOf(const CameraView& view, DebugView debugView = DebugView::none) {
    FrameRequest inputs{width, height, view, BrdfModel::course, Technique::volumes};
    inputs.debugView = debugView;
    return inputs;
}

glm::mat4 at(const glm::vec3& position) {
    return glm::translate(glm::mat4(1.0f), position);
}

class ProbeTest : public DrawingTest {
  protected:
    /// Compares the probe with all AOVs at each of `step` pixels. Returns how many had a surface.
    static int expectAovs(int step) {
        const AovReader reader = aovs(width);
        const HdrImage radiance = lastFrame().radiance();
        int surfaces = 0;
        for (int i = 0; i < width * height; i += step) {
            const int x = i % width, y = i / width;
            const std::optional<PixelProbe> probe = lastFrame().probe(x, y);
            EXPECT_EQ(probe.has_value(), reader.scalar("Z", x, y) > 0.0f) << x << ", " << y;
            if (!probe) continue;
            ++surfaces;
            EXPECT_EQ(probe->z, reader.scalar("Z", x, y));
            EXPECT_EQ(probe->position, reader.vector("P", x, y));
            EXPECT_EQ(probe->normal, reader.vector("N", x, y));
            EXPECT_EQ(probe->baseColor, reader.vector("base_color", x, y));
            EXPECT_EQ(probe->metallic, reader.scalar("metallic", x, y));
            EXPECT_EQ(probe->roughness, reader.scalar("roughness", x, y));
            EXPECT_EQ(probe->emission, reader.vector("emission", x, y));
            EXPECT_EQ(probe->radiance, glm::make_vec3(&radiance.rgba[4 * static_cast<std::size_t>(i)]));
            EXPECT_EQ(float(probe->lightCount), reader.scalar("light_count", x, y));
            if (testing::Test::HasFailure()) {
                ADD_FAILURE() << "at " << x << ", " << y;
                break;
            }
        }
        return surfaces;
    }
};

TEST_F(ProbeTest, equalsTheAovsOfEveryKindOfSurface) {
    for (LitScene lit : litScenes()) {
        Material unlit;
        unlit.unlit = true;
        unlit.baseColor = {0.2f, 0.5f, 0.7f, 1};
        place(lit.scene, makeQuad(0.1f), unlit, lit.view.worldFromCamera * at({0.2f, 0.1f, -1}));
        GpuScene scene = upload(lit.scene, lit.lights);
        render(scene, frameOf(lit.view));
        EXPECT_GT(expectAovs(7), 100) << lit.name;
    }
}

TEST_F(ProbeTest, equalsTheAovsOfDebugViews) {
    const LitScene lit = textured();
    GpuScene scene = upload(lit.scene, lit.lights);
    for (const DebugView debugView :
         {DebugView::normals, DebugView::emission, DebugView::level, DebugView::lightCount}) {
        render(scene, frameOf(lit.view, debugView));
        EXPECT_GT(expectAovs(29), 10) << toString(debugView);
    }
}

TEST_F(ProbeTest, doesNotAffectTheFrame) {
    const LitScene lit = textured();
    GpuScene scene = upload(lit.scene, lit.lights);
    const HdrImage before = drawn(scene, frameOf(lit.view));
    lastFrame().probe(width / 2, height / 2);
    EXPECT_EQ(lastFrame().radiance().rgba, before.rgba);
    EXPECT_EQ(drawn(scene, frameOf(lit.view)).rgba, before.rgba);
}

/// Red of the base colour encodes the index of the node.
Material numbered(std::uint32_t node) {
    Material material;
    // Codes 20 apart, half of them to the next one, so that filtering and rounding can not change one to
    // another.
    const float code = (20.0f * float(node) + 10.0f) / 255.0f;
    material.baseColor = {std::pow((code + 0.055f) / 1.055f, 2.4f), 0, 0, 1};
    return material;
}

std::uint32_t numberOf(const glm::vec3& baseColor) {
    const float code = 1.055f * std::pow(baseColor.r, 1.0f / 2.4f) - 0.055f;
    return static_cast<std::uint32_t>(code * 255.0f / 20.0f);
}

/// Overlapping spheres, some mirrored, behind a sheet with holes.
Scene overlapping() {
    Scene scene;
    scene.nodes.resize(2);  // Nodes without meshes, so that instance and node indices differ.
    for (std::uint32_t node = 2; node < 9; ++node) {
        const glm::vec3 position(hashed(1, node) - 0.5f, hashed(2, node) - 0.5f, hashed(3, node) - 0.5f);
        const glm::mat4 transform =
            glm::scale(at(position), glm::vec3(node % 2 == 0 ? 1.0f : -1.0f, 1.0f, 1.0f));
        EXPECT_EQ(place(scene, makeSphere(0.4f), numbered(node), transform), node);
    }
    scene.images.push_back(makeImage(8, 8, [](std::uint32_t x, std::uint32_t y) {
        return glm::u8vec4(255, 255, 255, (x + y) % 2 == 0 ? 255 : 0);
    }));
    for (std::uint32_t node = 9; node < 11; ++node) {
        Material masked = numbered(node);
        masked.baseColorTexture = Texture{};
        masked.baseColorTexture->minFilter = masked.baseColorTexture->magFilter = Filter::nearest;
        masked.alphaMode = AlphaMode::mask;
        if (node == 9) masked.clearcoat.factor = 0.5f;
        masked.doubleSided = true;
        Mesh sheet = makeQuad(1.0f);
        if (node == 10) sheet.colors.assign(4, glm::vec4(1, 1, 1, 0.4f));  // Below the cutoff everywhere.
        place(scene, sheet, masked, glm::rotate(at({0, 0, 0.6f}), 2.8f, glm::vec3(0, 1, 0)));
    }
    return scene;
}

TEST_F(ProbeTest, namesTheNode) {
    GpuScene scene = upload(overlapping());
    render(scene, frameOf(lookAt({0.1f, 0.3f, 3.0f}, {0, 0, 0}, 0.6f)));
    const AovReader reader = aovs(width);
    std::map<std::uint32_t, int> pixels;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::optional<PixelProbe> probe = lastFrame().probe(x, y);
            if (!probe) continue;
            ASSERT_EQ(probe->node, numberOf(reader.vector("base_color", x, y))) << x << ", " << y;
            ++pixels[probe->node];
        }
    }
    for (std::uint32_t node = 2; node < 10; ++node) EXPECT_GT(pixels[node], 0) << "node " << node;
    EXPECT_EQ(pixels[10], 0) << "masked everywhere";
}

TEST_F(ProbeTest, namesTheNodeOfACage) {
    Scene description;
    description.nodes.resize(1);
    const std::uint32_t cage = placeCage(description, makeCubeCage(0.8f), Material{}, at({-0.8f, 0, 0}));
    const std::uint32_t mesh = place(description, makeSphere(0.5f), Material{}, at({0.9f, 0, 0}));
    GpuScene scene(context(), description, subdividing(3));
    const std::vector<WorldLight> lights{pointLight({0, 1, 3}, 4.0f, {9, 9, 9})};
    scene.setLights(lights);
    const CameraView view = lookAt({0, 0, 5}, {0, 0, 0}, 0.6f);
    render(scene, frameOf(view));
    EXPECT_GT(expectAovs(11), 30);
    EXPECT_EQ(lastFrame().probe(width / 2 - 12, height / 2)->node, cage);
    EXPECT_EQ(lastFrame().probe(width / 2 + 12, height / 2)->node, mesh);
}

TEST_F(ProbeTest, followsNodesThatMove) {
    Scene description = sceneOf(makeQuad(1.0f), Material{});
    place(description, makeQuad(1.0f), Material{}, at({0, 0, -1}));
    GpuScene scene = upload(description);
    const CameraView view = lookAt({0, 0, 4}, {0, 0, 0}, 0.4f);
    render(scene, frameOf(view));
    EXPECT_EQ(lastFrame().probe(30, 20)->node, 0u);
    scene.setTransform(1, at({0, 0, 1}));
    render(scene, frameOf(view));
    EXPECT_EQ(lastFrame().probe(30, 20)->node, 1u);
    // Distances are near plane / depth, both rounded once.
    EXPECT_NEAR(lastFrame().probe(30, 20)->z, 3.0f, 1e-5f);
}

TEST_F(ProbeTest, pixelsOutsideAreErrors) {
    GpuScene scene = upload(sceneOf(makeQuad(1.0f), Material{}));
    render(scene, frameOf(lookAt({0, 0, 4}, {0, 0, 0}, 0.4f)));
    EXPECT_NO_THROW(lastFrame().probe(0, 0));
    EXPECT_NO_THROW(lastFrame().probe(width - 1, height - 1));
    for (const auto& [x, y] : {std::pair{-1, 0}, {0, -1}, {width, 0}, {0, height}}) {
        try {
            lastFrame().probe(x, y);
            FAIL() << "no error for " << x << ", " << y;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            const std::string pixel = "(" + std::to_string(x) + ", " + std::to_string(y) + ")";
            EXPECT_NE(std::string(error.what()).find(pixel), std::string::npos) << error.what();
        }
    }
}

}  // namespace
}  // namespace candela::test
