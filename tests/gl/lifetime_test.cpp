// Objects that outlive their context, or are used under another: errors and messages instead of crashes.

#include "host_context.h"
#include "small_scene.h"

#include <candela/context.h>
#include <candela/error.h>

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace candela::test {
namespace {

/// A renderer with a scene and its first frame.
struct Drawing {
    explicit Drawing(const Context& context)
        : renderer(context), scene(context, lit.scene), frame(render(renderer, scene, request)) {}

    LitScene lit = smallScene();
    FrameRequest request = smallFrame(lit, Technique::volumes);
    Renderer renderer;
    GpuScene scene;
    Frame frame;
};

std::string errorOf(const auto& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

constexpr const char* notCurrent = "OpenGL context is not current on this thread";

TEST(LifetimeTest, aHeadlessContextLivesAsLongAsWhatIsMadeForIt) {
    std::optional<Context> context = Context::createHeadless();
    auto drawing = std::make_unique<Drawing>(*context);
    const std::vector<float> before = drawing->frame.radiance().rgba;
    context.reset();
    EXPECT_EQ(render(drawing->renderer, drawing->scene, drawing->request).radiance().rgba, before);
    testing::internal::CaptureStderr();
    drawing.reset();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(LifetimeTest, aRendererMakesItsContextCurrentAfterTheContextIsGone) {
    std::optional<Context> context = Context::createHeadless();
    Drawing drawing(*context);
    const std::vector<float> before = drawing.frame.radiance().rgba;
    context.reset();
    const Context other = Context::createHeadless();
    const auto draw = [&] {
        return render(drawing.renderer, drawing.scene, drawing.request).radiance().rgba;
    };
    EXPECT_NE(errorOf([&] { draw(); }).find("(another one is)"), std::string::npos)
        << errorOf([&] { draw(); });
    drawing.renderer.makeCurrent();
    EXPECT_EQ(draw(), before);
    std::string onThread;
    std::thread([&] { onThread = errorOf([&] { draw(); }); }).join();
    EXPECT_NE(onThread.find("(no context is)"), std::string::npos) << onThread;
}

TEST(LifetimeTest, destructionUnderAnotherHeadlessContextDoesNotAffectIt) {
    const Context first = Context::createHeadless();
    auto drawing = std::make_unique<Drawing>(first);
    const Context second = Context::createHeadless();
    Drawing other(second);
    const std::vector<float> reference = other.frame.radiance().rgba;
    testing::internal::CaptureStderr();
    drawing.reset();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(render(other.renderer, other.scene, other.request).radiance().rgba, reference)
        << "the second context is current again";
}

TEST(LifetimeTest, objectsOfADestroyedHostContextLeakWithAMessage) {
    auto host = std::make_unique<HostContext>(4, 5);
    ASSERT_TRUE(host->valid());
    auto drawing = std::make_unique<Drawing>(Context::adoptCurrent());
    host.reset();
    testing::internal::CaptureStderr();
    drawing.reset();
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_NE(text.find("a GpuScene is destroyed while its OpenGL context is gone"), std::string::npos)
        << text;
    EXPECT_NE(text.find("a Renderer is destroyed while its OpenGL context is gone"), std::string::npos)
        << text;
}

TEST(LifetimeTest, objectsOfAnotherHostContextAreNotDeleted) {
    HostContext first(4, 5);
    ASSERT_TRUE(first.valid());
    auto drawing = std::make_unique<Drawing>(Context::adoptCurrent());
    HostContext second(4, 5);
    ASSERT_TRUE(second.valid());
    const Context adopted = Context::adoptCurrent();
    Drawing other(adopted);
    const std::vector<float> reference = other.frame.radiance().rgba;
    testing::internal::CaptureStderr();
    drawing.reset();
    EXPECT_NE(testing::internal::GetCapturedStderr().find("leaked"), std::string::npos);
    EXPECT_EQ(render(other.renderer, other.scene, other.request).radiance().rgba, reference);
}

TEST(LifetimeTest, aContextAtTheAddressOfAnEarlierOneIsNotMistakenForIt) {
    auto host = std::make_unique<HostContext>(4, 5);
    ASSERT_TRUE(host->valid());
    const Context adopted = Context::adoptCurrent();
    auto drawing = std::make_unique<Drawing>(adopted);
    host.reset();
    // The driver may give this one the same address; the objects below reuse the names of the drawing's.
    HostContext next(4, 5);
    ASSERT_TRUE(next.valid());
    std::vector<GLuint> buffers(64);
    glCreateBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    testing::internal::CaptureStderr();
    drawing.reset();
    EXPECT_NE(testing::internal::GetCapturedStderr().find("leaked"), std::string::npos);
    for (const GLuint buffer : buffers) EXPECT_EQ(glIsBuffer(buffer), GL_TRUE) << buffer;
}

TEST(LifetimeTest, useWithoutTheContextIsAnError) {
    const Context context = Context::createHeadless();
    Drawing drawing(context);
    std::vector<std::string> texts;
    std::thread([&] {
        texts.push_back(errorOf([&] { render(drawing.renderer, drawing.scene, drawing.request); }));
        texts.push_back(errorOf([&] { drawing.frame.radiance(); }));
        texts.push_back(errorOf([&] { drawing.frame.passTimes(); }));
        texts.push_back(errorOf([&] { drawing.frame.probe(1, 1); }));
    }).join();
    for (const std::string& text : texts) EXPECT_NE(text.find(notCurrent), std::string::npos) << text;
    const Context second = Context::createHeadless();
    EXPECT_NE(errorOf([&] { drawing.frame.radiance(); }).find(notCurrent), std::string::npos);
}

TEST(LifetimeTest, aSceneOfAnotherContextIsRefused) {
    const Context first = Context::createHeadless();
    Drawing drawing(first);
    const Context second = Context::createHeadless();
    Drawing other(second);
    const std::string text = errorOf([&] { render(other.renderer, drawing.scene, drawing.request); });
    EXPECT_NE(text.find("another Context"), std::string::npos) << text;
}

TEST(LifetimeTest, useOfMovedFromObjectsIsAnError) {
    Context context = Context::createHeadless();
    Drawing drawing(context);
    const Renderer renderer = std::move(drawing.renderer);
    const Frame frame = std::move(drawing.frame);
    EXPECT_NE(errorOf([&] { render(drawing.renderer, drawing.scene, drawing.request); }).find("moved from"),
              std::string::npos);
    EXPECT_NE(errorOf([&] { drawing.frame.radiance(); }).find("moved from"), std::string::npos);
    const Context moved = std::move(context);
    EXPECT_NE(errorOf([&] { context.makeCurrent(); }).find("moved from"), std::string::npos);
    EXPECT_NE(errorOf([&] { context.renderer(); }).find("moved from"), std::string::npos);
}

// While the last context of a display is destroyed on one thread, others open the same display.
TEST(LifetimeTest, displaysAreOpenedAndClosedFromManyThreads) {
    std::atomic<int> failures{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&] {
            for (int k = 0; k < 25; ++k) {
                try {
                    const Context context = Context::createHeadless();
                    GLuint buffer = 0;
                    glCreateBuffers(1, &buffer);
                    failures += buffer == 0 || glGetError() != GL_NO_ERROR;
                } catch (const Error&) {
                    ++failures;
                }
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(failures, 0);
}

}  // namespace
}  // namespace candela::test
