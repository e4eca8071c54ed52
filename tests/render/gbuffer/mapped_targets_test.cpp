// Renderers whose targets move into memory that lighting reads in place. Of the frames before and after,
// every bit is the same.

#include "gl/external_memory.h"
#include "gl/mapped_texture.h"
#include "support/drawing_test.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"
#include "support/skies.h"

#include <candela/accumulator.h>
#include <candela/color.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace candela::test {
namespace {

// Rows of whole cache lines in every format: llvmpipe lays them out without gaps.
constexpr int width = 128, height = 90;

class MappedTargetsTest : public testing::Test {
  protected:
    void SetUp() override {
        const auto uuids = gl::importingDevice();
        if (!context_.isSoftware() || !uuids || gl::ExternalMemoryDevice::find(*uuids) == nullptr)
            GTEST_SKIP() << "targets are the driver's here";
    }
    const Context& context() const { return context_; }

    static FrameSettings settings(Shadows shadows = Shadows::off) {
        FrameSettings settings;
        settings.width = width;
        settings.height = height;
        settings.technique = Technique::tiles;
        settings.tileBackend = TileBackend::cpu;
        settings.shadows = shadows;
        return settings;
    }

  private:
    Context context_ = Context::createHeadless({.softwareOnly = true});
};

struct Textures {
    std::vector<GLuint> names;
    bool areMapped;  ///< All but the radiance.
};

Textures texturesOf(const Frame& frame) {
    Textures textures{{}, true};
    for (const FrameTexture& texture : frame.textures()) {
        textures.names.push_back(texture.texture);
        GLint tiling = 0;
        glGetTextureParameteriv(texture.texture, GL_TEXTURE_TILING_EXT, &tiling);
        const bool isMapped = tiling == GL_LINEAR_TILING_EXT;
        textures.areMapped = textures.areMapped && isMapped == (std::string(texture.name) != "radiance");
    }
    return textures;
}

/// Draws until the targets may have moved, which takes a thread and some frames.
void drawFrames(Renderer& renderer, GpuScene& scene, const CameraView& view, const FrameSettings& settings) {
    for (int i = 0; i < 8; ++i) {
        renderer.render(scene, view, settings);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

/// The scenes in which lighting reads each texture of the G-buffer.
std::vector<std::pair<LitScene, Shadows>> readScenes() {
    std::vector<std::pair<LitScene, Shadows>> scenes{{spheresOnAFloor(), Shadows::off},
                                                     {spheresOnAFloor(), Shadows::on},
                                                     {textured(), Shadows::off},
                                                     {manyLobes(), Shadows::on}};
    LitScene outdoors = textured();
    outdoors.scene.environment = studioEnvironment();
    scenes.emplace_back(outdoors, Shadows::on);
    LitScene glass = spheresOnAFloor();
    glass.scene.materials[0].alphaMode = AlphaMode::blend;
    glass.scene.materials[0].baseColor.a = 0.4f;
    scenes.emplace_back(glass, Shadows::off);
    return scenes;
}

TEST_F(MappedTargetsTest, picturesAreTheSame) {
    for (const auto& [lit, shadows] : readScenes()) {
        SCOPED_TRACE(lit.name);
        GpuScene scene(context(), lit.scene);
        scene.setLights(lit.lights);
        Renderer renderer(context());
        const HdrImage copied = renderer.render(scene, lit.view, settings(shadows)).radiance();
        drawFrames(renderer, scene, lit.view, settings(shadows));
        const Frame frame = renderer.render(scene, lit.view, settings(shadows));
        EXPECT_EQ(frame.radiance().rgba, copied.rgba);
        EXPECT_EQ(frame.readRadiance().get().rgba, copied.rgba);
        EXPECT_TRUE(texturesOf(frame).areMapped);
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    }
}

TEST_F(MappedTargetsTest, otherSizesAndPartsAreTheSame) {
    const LitScene lit = spheresOnAFloor();
    GpuScene scene(context(), lit.scene);
    scene.setLights(lit.lights);
    Renderer renderer(context());
    drawFrames(renderer, scene, lit.view, settings());
    for (const auto& [w, h] : {std::pair{width, height}, {101, 77}, {64, 1}, {320, 200}, {1, 1}}) {
        for (const Shadows shadows : {Shadows::off, Shadows::on, Shadows::off}) {
            FrameSettings sized = settings(shadows);
            sized.width = w;
            sized.height = h;
            Renderer fresh(context());
            EXPECT_EQ(renderer.render(scene, lit.view, sized).radiance().rgba,
                      fresh.render(scene, lit.view, sized).radiance().rgba)
                << w << " x " << h;
        }
    }
}

TEST_F(MappedTargetsTest, texturesThatAHostHasKeepTheirNames) {
    const LitScene lit = spheresOnAFloor();
    GpuScene scene(context(), lit.scene);
    scene.setLights(lit.lights);
    Renderer renderer(context());
    const Textures before = texturesOf(renderer.render(scene, lit.view, settings()));
    drawFrames(renderer, scene, lit.view, settings());
    const Textures after = texturesOf(renderer.render(scene, lit.view, settings()));
    EXPECT_EQ(after.names, before.names);
    EXPECT_FALSE(after.areMapped);
}

TEST_F(MappedTargetsTest, samplesThatOverlapAreTheSame) {
    const LitScene lit = spheresOnAFloor();
    GpuScene scene(context(), lit.scene);
    scene.setLights(lit.lights);
    const SamplingSettings sampling{.count = 6};
    Renderer fresh(context()), renderer(context());
    drawFrames(renderer, scene, lit.view, settings());
    Accumulator copied(context()), mapped(context());
    copied.addSamples(fresh, scene, lit.view, settings(), sampling, 0, sampling.count);
    const Frame last = mapped.addSamples(renderer, scene, lit.view, settings(), sampling, 0, sampling.count);
    EXPECT_EQ(mapped.radiance().rgba, copied.radiance().rgba);
    EXPECT_TRUE(texturesOf(last).areMapped);
}

}  // namespace
}  // namespace candela::test
