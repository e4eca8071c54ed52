// Layers of transparent surfaces: pixels against the closed form of blending, and what frames tell of them.

#include "support/drawing_test.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"
#include "support/skies.h"

#include <candela/accumulator.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <numeric>

namespace candela::test {
namespace {

constexpr int width = 48, height = 32;

/// Along -Z from the origin.
CameraView ahead() {
    return lookAt({0, 0, 0}, {0, 0, -1}, 0.8f);
}

glm::mat4 at(const glm::vec3& position) {
    return glm::translate(glm::mat4(1.0f), position);
}

Material blended(const glm::vec4& color) {
    Material material;
    material.baseColor = color;
    material.alphaMode = AlphaMode::blend;
    return material;
}

Material unlit(const glm::vec4& color) {
    Material material = blended(color);
    material.unlit = true;
    return material;
}

Material opaque(const glm::vec3& color) {
    Material material;
    material.baseColor = glm::vec4(color, 1.0f);
    material.unlit = true;
    return material;
}

/// Of a seed: tint k of a stack. That of k = 3 is wholly transparent.
glm::vec4 tint(std::uint32_t seed, std::uint32_t k) {
    const float alpha = k == 3 ? 0.0f : hashed(seed, 4 * k + 3);
    return {hashed(seed, 4 * k), hashed(seed, 4 * k + 1), hashed(seed, 4 * k + 2), alpha};
}

/// Half a code of the coverage, which has 16 bits, and what interpolation and blending round.
constexpr double layerError = 0.55 / 65535.0;

/// What is behind, with coverage, seen through `front`.
glm::dvec4 over(const glm::vec4& front, const glm::dvec4& behind) {
    const double a = double(front.a);
    return {a * glm::dvec3(front) + (1.0 - a) * glm::dvec3(behind), a + (1.0 - a) * behind.a};
}

glm::dvec4 pixel(const HdrImage& picture, int x, int y) {
    return {
        glm::dvec3(pixelOf(picture, x, y)),
        double(picture.rgba[4 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)) + 3])};
}

class LayerTest : public DrawingTest {
  protected:
    static FrameSettings settingsWith(std::uint32_t layers, const Form& form = cpuTiles) {
        FrameSettings settings = FrameRequest{width, height, ahead()}.settings();
        settings.layers = layers;
        settings.technique = form.technique;
        settings.tileBackend = form.backend;
        return settings;
    }

    static Frame draw(GpuScene& scene, const FrameSettings& settings) {
        return renderer().render(scene, ahead(), settings);
    }

    static void expectClose(const glm::dvec4& actual, const glm::dvec4& expected, std::uint32_t layers,
                            const std::string& what) {
        for (int c = 0; c < 4; ++c)
            EXPECT_NEAR(actual[c], expected[c], double(layers) * layerError) << what << ", channel " << c;
    }
};

TEST_F(LayerTest, stacksInAnyOrderAreTheClosedForm) {
    for (std::uint32_t count = 1; count <= 12; ++count) {
        std::vector<std::uint32_t> order(count);
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::sort(order, {}, [&](std::uint32_t k) { return hashed(count, 100 + k); });
        Scene scene = sceneOf(makeQuad(4.0f), opaque({0.2f, 0.5f, 0.9f}), at({-4, 0, -8}));
        for (const std::uint32_t k : order)
            place(scene, makeQuad(4.0f), unlit(tint(count, k)), at({0, 0, -3.0f - 0.1f * float(k)}));
        GpuScene uploaded = upload(scene);
        glm::dvec4 left(glm::dvec3(0.2f, 0.5f, 0.9f), 1.0), right(0.0);
        for (std::uint32_t k = count; k-- > 0;) {
            left = over(tint(count, k), left);
            right = over(tint(count, k), right);
        }
        for (const Form& form : forms) {
            const Frame frame = draw(uploaded, settingsWith(12, form));
            const HdrImage picture = frame.radiance();
            const std::string what = std::to_string(count) + " quads, " + form.name;
            expectClose(pixel(picture, 5, 16), left, count, what + ", over a surface");
            expectClose(pixel(picture, width - 5, 16), right, count, what + ", over nothing");
            EXPECT_EQ(frame.layerCounts().layers, count > 3 ? count - 1 : count) << what;
            EXPECT_EQ(frame.layerCounts().fragmentsBeyond, 0u) << what;
        }
    }
}

TEST_F(LayerTest, intersectingSurfacesChangePlacesAtTheirIntersection) {
    const glm::vec4 red(0.9f, 0.1f, 0.2f, 0.4f), green(0.1f, 0.8f, 0.3f, 0.7f);
    const auto turned = [](float degrees) {
        return glm::rotate(at({0, 0, -4}), glm::radians(degrees), glm::vec3(0, 1, 0));
    };
    Scene scene = sceneOf(makeQuad(3.0f), unlit(red), turned(30));
    place(scene, makeQuad(3.0f), unlit(green), turned(-30));
    GpuScene uploaded = upload(scene);
    const HdrImage picture = draw(uploaded, settingsWith(8)).radiance();
    const glm::dvec4 nothing(0.0);
    for (int y = 4; y < height - 4; ++y) {
        for (int x = 8; x < width - 8; ++x) {
            // Turned to the left, the right half of a quad is farther away.
            const bool isLeft = x < width / 2;
            const glm::vec4 &front = isLeft ? red : green, &back = isLeft ? green : red;
            expectClose(pixel(picture, x, y), over(front, over(back, nothing)), 2,
                        "column " + std::to_string(x));
        }
    }
}

/// Panes of several materials under lights, over a floor, with the meshes in the order of `seed`.
Scene litPanes(std::uint32_t seed) {
    struct Pane {
        glm::vec3 position;
        Material material;
        float angle;
    };
    std::vector<Pane> panes;
    for (std::uint32_t k = 0; k < 6; ++k) {
        const float f = float(k);
        Material material = blended({hashed(1, k), hashed(2, k), hashed(3, k), 0.3f + 0.1f * f});
        material.roughness = 0.2f + 0.1f * f;
        material.metallic = k % 2 == 0 ? 0.0f : 0.7f;
        material.doubleSided = k % 3 == 0;
        if (k == 4) material.emission = glm::vec3(0.2f, 0.1f, 0.4f);
        if (k == 5) material.unlit = true;
        panes.push_back({{0.3f * f - 1.0f, 0.1f * f, -3.0f - 0.3f * f}, material, 7.0f * f - 20.0f});
    }
    std::vector<std::uint32_t> order(panes.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t k) { return hashed(seed, k); });
    Material grey;
    grey.baseColor = glm::vec4(0.5f, 0.5f, 0.5f, 1.0f);
    Scene scene = sceneOf(makeQuad(6.0f), grey, at({0, 0, -9}));
    for (const std::uint32_t k : order) {
        place(scene, makeQuad(1.2f), panes[k].material,
              glm::rotate(at(panes[k].position), glm::radians(panes[k].angle), glm::vec3(0, 1, 0)));
    }
    return scene;
}

std::vector<WorldLight> someLights() {
    return {pointLight({1, 2, -2}, 12.0f, glm::vec3(20, 18, 15)),
            spotLight({-2, 1, -1}, {0, 0, -6}, 15.0f, glm::vec3(5, 20, 25), 0.3f, 0.8f),
            directionalLight(glm::normalize(glm::vec3(0.2f, -0.3f, -1)), glm::vec3(1.5f))};
}

TEST_F(LayerTest, picturesDoNotDependOnTheOrderOfMeshes) {
    FrameSettings settings = settingsWith(8);
    settings.shadows = Shadows::automatic;
    std::vector<float> first;
    for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) {
        GpuScene uploaded = upload(litPanes(seed), someLights());
        const Frame frame = draw(uploaded, settings);
        EXPECT_GT(frame.layerCounts().layers, 2u);
        const HdrImage picture = frame.radiance();
        if (first.empty()) first = picture.rgba;
        EXPECT_EQ(picture.rgba, first) << "order " << seed;
    }
}

// Each surface is lit as it is where it is alone.
TEST_F(LayerTest, litStacksAreTheClosedFormOfTheirSurfacesAlone) {
    Scene whole = litPanes(1);
    whole.environment = Environment{
        .picture = makeSky(16, [](const glm::dvec3& d) { return glm::vec3(0.2, 0.3, 0.3 + 0.2 * d.y); }),
        .isBackground = false};
    std::vector<std::uint32_t> nodes(whole.nodes.size());
    std::iota(nodes.begin(), nodes.end(), 0u);
    for (const Form& form : forms) {
        GpuScene uploaded = upload(whole, someLights());
        const HdrImage picture = draw(uploaded, settingsWith(8, form)).radiance();
        Scene solid = whole;
        for (Material& material : solid.materials) material.baseColor.a = 1.0f;
        GpuScene alone = upload(solid, someLights());
        std::vector<HdrImage> pictures;
        std::vector<std::vector<float>> depths;
        for (const std::uint32_t shown : nodes) {
            for (const std::uint32_t node : nodes)
                alone.setVisibility(
                    node, node == shown ? GpuScene::Visibility::shown : GpuScene::Visibility::hidden);
            const Frame frame = draw(alone, settingsWith(8, form));
            EXPECT_EQ(frame.layerCounts().layers, 0u);
            pictures.push_back(frame.radiance());
            depths.push_back(frame.aovs({"Z"})[0].values[0]);
        }
        int deepest = 0;
        for (std::size_t i = 0; i < std::size_t{width} * height; ++i) {
            std::vector<std::uint32_t> here;
            for (const std::uint32_t node : nodes) {
                if (depths[node][i] > 0.0f) here.push_back(node);
            }
            std::ranges::sort(here, std::ranges::greater{},
                              [&](std::uint32_t node) { return depths[node][i]; });
            deepest = std::max(deepest, int(here.size()));
            glm::dvec3 expected(0.0);
            for (const std::uint32_t node : here) {
                const double a = double(whole.materials[node].baseColor.a);
                for (int c = 0; c < 3; ++c) {
                    expected[c] =
                        a * double(pictures[node].rgba[4 * i + std::size_t(c)]) + (1.0 - a) * expected[c];
                }
            }
            for (int c = 0; c < 3; ++c) {
                ASSERT_NEAR(picture.rgba[4 * i + std::size_t(c)], expected[c],
                            6.0 * layerError * (1.0 + expected[c]))
                    << form.name << ", pixel " << i;
            }
        }
        EXPECT_GE(deepest, 5);
    }
}

TEST_F(LayerTest, whatLiesBeyondTheLayersIsCounted) {
    Scene scene;
    for (std::uint32_t k = 0; k < 5; ++k)
        place(scene, makeQuad(8.0f), unlit(tint(7, k + 4)), at({0, 0, -3.0f - float(k)}));
    GpuScene uploaded = upload(scene);
    for (const std::uint32_t layers : {0u, 1u, 3u, 5u}) {
        const Frame frame = draw(uploaded, settingsWith(layers));
        glm::dvec4 expected(0.0);
        for (std::uint32_t k = layers; k-- > 0;) expected = over(tint(7, k + 4), expected);
        expectClose(pixel(frame.radiance(), 20, 10), expected, layers, std::to_string(layers) + " layers");
        EXPECT_EQ(frame.layerCounts().layers, layers);
        EXPECT_EQ(frame.layerCounts().fragmentsBeyond, std::uint64_t{5 - layers} * width * height);
    }
    expectRefused([&] { draw(uploaded, settingsWith(65)); }, "expected 0 to 64");
}

TEST_F(LayerTest, opaqueSurfacesHideLayersAndAnOpaqueAlphaNeedsNone) {
    Scene scene = sceneOf(makeQuad(8.0f), opaque({0.3f, 0.3f, 0.3f}), at({0, 0, -3}));
    place(scene, makeQuad(8.0f), unlit({1, 0, 0, 0.5f}), at({0, 0, -4}));
    GpuScene hidden = upload(scene);
    EXPECT_EQ(draw(hidden, settingsWith(8)).layerCounts().layers, 0u);
    scene = sceneOf(makeQuad(8.0f), unlit({0.4f, 0.5f, 0.6f, 1.0f}), at({0, 0, -3}));
    GpuScene solid = upload(scene);
    const Frame frame = draw(solid, settingsWith(8));
    EXPECT_EQ(frame.layerCounts().layers, 0u);
    expectClose(pixel(frame.radiance(), 9, 9), {0.4f, 0.5f, 0.6f, 1.0f}, 1, "alpha 1");
    // An edit of the material makes a layer of it.
    Material half = scene.materials[0];
    half.baseColor.a = 0.5f;
    solid.setMaterial(0, half);
    const Frame edited = draw(solid, settingsWith(8));
    EXPECT_EQ(edited.layerCounts().layers, 1u);
    expectClose(pixel(edited.radiance(), 9, 9), over({0.4f, 0.5f, 0.6f, 0.5f}, glm::dvec4(0.0)), 1,
                "alpha 0.5");
}

TEST_F(LayerTest, aovsAndPickingShowTheFirstSurfaceOverAHalf) {
    const Material thin = blended({1, 0, 0, 0.3f}), thick = blended({0, 1, 0, 0.8f});
    Scene scene = sceneOf(makeQuad(8.0f), opaque({0.3f, 0.3f, 0.3f}), at({0, 0, -6}));
    place(scene, makeQuad(8.0f), thick, at({8, 0, -5}));
    const std::uint32_t nearest = place(scene, makeQuad(8.0f), thin, at({0, 0, -4}));
    GpuScene uploaded = upload(scene, someLights());
    const Frame frame = draw(uploaded, settingsWith(8));
    EXPECT_EQ(frame.layerCounts().layers, 2u);
    const std::uint64_t pairs = frame.countPairs().pairsLit;
    const AovReader aovs(frame.aovs({"Z", "base_color", "light_count"}), width);
    EXPECT_NEAR(aovs.scalar("Z", 4, 16), 6.0f, 1.0e-5f);
    EXPECT_NEAR(aovs.scalar("Z", width - 4, 16), 5.0f, 1.0e-5f);
    EXPECT_NEAR(aovs.vector("base_color", width - 4, 16).g, 1.0f, 0.01f);
    EXPECT_EQ(aovs.scalar("light_count", 4, 16), 0.0f) << "an unlit surface";
    EXPECT_EQ(aovs.scalar("light_count", width - 4, 16), 2.0f);
    EXPECT_EQ(frame.countPairs().pairsLit, pairs)
        << "counts are of the same surfaces whatever was asked before";
    const auto left = frame.probe(4, 16), right = frame.probe(width - 4, 16);
    ASSERT_TRUE(left && right);
    EXPECT_EQ(left->node, 0u);
    EXPECT_EQ(right->node, 1u);
    EXPECT_EQ(right->radiance, pixelOf(frame.radiance(), width - 4, 16));
    // Where the nearest one covers more than a half, it is what is shown.
    Material covering = thin;
    covering.baseColor.a = 0.6f;
    uploaded.setMaterial(*scene.meshes[*scene.nodes[nearest].mesh].submeshes[0].material, covering);
    EXPECT_EQ(draw(uploaded, settingsWith(8)).probe(4, 16)->node, nearest);
    FrameSettings debug = settingsWith(8);
    debug.debugView = DebugView::baseColor;
    EXPECT_NEAR(pixelOf(draw(uploaded, debug).radiance(), 4, 16).r, 1.0f, 0.01f);
}

TEST_F(LayerTest, coverageIsAveragedOverSamples) {
    GpuScene uploaded = upload(sceneOf(makeQuad(8.0f), unlit({0.2f, 0.4f, 0.8f, 0.25f}), at({0, 0, -3})));
    for (const Form& form : forms) {
        Accumulator accumulator(context());
        accumulator.addSamples(renderer(), uploaded, ahead(), settingsWith(8, form), {.count = 4}, 0, 4);
        expectClose(pixel(accumulator.radiance(), 20, 10), over({0.2f, 0.4f, 0.8f, 0.25f}, glm::dvec4(0.0)),
                    1, form.name);
    }
}

}  // namespace
}  // namespace candela::test
