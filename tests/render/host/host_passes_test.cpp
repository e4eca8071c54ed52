// What a frame takes from hosts: their surfaces, and passes of their own.

#include "host/host_drawing.h"

#include <candela/accumulator.h>
#include <candela/gbuffer.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace candela::test {
namespace {

TEST_F(HostFrameTest, hostSurfacesHideAndAreHiddenByDepth) {
    const LitScene lit = wallAndSphere();
    GpuScene scene = upload(lit.scene, lit.lights);
    const glm::vec3 color(0.25f, 3.0f, 0.5f);
    const glm::mat4 host = hostPlace(0.3f, 0.3f);  // through the sphere
    const std::vector<float> hostZ = distances(host, lit.view);
    for (const auto direction : {DepthConvention::Direction::classic, DepthConvention::Direction::reversed}) {
        const bool isClassic = direction == DepthConvention::Direction::classic;
        const HostTarget drawn;
        std::vector<float> depth(pixels, isClassic ? 1.0f : 0.0f), radiance(4 * pixels, 0.0f);
        const float nearPlane = 0.1f, farPlane = 50.0f;
        for (std::size_t i = 0; i < pixels; ++i) {
            const std::size_t from = (height - 1 - i / width) * width + i % width;  // rows from the top
            radiance[4 * i + 2] = 0.125f;                                           // behind everything
            if (hostZ[from] == 0.0f) continue;
            const float window =
                farPlane * (hostZ[from] - nearPlane) / (hostZ[from] * (farPlane - nearPlane));
            depth[i] = isClassic ? window : 1.0f - window;
            for (int c = 0; c < 3; ++c) radiance[4 * i + std::size_t(c)] = color[c];
        }
        glTextureSubImage2D(drawn.color.name(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, radiance.data());
        glTextureSubImage2D(drawn.depth.name(), 0, 0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT,
                            depth.data());
        for (const Technique technique : techniques) {
            FrameSettings settings = frameSettings();
            settings.technique = technique;
            const HdrImage without = renderer().render(scene, lit.view, settings).radiance();
            const std::vector<float> z = distancesOf(scene, lit.view, settings);
            settings.hostSurfaces = {
                drawn.color.name(), drawn.depth.name(), {direction, nearPlane, farPlane}};
            const Frame frame = renderer().render(scene, lit.view, settings);
            const HdrImage with = frame.radiance();
            const std::vector<float> withZ = frame.aovs({"Z"})[0].values[0];
            const std::vector<float> nodes = frame.aovs({"node_id"})[0].values[0];
            int front = 0, behind = 0, background = 0;
            for (std::size_t i = 0; i < pixels; ++i) {
                const int x = int(i) % width, y = int(i) / width;
                const glm::vec3 is = pixelOf(with, x, y);
                const bool hasHost = hostZ[i] > 0.0f, hasScene = z[i] > 0.0f;
                if (hasHost && hasScene && std::abs(hostZ[i] - z[i]) < 1e-3f) continue;  // rounding decides
                if (hasHost && (!hasScene || hostZ[i] < z[i])) {
                    ++front;
                    ASSERT_EQ(is, color) << x << ", " << y << " " << toString(technique);
                    // The host's depth has 24 bits and more, at 4 m of 0.1 m: 1e-5 m.
                    ASSERT_NEAR(withZ[i], hostZ[i], 1e-4f);
                    ASSERT_EQ(with.rgba[4 * i + 3], 1.0f);
                    ASSERT_EQ(nodes[i], 0.0f);
                } else if (hasScene) {
                    behind += hasHost;
                    ASSERT_EQ(is, pixelOf(without, x, y)) << x << ", " << y << " " << toString(technique);
                    ASSERT_EQ(withZ[i], z[i]);
                    ASSERT_NE(nodes[i], 0.0f);
                } else {
                    ++background;
                    ASSERT_EQ(is, glm::vec3(0, 0, 0.125f));
                    ASSERT_EQ(withZ[i], 0.0f);
                    ASSERT_EQ(with.rgba[4 * i + 3], 0.0f);
                }
            }
            EXPECT_GT(front, 100);
            EXPECT_GT(behind, 20);
            EXPECT_GT(background, 500);
        }
    }
}

TEST_F(HostFrameTest, hostSurfacesThatDoNotFitAreRefused) {
    const LitScene lit = wallAndSphere();
    GpuScene scene = upload(lit.scene, lit.lights);
    FrameSettings settings = frameSettings();
    const auto refused = [&](const HostSurfaces& host, const std::string& part) {
        settings.hostSurfaces = host;
        expectRefused([&] { renderer().render(scene, lit.view, settings); }, part);
    };
    refused({9999, 0, {}}, "does not exist");
    const gl::Texture small = gl::Texture::target2d(GL_RGBA32F, 8, 8, "small");
    refused({small.name(), 0, {}}, "has 8x8 pixels; the frame has 88x52");
    const gl::Texture volume(GL_TEXTURE_3D, "volume");
    glTextureStorage3D(volume.name(), 1, GL_R32F, width, height, 2);
    refused({0, volume.name(), {}}, "not of the type GL_TEXTURE_2D");
    const HostTarget target;
    refused({0, target.depth.name(), {DepthConvention::Direction::classic, 2.0f, 1.0f}}, "far plane");
}

TEST_F(HostFrameTest, hooksBeforeDisplayDrawInFrontOfAndBehindTheScene) {
    const LitScene lit = wallAndSphere();
    GpuScene scene = upload(lit.scene, lit.lights);
    const HostQuad quad("layout(location = 0) out vec4 color;", "color = vec4(0.5, 4.0, 0.25, 1.0);");
    const glm::mat4 host = hostPlace(0.3f, 0.3f);
    const std::vector<float> hostZ = distances(host, lit.view);
    for (const TileBackend backend : {TileBackend::cpu, TileBackend::compute}) {
        FrameSettings settings = frameSettings(backend);
        const HdrImage without = renderer().render(scene, lit.view, settings).radiance();
        const std::vector<float> z = distancesOf(scene, lit.view, settings);
        int calls = 0;
        settings.hooks.beforeDisplay = [&](const FrameStage& stage) {
            ++calls;
            EXPECT_EQ(stage.width, width);
            EXPECT_EQ(stage.height, height);
            EXPECT_EQ(stage.worldFromCamera, lit.view.worldFromCamera);
            quad.draw(stage, host);
            // Whatever else a host changes.
            glEnable(GL_BLEND);
            glBlendFunc(GL_ZERO, GL_ZERO);
            glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
            glClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
            glViewport(0, 0, 1, 1);
            glBindBufferBase(GL_UNIFORM_BUFFER, 0, 0);
            glPixelStorei(GL_PACK_ROW_LENGTH, 7);
        };
        settings.overlays.wireframe = true;  // drawn after it
        renderer().render(scene, lit.view, settings);
        settings.overlays.wireframe = false;
        const Frame frame = renderer().render(scene, lit.view, settings);
        EXPECT_EQ(calls, 2);
        const HdrImage with = frame.radiance();
        const std::vector<std::uint8_t> codes = frame.displayPicture(transform());
        int front = 0, behind = 0;
        for (std::size_t i = 0; i < pixels; ++i) {
            const int x = int(i) % width, y = int(i) / width;
            const bool hasHost = hostZ[i] > 0.0f, hasScene = z[i] > 0.0f;
            if (hasHost && hasScene && std::abs(hostZ[i] - z[i]) < 1e-3f) continue;
            if (hasHost && (!hasScene || hostZ[i] < z[i])) {
                ++front;
                ASSERT_EQ(pixelOf(with, x, y), glm::vec3(0.5f, 4.0f, 0.25f));
                ASSERT_EQ(with.rgba[4 * i + 3], 1.0f);
                ASSERT_EQ(codes[4 * i + 1], 255);
            } else {
                behind += hasHost;
                ASSERT_EQ(pixelOf(with, x, y), pixelOf(without, x, y)) << x << ", " << y;
            }
        }
        EXPECT_GT(front, 100);
        EXPECT_GT(behind, 20);
    }
}

TEST_F(HostFrameTest, hooksAfterGeometryAddSurfacesWithAndWithoutLight) {
    const LitScene lit = wallAndSphere();
    const glm::mat4 place = hostPlace(-0.2f, 0.4f);
    // What candela shades of a surface that lies there, and what the host packs of the same.
    LitScene filled = lit;
    Material material;
    material.baseColor = {0.8f, 0.4f, 0.2f, 1.0f};
    material.roughness = 0.5f;
    material.metallic = 0.0f;
    test::place(filled.scene, makeQuad(1.0f), material, place);
    GBufferSurface surface;
    surface.lobes.baseColor = glm::vec3(0.8f, 0.4f, 0.2f);
    surface.lobes.roughness = 0.5f;
    const GBufferTexel texel = packSurface(surface);
    const std::string words = "uvec2(" + std::to_string(texel.x) + "u, " + std::to_string(texel.y) + "u)";
    const char* outputs =
        "layout(location = 0) out uvec2 surface; layout(location = 1) out vec4 radiance; layout(location = "
        "2) "
        "out uint shadow;";
    const HostQuad unlit(outputs, "surface = uvec2(0u); radiance = vec4(0.5, 4.0, 0.25, 0.0); shadow = 0u;");
    const HostQuad shaded(outputs, ("surface = " + words + "; radiance = vec4(0.0); shadow = 0u;").c_str());
    GpuScene scene = upload(lit.scene, lit.lights), complete = upload(filled.scene, filled.lights);
    const std::vector<float> hostZ = distances(place, lit.view);
    for (const Technique technique : techniques) {
        FrameSettings settings = frameSettings();
        settings.technique = technique;
        settings.shadows = Shadows::off;
        settings.specularAntialiasing = false;  // which the host's shader has not
        const std::vector<float> z = distancesOf(scene, lit.view, settings);
        const HdrImage expected = renderer().render(complete, lit.view, settings).radiance();
        for (const bool isLit : {false, true}) {
            settings.hooks.afterGeometry = [&](const FrameStage& stage) {
                (isLit ? shaded : unlit).draw(stage, place);
            };
            const HdrImage with = renderer().render(scene, lit.view, settings).radiance();
            int front = 0;
            for (std::size_t i = 0; i < pixels; ++i) {
                const int x = int(i) % width, y = int(i) / width;
                const bool hasHost = hostZ[i] > 0.0f && (z[i] == 0.0f || hostZ[i] < z[i] - 1e-3f);
                if (!hasHost) continue;
                ++front;
                const glm::vec3 is = pixelOf(with, x, y);
                if (!isLit) {
                    ASSERT_EQ(is, glm::vec3(0.5f, 4.0f, 0.25f)) << toString(technique);
                } else {
                    // Positions differ by the rounding of the depth.
                    const glm::vec3 should = pixelOf(expected, x, y);
                    ASSERT_LT(glm::distance(is, should), 1e-4f + 2e-3f * glm::length(should));
                    ASSERT_GT(is.x, 0.0f);
                }
            }
            EXPECT_GT(front, 100);
        }
        settings.hooks = {};
    }
}

TEST_F(HostFrameTest, hooksMayThrowAndSamplesCallThemEachTime) {
    const LitScene lit = wallAndSphere();
    GpuScene scene = upload(lit.scene, lit.lights);
    FrameSettings settings = frameSettings();
    settings.hooks.beforeDisplay = [](const FrameStage&) { throw std::runtime_error("the host's"); };
    EXPECT_THROW(renderer().render(scene, lit.view, settings), std::runtime_error);
    int calls = 0;
    settings.hooks.beforeDisplay = [&](const FrameStage&) { ++calls; };
    SamplingSettings sampling;
    sampling.count = 5;
    Accumulator accumulator(context());
    accumulator.addSamples(renderer(), scene, lit.view, settings, sampling, 0, 5);
    EXPECT_EQ(calls, 5);
    settings.hooks = {};
    Accumulator reference(context());
    reference.addSamples(renderer(), scene, lit.view, settings, sampling, 0, 5);
    const std::vector<float> a = accumulator.radiance().rgba, b = reference.radiance().rgba;
    // The sum is on the device in one and in memory in the other, by the same additions.
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], 1e-6f + 1e-5f * b[i]) << i;
}

}  // namespace
}  // namespace candela::test
