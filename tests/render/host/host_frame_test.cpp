// What a frame gives to hosts: textures, depth, views in one call, pictures that are read later, files.

#include "host/host_drawing.h"

#include "render/display/display_target.h"

#include <candela/accumulator.h>
#include <candela/image_file.h>

#include <array>
#include <cmath>
#include <filesystem>

namespace candela::test {
namespace {

TEST_F(HostFrameTest, texturesHoldWhatReadingBackReturns) {
    const LitScene lit = wallAndSphere();
    GpuScene scene = upload(lit.scene, lit.lights);
    for (const TileBackend backend : {TileBackend::cpu, TileBackend::compute}) {
        const Frame frame = renderer().render(scene, lit.view, frameSettings(backend));
        const std::vector<FrameTexture> textures = frame.textures();
        const FrameTexture& radiance = named(textures, "radiance");
        EXPECT_EQ(radiance.target, GLenum(GL_TEXTURE_2D));
        EXPECT_EQ(radiance.internalFormat, GLenum(GL_RGBA32F));
        EXPECT_EQ(radiance.width, width);
        EXPECT_EQ(radiance.height, height);
        const std::vector<float> rgba = floatsOf(radiance.texture, GL_RGBA, 4);
        const std::vector<float> expected = frame.radiance().rgba;
        float light = 0.0f;
        for (std::size_t i = 0; i < rgba.size(); ++i) {
            if (i % 4 < 3) {
                ASSERT_EQ(rgba[i], expected[i]) << i;
            }
            light += expected[i];
        }
        EXPECT_GT(light, 100.0f);
        const std::vector<float> depth = floatsOf(named(textures, "depth").texture, GL_DEPTH_COMPONENT, 1);
        const std::vector<float> z = frame.aovs({"Z"})[0].values[0];
        for (std::size_t i = 0; i < pixels; ++i)
            ASSERT_EQ(z[i], depth[i] > 0.0f ? lit.view.nearPlane / depth[i] : 0.0f) << i;
        for (const FrameTexture& texture : textures) {
            GLint format = 0;
            glGetTextureLevelParameteriv(texture.texture, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
            EXPECT_EQ(GLenum(format), texture.internalFormat) << texture.name;
            EXPECT_FALSE(texture.meaning.empty());
        }
        named(textures, "surface");
        if (hasShadows()) named(textures, "shadow");
    }
}

TEST_F(HostFrameTest, theDisplayTextureHoldsTheDisplayedPicture) {
    const LitScene lit = wallAndSphere();
    GpuScene scene = upload(lit.scene, lit.lights);
    const Frame frame = renderer().render(scene, lit.view, frameSettings());
    const FrameTexture shown = frame.displayTexture(transform());
    EXPECT_EQ(shown.internalFormat, GLenum(GL_RGBA8));
    std::vector<std::uint8_t> codes(4 * pixels);
    glGetTextureImage(shown.texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(codes.size()), codes.data());
    flipRows(codes, width, height);
    EXPECT_EQ(codes, frame.displayPicture(transform()));
}

TEST_F(HostFrameTest, depthIsWrittenInTheConventionOfTheHost) {
    const LitScene lit = wallAndSphere();
    GpuScene scene = upload(lit.scene, lit.lights);
    using enum DepthConvention::Direction;
    for (const bool orthographic : {false, true}) {
        CameraView view = lit.view;
        if (orthographic) view.orthographicHeight = 3.0f;
        const Frame frame = renderer().render(scene, view, frameSettings());
        const std::vector<float> z = frame.aovs({"Z"})[0].values[0];
        const float nearPlane = 0.5f, farPlane = 60.0f;
        const glm::mat4 host = orthographic ? glm::orthoRH_NO(-1.0f, 1.0f, -1.0f, 1.0f, nearPlane, farPlane)
                                            : glm::perspectiveRH_NO(0.75f, 1.0f, nearPlane, farPlane);
        for (const auto direction : {classic, reversed}) {
            const HostTarget target;
            target.clear({0.1f, 0.2f, 0.3f, 0.4f}, 0.5f);
            frame.writeDepth({target.framebuffer.name()}, {direction, nearPlane, farPlane});
            const std::vector<float> depths = target.depths();
            int surfaces = 0;
            for (std::size_t i = 0; i < pixels; ++i) {
                const float background = direction == classic ? 1.0f : 0.0f;
                if (z[i] == 0.0f) {
                    ASSERT_EQ(depths[i], background);
                    continue;
                }
                ++surfaces;
                // OpenGL's own: the window depth of a host with its default clip control and depth range.
                const glm::dvec4 clip = glm::dmat4(host) * glm::dvec4(0, 0, -double(z[i]), 1);
                const double window = 0.5 + 0.5 * clip.z / clip.w;
                // The rounding of single precision near 1, and of the distance, which both pass.
                ASSERT_NEAR(depths[i], direction == classic ? window : 1.0 - window, 3e-7);
            }
            EXPECT_GT(surfaces, 1000);
            for (const float channel : floatsOf(target.color.name(), GL_RED, 1)) ASSERT_EQ(channel, 0.1f);
        }
        // The planes of the view: candela's own values.
        if (orthographic) {
            const HostTarget target;
            expectRefused([&] { frame.writeDepth({target.framebuffer.name()}, {}); }, "needs a far plane");
            continue;
        }
        const HostTarget target;
        frame.writeDepth({target.framebuffer.name()}, {reversed});
        EXPECT_EQ(target.depths(), floatsOf(named(frame.textures(), "depth").texture, GL_DEPTH_COMPONENT, 1));
    }
    const Frame frame = renderer().render(scene, lit.view, frameSettings());
    const HostTarget target;
    const FrameTarget into{target.framebuffer.name()};
    expectRefused([&] { frame.writeDepth(into, {classic, -1.0f, 3.0f}); }, "near plane of a host's depth");
    expectRefused([&] { frame.writeDepth(into, {classic, 1.0f, 0.5f}); }, "far plane of a host's depth");
    expectRefused([&] { frame.writeDepth({9999}, {}); }, "does not exist");
}

TEST_F(HostFrameTest, depthsBeyondTheHostsPlanesAreClamped) {
    const LitScene lit = wallAndSphere();
    GpuScene scene = upload(lit.scene, lit.lights);
    const Frame frame = renderer().render(scene, lit.view, frameSettings());
    const std::vector<float> z = frame.aovs({"Z"})[0].values[0];
    const HostTarget target(GL_DEPTH_COMPONENT24);
    frame.writeDepth({target.framebuffer.name()}, {DepthConvention::Direction::classic, 3.6f, 4.5f});
    const std::vector<float> depths = target.depths();
    for (std::size_t i = 0; i < pixels; ++i) {
        if (z[i] == 0.0f || z[i] >= 4.5f) {
            ASSERT_EQ(depths[i], 1.0f);
        } else if (z[i] <= 3.6f) {
            ASSERT_EQ(depths[i], 0.0f);
        } else {
            ASSERT_GT(depths[i], 0.0f);
        }
    }
}

TEST_F(HostFrameTest, picturesThatAreReadLaterAreThoseOfTheirFrame) {
    const LitScene lit = wallAndSphere();
    GpuScene scene = upload(lit.scene, lit.lights);
    for (const TileBackend backend : {TileBackend::cpu, TileBackend::compute}) {
        FrameSettings settings = frameSettings(backend);
        std::vector<PendingPicture> pictures;
        std::vector<PendingRadiance> radiances;
        std::vector<std::vector<std::uint8_t>> expectedPictures;
        std::vector<std::vector<float>> expectedRadiances;
        for (int i = 0; i < 4; ++i) {
            scene.setTransform(1, glm::translate(glm::mat4(1.0f), {0.3f * float(i), 0, 0}));
            settings.overlays.wireframe = i == 3;  // through the device
            const Frame frame = renderer().render(scene, lit.view, settings);
            pictures.push_back(frame.readDisplayPicture(transform()));
            radiances.push_back(frame.readRadiance());
            expectedPictures.push_back(frame.displayPicture(transform()));
            expectedRadiances.push_back(frame.radiance().rgba);
        }
        EXPECT_NE(expectedPictures[0], expectedPictures[1]);
        for (std::size_t i = 4; i-- > 0;) {
            EXPECT_EQ(pictures[i].get(), expectedPictures[i]) << toString(backend) << " " << i;
            EXPECT_EQ(radiances[i].get().rgba, expectedRadiances[i]) << toString(backend) << " " << i;
            expectRefused([&] { pictures[i].get(); }, "has been taken already");
            expectRefused([&] { pictures[i].ready(); }, "has been taken already");
        }
        // Also one that nobody takes, and one that is waited for by asking.
        const Frame frame = renderer().render(scene, lit.view, settings);
        const PendingPicture dropped = frame.readDisplayPicture(transform());
        PendingRadiance asked = frame.readRadiance();
        while (!asked.ready()) {
        }
        EXPECT_EQ(asked.get().rgba, frame.radiance().rgba);
    }
}

TEST_F(HostFrameTest, theMeanOfSamplesIsReadLaterAndHandedOutAsTextures) {
    const LitScene lit = wallAndSphere();
    GpuScene scene = upload(lit.scene, lit.lights);
    for (const TileBackend backend : {TileBackend::cpu, TileBackend::compute}) {
        Accumulator accumulator(context());
        expectRefused([&] { accumulator.readRadiance(); }, "before a frame was added");
        const auto add = [&](std::uint32_t first, std::uint32_t end) {
            accumulator.addSamples(renderer(), scene, lit.view, frameSettings(backend), {.count = 6}, first,
                                   end);
        };
        add(0, 3);
        PendingPicture picture = accumulator.readDisplayPicture(transform());
        PendingRadiance radiance = accumulator.readRadiance();
        const std::vector<std::uint8_t> expectedPicture = accumulator.displayPicture(transform());
        const std::vector<float> expectedRadiance = accumulator.radiance().rgba;
        const FrameTexture mean = accumulator.radianceTexture();
        EXPECT_EQ(mean.name, "radiance");
        EXPECT_EQ(mean.internalFormat, GLenum(GL_RGBA32F));
        EXPECT_EQ(floatsOf(mean.texture, GL_RGBA, 4), expectedRadiance);
        const FrameTexture shown = accumulator.displayTexture(transform());
        EXPECT_EQ(shown.name, "display");
        EXPECT_EQ(shown.width, width);
        std::vector<std::uint8_t> codes(4 * pixels);
        glGetTextureImage(shown.texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(codes.size()), codes.data());
        flipRows(codes, width, height);
        EXPECT_EQ(codes, expectedPicture);
        // Copies: further samples do not change them.
        add(3, 6);
        EXPECT_NE(accumulator.radiance().rgba, expectedRadiance);
        EXPECT_EQ(picture.get(), expectedPicture) << toString(backend);
        EXPECT_EQ(radiance.get().rgba, expectedRadiance) << toString(backend);
        const PendingPicture dropped = accumulator.readDisplayPicture(transform());
    }
}

TEST_F(HostFrameTest, radianceInMemoryIsShownAsTheFrameIs) {
    const LitScene lit = wallAndSphere();
    GpuScene scene = upload(lit.scene, lit.lights);
    const Frame frame = renderer().render(scene, lit.view, frameSettings(TileBackend::cpu));
    HdrImage radiance = frame.radiance();
    const std::vector<std::uint8_t> shown = displayPicture(radiance, transform());
    if (context().isSoftware()) {
        EXPECT_EQ(shown, frame.displayPicture(transform()));
    }
    radiance.rgba.pop_back();
    expectRefused([&] { displayPicture(radiance, transform()); }, "four a pixel");
}

TEST_F(HostFrameTest, viewsAreDrawnInOneCall) {
    const LitScene lit = wallAndSphere();
    GpuScene scene = upload(lit.scene, lit.lights);
    const auto views = stereoViews(lit.view, 0.2f, 4.0f, float(width) / height);
    std::vector<std::vector<float>> drawn;
    renderer().renderViews(scene, views, frameSettings(), [&](std::size_t view, const Frame& frame) {
        EXPECT_EQ(view, drawn.size());
        drawn.push_back(frame.radiance().rgba);
    });
    ASSERT_EQ(drawn.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(drawn[i], renderer().render(scene, views[i], frameSettings()).radiance().rgba);
    EXPECT_NE(drawn[0], drawn[1]);
}

TEST_F(HostFrameTest, exrFilesTakeAovsInOneCall) {
    const LitScene lit = wallAndSphere();
    GpuScene scene = upload(lit.scene, lit.lights);
    const Frame frame = renderer().render(scene, lit.view, frameSettings());
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "host_frame_test.exr";
    const HdrImage radiance = frame.radiance();
    std::vector<Aov> aovs = frame.aovs({"Z", "N"});
    writeExr(path, radiance, aovs, ColorConfig::builtIn().chromaticities());
    const Image read = readHdrFile(path).image;
    EXPECT_EQ(read.width, std::uint32_t(width));
    EXPECT_EQ(read.height, std::uint32_t(height));
    std::filesystem::remove(path);
    aovs[0].values[0].pop_back();
    EXPECT_THROW(writeExr(path, radiance, aovs, {}), Error);
    EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace candela::test
