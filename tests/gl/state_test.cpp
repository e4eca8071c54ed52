// candela restores a host's OpenGL state, and that state does not affect what is drawn.

#include "gl_state.h"
#include "host_context.h"
#include "small_scene.h"
#include "support/techniques.h"

#include "gl/state_guard.h"

#include <candela/color.h>

#include <gtest/gtest.h>

#include <array>
#include <optional>

namespace candela::test {
namespace {

class HostStateTest : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(host_.valid()); }

    HostContext host_{4, 5};
};

TEST_F(HostStateTest, guardRestoresState) {
    const Context context = Context::adoptCurrent();
    const UnusualState unusual;
    const GlState before = queryState();
    {
        const gl::StateGuard guard(*context.state().binding, "a test");
        EXPECT_GT(differences(before, queryState()).size(), 20u) << "the guard sets what passes rely on";
    }
    EXPECT_EQ(differences(before, queryState()), std::vector<std::string>{});
    EXPECT_EQ(host_.takeErrors(), std::vector<std::string>{});
}

TEST_F(HostStateTest, comparisonDetectsStateThatIsNotRestored) {
    const UnusualState unusual;
    const GlState before = queryState();
    glUseProgram(0);
    glBindTextureUnit(3, 0);
    glViewport(0, 0, 8, 8);
    glDisable(GL_BLEND);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, 0);
    EXPECT_GT(differences(before, queryState()).size(), 10u);
}

/// All that a host reads of one frame.
struct FrameOutputs {
    std::vector<float> radiance;
    std::vector<std::uint8_t> display;
    std::vector<std::vector<float>> aovs;
    PairCounts pairs;
    /// Of every debug view, with overlays.
    std::vector<std::vector<std::uint8_t>> views;
    std::optional<PixelProbe> probe;
    std::vector<PickedSurface> picked;
    std::vector<float> hosted;  ///< With surfaces and passes of the host.
};

/// Textures that stand for what a host has drawn: half of the picture is before everything.
class HostSurfaceTextures {
  public:
    HostSurfaceTextures(int width, int height) {
        glCreateTextures(GL_TEXTURE_2D, 2, names_.data());
        glTextureStorage2D(names_[0], 1, GL_RGBA16F, width, height);
        glTextureStorage2D(names_[1], 1, GL_DEPTH_COMPONENT24, width, height);
        std::vector<float> depth;
        for (int i = 0; i < width * height; ++i) depth.push_back(i % width < width / 2 ? 0.001f : 1.0f);
        const std::array<float, 4> green{0.0f, 0.5f, 0.0f, 1.0f};
        glClearTexImage(names_[0], 0, GL_RGBA, GL_FLOAT, green.data());
        glTextureSubImage2D(names_[1], 0, 0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
    }
    HostSurfaceTextures(const HostSurfaceTextures&) = delete;
    HostSurfaceTextures& operator=(const HostSurfaceTextures&) = delete;
    ~HostSurfaceTextures() { glDeleteTextures(2, names_.data()); }
    HostSurfaces surfaces() const { return {names_[0], names_[1], {}}; }

  private:
    std::array<GLuint, 2> names_{};
};

/// A framebuffer of depth alone.
class HostDepthTarget {
  public:
    HostDepthTarget() {
        glCreateTextures(GL_TEXTURE_2D, 1, &depth_);
        glTextureStorage2D(depth_, 1, GL_DEPTH24_STENCIL8, 48, 32);
        glCreateFramebuffers(1, &framebuffer_);
        glNamedFramebufferTexture(framebuffer_, GL_DEPTH_STENCIL_ATTACHMENT, depth_, 0);
    }
    HostDepthTarget(const HostDepthTarget&) = delete;
    HostDepthTarget& operator=(const HostDepthTarget&) = delete;
    ~HostDepthTarget() {
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteTextures(1, &depth_);
    }
    GLuint framebuffer() const { return framebuffer_; }

  private:
    GLuint depth_ = 0, framebuffer_ = 0;
};

/// What a pass of a host may leave behind.
void changeState(const FrameStage&) {
    glEnable(GL_STENCIL_TEST);
    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CW);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_ZERO);
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glViewport(0, 0, 1, 1);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, 0);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, 0);
    glPixelStorei(GL_PACK_ROW_LENGTH, 7);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

/// Makes calls, and expects the state after each to be unchanged.
class StateCheck {
  public:
    explicit StateCheck(HostContext& host) : host_(host), before_(queryState()) {}

    template <typename Call>
    auto operator()(const char* name, const Call& call) {
        struct AtEnd {
            StateCheck& check;
            const char* name;
            ~AtEnd() { check.verify(name); }
        } const atEnd{*this, name};
        return call();
    }

  private:
    void verify(const char* name) {
        EXPECT_EQ(differences(before_, queryState()), std::vector<std::string>{}) << "after " << name;
        EXPECT_EQ(host_.takeErrors(), std::vector<std::string>{}) << "after " << name;
    }
    HostContext& host_;
    GlState before_;
};

FrameOutputs drawChecked(HostContext& host, Technique technique, const HostSurfaceTextures& hostTextures) {
    const LitScene lit = smallScene();
    const DisplayTransform transform = ColorConfig::builtIn().displayTransform({});
    const HostDepthTarget depthTarget;
    StateCheck checked(host);
    const Context context = Context::adoptCurrent();
    Renderer renderer = checked("Renderer", [&] { return Renderer(context); });
    GpuScene scene = checked("GpuScene", [&] { return GpuScene(context, lit.scene); });
    checked("setLights", [&] { scene.setLights(lit.lights); });
    checked("setTransform", [&] { scene.setTransform(0, glm::mat4(1.0f)); });
    Frame frame = checked("render", [&] { return render(renderer, scene, smallFrame(lit, technique)); });
    FrameOutputs outputs;
    outputs.radiance = checked("radiance", [&] { return frame.radiance().rgba; });
    outputs.display = checked("displayPicture", [&] { return frame.displayPicture(transform); });
    const auto aovs = checked("aovs", [&] { return frame.aovs(Renderer::aovNames()); });
    for (const Aov& aov : aovs) outputs.aovs.insert(outputs.aovs.end(), aov.values.begin(), aov.values.end());
    outputs.pairs = checked("countPairs", [&] { return frame.countPairs(); });
    checked("passTimes", [&] { return frame.passTimes(); });
    outputs.picked = checked("pick", [&] { return frame.pick({4, 4, 30, 20}); });
    checked("textures", [&] { return frame.textures(); });
    checked("displayTexture", [&] { return frame.displayTexture(transform); });
    checked("writeDepth", [&] { frame.writeDepth({depthTarget.framebuffer()}, {}); });
    auto picture = checked("readDisplayPicture", [&] { return frame.readDisplayPicture(transform); });
    auto radiance = checked("readRadiance", [&] { return frame.readRadiance(); });
    checked("ready", [&] { return radiance.ready(); });
    EXPECT_EQ(checked("get of a picture", [&] { return picture.get(); }), outputs.display);
    EXPECT_EQ(checked("get of radiance", [&] { return radiance.get(); }).rgba, outputs.radiance);
    checked("keepPoses", [&] { scene.keepPoses(); });
    FrameSettings hosted = smallFrame(lit, technique).settings();
    hosted.hostSurfaces = hostTextures.surfaces();
    hosted.hooks.afterGeometry = changeState;
    hosted.hooks.beforeDisplay = changeState;
    frame = checked("render with a host's passes", [&] { return renderer.render(scene, lit.view, hosted); });
    outputs.hosted = checked("radiance of it", [&] { return frame.radiance().rgba; });
    for (const DebugView debugView : debugViews()) {
        FrameRequest inputs = smallFrame(lit, technique);
        inputs.debugView = debugView;
        inputs.overlays = {.wireframe = true, .cage = true};
        frame = checked(toString(debugView), [&] { return render(renderer, scene, inputs); });
        outputs.views.push_back(
            checked("display of a debug view", [&] { return frame.displayPicture(transform); }));
        checked("maxLightCount", [&] { return frame.maxLightCount(); });
        outputs.probe = checked("probe", [&] { return frame.probe(20, 14); });
    }
    GLint named = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &named);
    if (named != 0)
        checked("display", [&] { frame.display(transform, {static_cast<std::uint32_t>(named), 3, 5}); });
    return outputs;
}

TEST_F(HostStateTest, everyCallRestoresStateAndDrawsTheSame) {
    for (const Technique technique : techniques) {
        HostContext host(4, 5);
        const HostSurfaceTextures textures(48, 32);
        const FrameOutputs usual = drawChecked(host, technique, textures);
        ASSERT_FALSE(usual.radiance.empty());
        const UnusualState unusual;
        const FrameOutputs seen = drawChecked(host, technique, textures);
        EXPECT_EQ(seen.radiance, usual.radiance) << toString(technique);
        EXPECT_EQ(seen.display, usual.display);
        EXPECT_EQ(seen.aovs, usual.aovs);
        EXPECT_EQ(seen.hosted, usual.hosted);
        EXPECT_NE(usual.hosted, usual.radiance);
        ASSERT_EQ(seen.picked.size(), usual.picked.size());
        for (std::size_t i = 0; i < seen.picked.size(); ++i)
            EXPECT_EQ(seen.picked[i].pixels, usual.picked[i].pixels);
        EXPECT_EQ(seen.views, usual.views);
        ASSERT_TRUE(seen.probe && usual.probe);
        EXPECT_EQ(seen.probe->node, usual.probe->node);
        EXPECT_EQ(seen.probe->emission, usual.probe->emission);
        EXPECT_EQ(seen.pairs.pairsLit, usual.pairs.pairsLit);
        EXPECT_EQ(seen.pairs.pairsEvaluated, usual.pairs.pairsEvaluated);
    }
}

/// A framebuffer of the host, filled with one colour.
class HostTarget {
  public:
    static constexpr int width = 80, height = 60;
    static constexpr std::array<std::uint8_t, 4> fillColor{10, 200, 30, 77};

    HostTarget() {
        glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
        glTextureStorage2D(texture_, 1, GL_RGBA8, width, height);
        glClearTexImage(texture_, 0, GL_RGBA, GL_UNSIGNED_BYTE, fillColor.data());
        glCreateFramebuffers(1, &framebuffer_);
        glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, texture_, 0);
    }
    HostTarget(const HostTarget&) = delete;
    HostTarget& operator=(const HostTarget&) = delete;
    ~HostTarget() {
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteTextures(1, &texture_);
    }

    GLuint framebuffer() const { return framebuffer_; }

    /// RGBA, rows from the bottom.
    std::vector<std::uint8_t> pixels() const {
        std::vector<std::uint8_t> bytes(std::size_t{4} * width * height);
        glGetTextureImage(texture_, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bytes.size()),
                          bytes.data());
        return bytes;
    }

  private:
    GLuint texture_ = 0, framebuffer_ = 0;
};

TEST_F(HostStateTest, drawsIntoItsFramebufferAtAnOffsetAndNowhereElse) {
    const LitScene lit = smallScene();
    const DisplayTransform transform = ColorConfig::builtIn().displayTransform({});
    const Context context = Context::adoptCurrent();
    Renderer renderer(context);
    GpuScene scene(context, lit.scene);
    scene.setLights(lit.lights);
    constexpr int width = 40, height = 30, left = 17, bottom = 9;
    const Frame frame = render(renderer, scene, smallFrame(lit, Technique::volumes, width, height));
    const std::vector<std::uint8_t> picture = frame.displayPicture(transform);
    const HostTarget target;
    frame.display(transform, {target.framebuffer(), left, bottom});
    const std::vector<std::uint8_t> seen = target.pixels();
    for (int y = 0; y < HostTarget::height; ++y) {
        for (int x = 0; x < HostTarget::width; ++x) {
            const bool inside = x >= left && x < left + width && y >= bottom && y < bottom + height;
            const auto* actual = &seen[std::size_t(4 * (y * HostTarget::width + x))];
            const auto* expected =
                inside ? &picture[std::size_t(4 * ((height - 1 - (y - bottom)) * width + (x - left)))]
                       : HostTarget::fillColor.data();
            ASSERT_TRUE(std::equal(actual, actual + 4, expected)) << x << ", " << y;
        }
    }
    EXPECT_EQ(host_.takeErrors(), std::vector<std::string>{});
}

TEST_F(HostStateTest, pictureOverTheEdgeOfTheFramebufferIsClipped) {
    const LitScene lit = smallScene();
    const DisplayTransform transform = ColorConfig::builtIn().displayTransform({});
    const Context context = Context::adoptCurrent();
    Renderer renderer(context);
    GpuScene scene(context, lit.scene);
    const Frame frame = render(renderer, scene, smallFrame(lit, Technique::fullscreen, 40, 30));
    const HostTarget target;
    frame.display(transform, {target.framebuffer(), -20, HostTarget::height - 10});
    const std::vector<std::uint8_t> seen = target.pixels();
    EXPECT_TRUE(std::equal(HostTarget::fillColor.begin(), HostTarget::fillColor.end(), seen.begin()));
    EXPECT_EQ(seen[std::size_t(4 * (HostTarget::height - 1) * HostTarget::width) + 3], 255);
    EXPECT_EQ(host_.takeErrors(), std::vector<std::string>{});
}

}  // namespace
}  // namespace candela::test
