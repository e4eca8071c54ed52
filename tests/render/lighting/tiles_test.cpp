// Every implementation of the technique `tiles` (compute, and the kernel of each instruction set) gives the
// reference image.

#include "support/lit_scenes.h"
#include "support/procedural_scene.h"
#include "support/tile_implementations.h"

#include "gl/state_guard.h"
#include "render/lighting/tiled/compute_tiles.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace candela::test {
namespace {

class TilesTest : public testing::Test {
  protected:
    static void SetUpTestSuite() { shared_ = std::make_unique<Shared>(); }
    static void TearDownTestSuite() { shared_.reset(); }

    static const Context& context() { return shared_->context; }
    static std::vector<TileImplementation>& implementations() { return shared_->implementations; }

    /// Compares every implementation with `fullscreen`.
    ///
    /// Tolerance: the implementations take the same steps on the same texels, but sum in another order, round
    /// with fused products, and take roots and reciprocals to a unit in the last place. A highlight of width
    /// alpha magnifies some four roundings of 2^-24 of the half vector by 1 / alpha: 1e-4 at roughness 0.05,
    /// and 1e-3 at the minimum alpha, which `smoothAndBright` has.
    static void expectReference(const TileTestFrame& picture, const std::string& what,
                                double tolerance = 1.0e-4) {
        const std::vector<float> reference = radianceOf(context(), shared_->reference, picture);
        for (const TileImplementation& implementation : implementations()) {
            EXPECT_LE(worstDifference(radianceOf(context(), implementation, picture), reference), tolerance)
                << what << ", " << implementation.name;
        }
    }

    static double worstDifference(const std::vector<float>& radiance, const std::vector<float>& reference) {
        const double brightest = *std::ranges::max_element(reference);
        double worst = 0.0;
        for (std::size_t i = 0; i < reference.size(); ++i) {
            const double scale = reference[i] + 5.0e-3 * brightest + 1.0e-30;
            worst = std::max(worst, std::abs(double(radiance[i]) - double(reference[i])) / scale);
        }
        return worst;
    }

    static const TileImplementation& reference() { return shared_->reference; }

  private:
    struct Shared {
        Context context = Context::createHeadless();
        std::vector<TileImplementation> implementations = tileImplementations();
        TileImplementation reference = fullscreenImplementation();
    };
    static inline std::unique_ptr<Shared> shared_;
};

Scene wall() {
    return sceneOf(makeQuad(10.0f), Material{});
}

const CameraView front = lookAt({0, 0, 12}, {0, 0, 0}, 0.8f);

std::vector<WorldLight> lightsOverEveryTile(std::uint32_t count) {
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < count; ++i) {
        lights.push_back(pointLight({hashed(8, i) - 0.5f, hashed(9, i) - 0.5f, 1.0f + hashed(10, i)}, 40.0f,
                                    glm::vec3(1.0e-3f)));
    }
    return lights;
}

TEST_F(TilesTest, scenesOfTheEvaluatorsTestInBothModels) {
    for (const LitScene& lit : litScenes()) {
        // `sunAndSpots` has a cone whose ramp is 0.001 wide: it magnifies the rounding of the cosine by
        // 1,000, and its square by two more.
        const bool sharp = lit.name == smoothAndBright().name || lit.name == sunAndSpots().name;
        const double tolerance = sharp ? 1.0e-3 : 1.0e-4;
        const std::vector<WorldLight>& lights = lit.lights;
        for (const BrdfModel model : {BrdfModel::course, BrdfModel::gltf}) {
            expectReference({lit.scene, lights, lit.view, 96, 54, model}, lit.name, tolerance);
        }
    }
}

TEST_F(TilesTest, pixelsWithMoreLobesInBothModels) {
    const LitScene lit = manyLobes();
    // The power of sheen magnifies rounding by up to 1 / alpha.
    for (const BrdfModel model : {BrdfModel::course, BrdfModel::gltf})
        expectReference({lit.scene, lit.lights, lit.view, 96, 54, model}, lit.name, 4.0e-4);
}

TEST_F(TilesTest, noLightAndOneLight) {
    expectReference({wall(), {}, front}, "no light");
    const WorldLight one = pointLight({1, 2, 3}, 5.0f, {1, 2, 3});
    expectReference({wall(), std::span(&one, 1), front}, "one light");
}

TEST_F(TilesTest, seventyThousandLightsInOneTile) {
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < 70'000; ++i) {
        lights.push_back(
            pointLight({0.2f * hashed(1, i), 0.2f * hashed(2, i), 0.3f}, 1.0f, glm::vec3(1.0e-3f)));
    }
    // 70,000 terms of one size: the order of the sum alone gives an error of sqrt(70,000) roundings of 2^-24,
    // some 2e-5; fullscreen's blending in several draws adds nothing to that.
    expectReference({wall(), lights, front, 24, 16}, "70,000 lights", 1.0e-3);
}

TEST_F(TilesTest, lightsAtTheNearPlaneAndBehindTheCamera) {
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < 64; ++i) {
        const float z = 11.5f + 0.02f * float(i);
        lights.push_back(pointLight({hashed(3, i) - 0.5f, hashed(4, i) - 0.5f, z}, 14.0f, {5, 5, 4}));
    }
    expectReference({wall(), lights, front}, "near plane");
}

TEST_F(TilesTest, hugeAndTinyRanges) {
    std::vector<WorldLight> lights{
        pointLight({0, 0, 1}, 1.0e9f, {1, 1, 1}), pointLight({1, 0, 0.0005f}, 1.0e-3f, {1, 1, 1}),
        pointLight({-1, 1, 2}, 1.0e-12f, {1, 1, 1}), pointLight({0, 5000, 0.5f}, 6000.0f, {1.0e6f, 0, 0})};
    expectReference({wall(), lights, front}, "ranges");
}

TEST_F(TilesTest, imageSizesThatAreNoMultipleOfATile) {
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < 40; ++i) {
        lights.push_back(
            pointLight({16 * hashed(5, i) - 8, 10 * hashed(6, i) - 5, hashed(7, i) + 0.1f}, 3.0f, {4, 3, 2}));
    }
    const std::pair<int, int> sizes[] = {{1, 1}, {3, 2}, {17, 9}, {64, 64}, {65, 63}, {129, 67}};
    for (const auto& [width, height] : sizes) {
        expectReference({wall(), lights, front, width, height},
                        std::to_string(width) + "x" + std::to_string(height));
    }
}

TEST_F(TilesTest, imageOf7680By4320) {
    const Scene scene = wall();
    std::vector<WorldLight> lights{pointLight({-7, -4, 1}, 3.0f, {9, 3, 2}),
                                   pointLight({7, 4, 1}, 3.0f, {2, 3, 9}),
                                   spotLight({0, 0, 4}, {1, 0, 0}, 8.0f, {20, 20, 20}, 0.2f, 0.5f)};
    const TileTestFrame picture{scene, lights, front, 7680, 4320};
    // Only the widest kernel: the others do not differ from it in anything that depends on the size, and each
    // frame takes seconds.
    const TileImplementation& widest = implementations()[1];
    const std::vector<float> expected = radianceOf(context(), reference(), picture);
    EXPECT_LE(worstDifference(radianceOf(context(), widest, picture), expected), 1.0e-4);
}

TEST_F(TilesTest, emissionIsKept) {
    Material emissive;
    emissive.emission = {0.5f, 1.0f, 2.0f};
    const WorldLight light = pointLight({0, 0, 2}, 4.0f, {1, 1, 1});
    expectReference({sceneOf(makeQuad(3.0f), emissive), std::span(&light, 1), front}, "emission");
}

TEST_F(TilesTest, listsThatExceedTheirBufferDropNoLight) {
    // 1.3 million entries, more than the initial buffer of the compute implementation holds; two frames are
    // drawn, before and after the buffer has grown.
    expectReference({wall(), lightsOverEveryTile(12'000), front, 112, 64}, "long lists", 1.0e-3);
}

TEST_F(TilesTest, listsBeyondTheMemoryAreShadedInParts) {
    // 112 tiles of 8 pixels with 3,000 lights each: 1.3 MB of lists, of which 64 KiB may exist at a time. The
    // compute implementation detects it in the first frames.
    const std::vector<WorldLight> lights = lightsOverEveryTile(3000);
    const Scene scene = wall();
    TileTestFrame picture{scene, lights, front, 112, 64};
    picture.frames = 6;
    const std::vector<float> expected = radianceOf(context(), reference(), picture);
    for (const TileImplementation& implementation : limitedTileImplementations()) {
        EXPECT_LE(worstDifference(radianceOf(context(), implementation, picture), expected), 1.0e-3)
            << implementation.name;
        EXPECT_LE(implementation.technique->lightListBytes(), std::uint64_t{1} << 17) << implementation.name;
    }
}

TEST_F(TilesTest, computeTilesUseSeveralSpansWhereListsExceedTheBuffer) {
    const std::vector<WorldLight> lights = lightsOverEveryTile(3000);
    const Scene scene = wall();
    TileTestFrame picture{scene, lights, front, 112, 64};
    picture.frames = 6;
    auto technique = std::make_unique<ComputeTiles>(std::size_t{1} << 16);
    const ComputeTiles& tiles = *technique;
    const TileImplementation implementation{"compute", std::move(technique)};
    radianceOf(context(), implementation, picture);
    EXPECT_GT(tiles.spanCount(), 1u);
    // Few lights need one span again.
    picture.lights = std::span(lights).first(3);
    picture.frames = 16;
    radianceOf(context(), implementation, picture);
    EXPECT_EQ(tiles.spanCount(), 1u);
}

TEST_F(TilesTest, prefixSumsSaturate) {
    context().makeCurrent();
    const gl::StateGuard guard(*context().state().binding, "a test");
    const gl::Program prefix({{"tile_prefix.comp", {}, {}}}, "tile prefix sum");
    // 8×8 tiles. The first three lists have 2^31, 2^31 and 5 entries: a sum that wraps would give the third
    // and all later ones small offsets.
    std::vector<std::uint32_t> counts(64, 1);
    counts[0] = counts[1] = 0x80000000u;
    counts[2] = 5;
    layout::FrameUniforms uniforms{};
    uniforms.size = {64, 64, 0, 0};
    gl::Buffer frame("frame", gl::BufferUsage::dynamic), countBuffer("counts", gl::BufferUsage::dynamic),
        starts("starts", gl::BufferUsage::dynamic), lists("lists", gl::BufferUsage::dynamic),
        total("total", gl::BufferUsage::dynamic), groups("groups", gl::BufferUsage::dynamic);
    frame.upload(std::span<const layout::FrameUniforms>(&uniforms, 1));
    countBuffer.upload(std::span<const std::uint32_t>(counts));
    const std::vector<std::uint32_t> zeros(64, 0);
    for (gl::Buffer* buffer : {&starts, &lists, &total, &groups})
        buffer->upload(std::span<const std::uint32_t>(zeros));
    glBindBufferBase(GL_UNIFORM_BUFFER, layout::FRAME_BINDING, frame.name());
    const std::pair<int, gl::Buffer*> bindings[] = {{layout::TILE_COUNTS_STORAGE, &countBuffer},
                                                    {layout::TILE_STARTS_STORAGE, &starts},
                                                    {layout::TILE_LISTS_STORAGE, &lists},
                                                    {layout::TILE_TOTAL_STORAGE, &total},
                                                    {layout::TILE_GROUPS_STORAGE, &groups}};
    for (const auto& [binding, buffer] : bindings)
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, GLuint(binding), buffer->name());
    glUseProgram(prefix.name());
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::vector<std::uint32_t> result(64);
    glGetNamedBufferSubData(starts.name(), 0, 64 * 4, result.data());
    EXPECT_EQ(result[0], 0u);
    EXPECT_EQ(result[1], 0x80000000u);
    for (std::size_t tile = 2; tile < 64; ++tile) ASSERT_EQ(result[tile], 0xffffffffu) << tile;
    std::uint32_t entries = 0;
    glGetNamedBufferSubData(total.name(), 0, 4, &entries);
    EXPECT_EQ(entries, 0xffffffffu);
}

}  // namespace
}  // namespace candela::test
