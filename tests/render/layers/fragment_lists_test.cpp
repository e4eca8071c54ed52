// The rectangles of layers and what lies beyond them, against a count by each pixel; surfaces at one depth.

#include "render/layers/fragment_lists.h"
#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>

namespace candela::test {
namespace {

constexpr int width = 48, height = 32;

TEST(LayerExtents, areThoseOfTheCounts) {
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        const gl::PixelRectangle area{3, 5, 1 + int(hashed(seed, 0) * 9.0f), 1 + int(hashed(seed, 1) * 7.0f)};
        const auto limit = static_cast<std::uint32_t>(hashed(seed, 2) * 6.0f);
        std::vector<std::uint32_t> counts(std::size_t(area.width) * std::size_t(area.height));
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const float value = hashed(seed + 1000, std::uint32_t(i));
            counts[i] = value < 0.7f ? 0 : std::uint32_t((value - 0.7f) * 30.0f);
        }
        const LayerExtents extents = extentsOf(counts, area, limit);
        std::uint64_t beyond = 0;
        for (const std::uint32_t count : counts) beyond += count > limit ? count - limit : 0;
        EXPECT_EQ(extents.fragmentsBeyond, beyond);
        ASSERT_EQ(extents.layers.size(), std::min(limit, std::ranges::max(counts)));
        for (std::size_t layer = 0; layer < extents.layers.size(); ++layer) {
            int left = area.width, right = 0, bottom = area.height, top = 0;
            for (int y = 0; y < area.height; ++y) {
                for (int x = 0; x < area.width; ++x) {
                    if (counts[std::size_t(y * area.width + x)] <= layer) continue;
                    left = std::min(left, x), right = std::max(right, x + 1);
                    bottom = std::min(bottom, y), top = std::max(top, y + 1);
                }
            }
            const gl::PixelRectangle expected{area.x + left, area.y + bottom, right - left, top - bottom};
            EXPECT_EQ(extents.layers[layer].rectangle, expected) << "seed " << seed << ", layer " << layer;
        }
    }
}

Material unlit(const glm::vec4& color) {
    Material material;
    material.baseColor = color;
    material.alphaMode = AlphaMode::blend;
    material.unlit = true;
    return material;
}

glm::dvec4 over(const glm::vec4& front, const glm::dvec4& behind) {
    const double a = double(front.a);
    return {a * glm::dvec3(front) + (1.0 - a) * glm::dvec3(behind), a + (1.0 - a) * behind.a};
}

class DepthTieTest : public DrawingTest {
  protected:
    static FrameSettings settings(std::uint32_t layers, const Form& form) {
        FrameRequest request{width, height, lookAt({0, 0, 0}, {0, 0, -1}, 0.8f)};
        request.technique = form.technique;
        request.tileBackend = form.backend;
        request.layers = layers;
        return request.settings();
    }
    static void expectPixel(const HdrImage& picture, int x, const glm::dvec4& expected,
                            const std::string& what) {
        const std::size_t at = 4 * (std::size_t(height / 2) * width + std::size_t(x));
        // Half a code of the coverage, which has 16 bits, for each layer, and what blending rounds.
        for (std::size_t c = 0; c < 4; ++c)
            EXPECT_NEAR(picture.rgba[at + c], expected[glm::length_t(c)], 6.0 / 65535.0)
                << what << ", column " << x << ", channel " << c;
    }
};

// In front of one surface and behind another, some of three at one depth: each in the order of nodes.
TEST_F(DepthTieTest, surfacesAtOneDepthAreCompositedInTheOrderOfNodes) {
    constexpr std::array<glm::vec4, 5> tints{{{0.9f, 0.1f, 0.3f, 0.5f},
                                              {0.2f, 0.8f, 0.1f, 0.3f},
                                              {0.1f, 0.2f, 0.7f, 0.6f},
                                              {0.4f, 0.6f, 0.2f, 0.4f},
                                              {0.7f, 0.5f, 0.9f, 0.7f}}};
    const auto at = [](float x, float z) { return glm::translate(glm::mat4(1.0f), glm::vec3(x, 0, z)); };
    Scene scene = sceneOf(makeQuad(8.0f), unlit(tints[0]), at(0, -3));
    place(scene, makeQuad(8.0f), unlit(tints[1]), at(8, -3));
    place(scene, makeQuad(8.0f), unlit(tints[2]), at(0, -3));
    place(scene, makeQuad(8.0f), unlit(tints[3]), at(0, -2.5f));
    place(scene, makeQuad(8.0f), unlit(tints[4]), at(0, -3.5f));
    const glm::dvec4 nothing(0.0);
    const auto stack = [&](std::initializer_list<std::size_t> nearestFirst, std::size_t layers) {
        std::vector<std::size_t> kept(nearestFirst);
        kept.resize(std::min(kept.size(), layers));
        glm::dvec4 result = nothing;
        for (auto node = kept.rbegin(); node != kept.rend(); ++node) result = over(tints[*node], result);
        return result;
    };
    GpuScene uploaded = upload(scene);
    for (const Form& form : forms) {
        for (const std::uint32_t layers : {8u, 2u, 3u}) {
            const Frame frame =
                renderer().render(uploaded, lookAt({0, 0, 0}, {0, 0, -1}, 0.8f), settings(layers, form));
            const HdrImage picture = frame.radiance();
            const std::string what = std::string(form.name) + ", " + std::to_string(layers) + " layers";
            expectPixel(picture, 4, stack({3, 0, 2, 4}, layers), what);
            expectPixel(picture, width - 4, stack({3, 0, 1, 2, 4}, layers), what);
            EXPECT_EQ(frame.layerCounts().layers, std::min(layers, 5u)) << what;
            const std::uint64_t left = layers < 4 ? 4 - layers : 0, right = layers < 5 ? 5 - layers : 0;
            EXPECT_EQ(frame.layerCounts().fragmentsBeyond, (left + right) * (width / 2) * height) << what;
        }
    }
}

TEST_F(DepthTieTest, trianglesOfOneMeshAtOneDepthAreDrawnAsOftenAsTheyAreThere) {
    const glm::vec4 tint(0.3f, 0.6f, 0.2f, 0.4f);
    Mesh mesh = makeQuad(8.0f);
    const std::vector<std::uint32_t> once = mesh.indices;
    for (int i = 0; i < 2; ++i) mesh.indices.insert(mesh.indices.end(), once.begin(), once.end());
    GpuScene uploaded =
        upload(sceneOf(mesh, unlit(tint), glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, -3))));
    for (const Form& form : forms) {
        const Frame frame =
            renderer().render(uploaded, lookAt({0, 0, 0}, {0, 0, -1}, 0.8f), settings(8, form));
        expectPixel(frame.radiance(), 20, over(tint, over(tint, over(tint, glm::dvec4(0.0)))), form.name);
        EXPECT_EQ(frame.layerCounts().layers, 3u);
        EXPECT_EQ(frame.layerCounts().fragmentsBeyond, 0u);
    }
}

}  // namespace
}  // namespace candela::test
