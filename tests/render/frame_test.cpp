// Which data of a frame can be read, and when.

#include "support/drawing_test.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"

#include <candela/color.h>
#include <candela/error.h>

#include <epoxy/gl.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace candela::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

class FrameTest : public DrawingTest {
  protected:
    static FrameRequest request() {
        return {48, 32, lookAt({0, 0, 5}, {0, 0, 0}, 0.8f), BrdfModel::course, Technique::volumes};
    }
    static GpuScene sphere() {
        Scene scene;
        place(scene, makeSphere(1.0f), Material{});
        return upload(scene);
    }
    static DisplayTransform transform() { return ColorConfig::builtIn().displayTransform({}); }
};

TEST_F(FrameTest, isInvalidatedByTheNext) {
    GpuScene scene = sphere();
    const Frame first = test::render(renderer(), scene, request());
    const Frame second = test::render(renderer(), scene, request());
    const std::vector<std::function<void()>> reads{
        [&] { first.radiance(); },   [&] { first.displayPicture(transform()); },
        [&] { first.aovs({"Z"}); },  [&] { first.probe(0, 0); },
        [&] { first.countPairs(); }, [&] { first.passTimes(); },
        [&] { first.technique(); },  [&] { first.maxLightCount(); },
        [&] { first.width(); }};
    for (const auto& read : reads) expectRefused(read, "has drawn another one");
    EXPECT_EQ(second.radiance().width, 48);
}

TEST_F(FrameTest, outlivesItsRendererAndSceneWhereNothingIsRedrawn) {
    std::vector<float> expected;
    const auto frame = [&] {
        Renderer own(context());
        GpuScene scene = sphere();
        Frame drawn = test::render(own, scene, request());
        expected = drawn.radiance().rgba;
        return drawn;
    }();
    EXPECT_EQ(frame.radiance().rgba, expected);
    EXPECT_EQ(frame.displayPicture(transform()).size(), 48u * 32u * 4u);
    expectRefused([&] { frame.probe(24, 16); }, "GpuScene has been destroyed");
    expectRefused([&] { frame.countPairs(); }, "GpuScene has been destroyed");
    expectRefused([&] { frame.aovs({"emission"}); }, "GpuScene has been destroyed");
    EXPECT_EQ(frame.aovs({"Z"}).size(), 1u);
}

TEST_F(FrameTest, rejectsInvalidViews) {
    GpuScene scene = sphere();
    const auto with = [&](const std::function<void(CameraView&)>& change) {
        FrameRequest changed = request();
        change(changed.view);
        return [&scene, changed] { test::render(renderer(), scene, changed); };
    };
    for (const float bad : {nan, infinite}) {
        expectRefused(with([&](CameraView& v) { v.worldFromCamera[3].x = bad; }), "worldFromCamera");
        expectRefused(with([&](CameraView& v) { v.worldFromCamera[0].x = bad; }), "worldFromCamera");
        expectRefused(with([&](CameraView& v) { v.verticalFov = bad; }), "verticalFov");
        expectRefused(with([&](CameraView& v) { v.nearPlane = bad; }), "nearPlane");
    }
    const glm::mat4 identity(1.0f);
    expectRefused(with([&](CameraView& v) {
                      v.worldFromCamera = glm::scale(identity, {2, 2, 2});
                  }),
                  "worldFromCamera");
    expectRefused(with([&](CameraView& v) {
                      v.worldFromCamera = glm::scale(identity, {-1, 1, 1});
                  }),
                  "worldFromCamera");
    expectRefused(with([](CameraView& v) { v.worldFromCamera = glm::mat4(0.0f); }), "worldFromCamera");
    for (const float fov : {0.0f, -1.0f, 3.2f}) {
        expectRefused(with([&](CameraView& v) { v.verticalFov = fov; }), "verticalFov");
    }
    for (const float near : {0.0f, -0.1f}) {
        expectRefused(with([&](CameraView& v) { v.nearPlane = near; }), "nearPlane");
    }
    for (const float height : {0.0f, -1.0f, nan, infinite})
        expectRefused(with([&](CameraView& v) { v.orthographicHeight = height; }), "orthographicHeight");
    for (const float far : {0.0f, 0.01f, nan, infinite})
        expectRefused(with([&](CameraView& v) { v.farPlane = far; }), "farPlane");
    EXPECT_NO_THROW(with([](CameraView& v) { v.orthographicHeight = 2.0f, v.nearPlane = 0.0f; })());
    EXPECT_NO_THROW(test::render(renderer(), scene, request()));
}

TEST_F(FrameTest, rejectsIncompleteFramebuffers) {
    GpuScene scene = sphere();
    const Frame frame = test::render(renderer(), scene, request());
    GLuint incomplete = 0;
    glCreateFramebuffers(1, &incomplete);
    expectRefused([&] { frame.display(transform(), {.framebuffer = incomplete}); }, "is incomplete");
    expectRefused([&] { frame.display(transform(), {.framebuffer = 4711}); }, "does not exist");
    // A surfaceless context has no default framebuffer.
    expectRefused([&] { frame.display(transform(), {}); }, "is incomplete");
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << "nothing is left in the host's queue";
    glDeleteFramebuffers(1, &incomplete);
}

TEST_F(FrameTest, reportsEachPassOnce) {
    GpuScene scene = sphere();
    const Frame frame = test::render(renderer(), scene, request());
    for (int i = 0; i < 100; ++i) frame.displayPicture(transform());
    std::vector<std::string> names;
    for (const PassTime& pass : frame.passTimes()) names.push_back(pass.name);
    EXPECT_EQ(names, (std::vector<std::string>{"geometry", "lighting", "display"}));
}

TEST_F(FrameTest, rejectsAnAovThatIsNamedTwice) {
    GpuScene scene = sphere();
    const Frame frame = test::render(renderer(), scene, request());
    expectRefused([&] { frame.aovs({"Z", "N", "Z"}); }, "'Z' is asked for twice");
}

}  // namespace
}  // namespace candela::test
