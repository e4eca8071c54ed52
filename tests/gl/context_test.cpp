#include "host_context.h"
#include "small_scene.h"

#include <candela/context.h>
#include <candela/error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace candela::test {
namespace {

std::vector<float> drawn(const Context& context, Renderer& renderer, const LitScene& lit) {
    context.makeCurrent();
    GpuScene scene(context, lit.scene);
    scene.setLights(lit.lights);
    return render(renderer, scene, smallFrame(lit, Technique::volumes)).radiance().rgba;
}

DeviceOptions software() {
    DeviceOptions options;
    options.softwareOnly = true;
    return options;
}

DeviceOptions deviceNumber(int index) {
    DeviceOptions options;
    options.index = index;
    return options;
}

/// The text and kind of the error that `action` throws; a failure when it throws none.
template <typename Action>
std::string errorOf(const Action& action, ErrorKind kind) {
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), kind);
        return error.what();
    }
    ADD_FAILURE() << "no error was thrown";
    return {};
}

TEST(HeadlessContext, isCurrentAndReportsTheAttempts) {
    const Context context = Context::createHeadless();
    EXPECT_FALSE(context.renderer().empty());
    ASSERT_FALSE(context.attempts().empty());
    EXPECT_EQ(context.attempts().back().outcome, context.renderer());
    for (const ContextAttempt& attempt : context.attempts()) {
        EXPECT_FALSE(attempt.way.empty());
        EXPECT_FALSE(attempt.outcome.empty());
    }
    EXPECT_GE(epoxy_gl_version(), 45);
}

TEST(HeadlessContext, tellsItsDriver) {
    const Context context = Context::createHeadless();
    const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    EXPECT_NE(context.driver().find(version), std::string::npos) << context.driver();
}

TEST(CurrentContextScope, putsBackWhatWasCurrent) {
    const Context first = Context::createHeadless(), second = Context::createHeadless();
    first.makeCurrent();
    const EGLContext before = eglGetCurrentContext();
    {
        const CurrentContextScope scope(second);
        EXPECT_NE(eglGetCurrentContext(), before);
        const CurrentContextScope inner(second);
    }
    EXPECT_EQ(eglGetCurrentContext(), before);
}

TEST(CurrentContextScope, leavesAContextToOtherThreads) {
    std::optional<Context> context;
    {
        const CurrentContextScope scope;
        context.emplace(Context::createHeadless());
    }
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
    {
        const CurrentContextScope scope(*context);
        std::thread([&] {
            EXPECT_NE(errorOf([&] { const CurrentContextScope here(*context); }, ErrorKind::environment), "");
        }).join();
    }
    std::thread([&] { EXPECT_NO_THROW(const CurrentContextScope here(*context)); }).join();
}

TEST(HeadlessContext, softwareOnlyGivesASoftwareDevice) {
    if (std::getenv("CANDELA_ASSUME_GPU") != nullptr)
        GTEST_SKIP() << "CANDELA_ASSUME_GPU hides software devices";
    const Context context = Context::createHeadless(software());
    EXPECT_TRUE(context.isSoftware()) << context.renderer();
}

TEST(HeadlessContext, everyListedDeviceCanBeSelected) {
    const std::vector<Device> devices = listDevices();
    for (const Device& device : devices) {
        EXPECT_EQ(device.index, &device - devices.data());
        EXPECT_FALSE(device.description.empty());
        if (!device.software) continue;  // A render node may be inaccessible to this user.
        const Context context = Context::createHeadless(deviceNumber(device.index));
        ASSERT_EQ(context.attempts().size(), 1u) << "an index selects this device only";
        EXPECT_NE(context.attempts()[0].way.find(std::to_string(device.index)), std::string::npos);
    }
}

TEST(HeadlessContext, indexBeyondTheDevicesIsAnError) {
    for (const int index : {-1, 999}) {
        const std::string text =
            errorOf([&] { Context::createHeadless(deviceNumber(index)); }, ErrorKind::environment);
        EXPECT_NE(text.find("no EGL device " + std::to_string(index)), std::string::npos) << text;
        EXPECT_NE(text.find(std::to_string(listDevices().size())), std::string::npos) << text;
    }
}

TEST(HeadlessContext, twoInOneProcessDrawTheSame) {
    const LitScene lit = smallScene();
    auto first = std::make_unique<Context>(Context::createHeadless());
    auto firstRenderer = std::make_unique<Renderer>(*first);
    const Context second = Context::createHeadless();
    Renderer secondRenderer(second);
    const std::vector<float> reference = drawn(*first, *firstRenderer, lit);
    EXPECT_GT(*std::ranges::max_element(reference), 0.0f);
    for (int iteration = 0; iteration < 2; ++iteration) {
        EXPECT_EQ(drawn(second, secondRenderer, lit), reference);
        EXPECT_EQ(drawn(*first, *firstRenderer, lit), reference);
    }
    first->makeCurrent();
    firstRenderer.reset();
    first.reset();
    EXPECT_EQ(drawn(second, secondRenderer, lit), reference) << "after the first context is destroyed";
}

TEST(HeadlessContext, staysTheSameWhenMoved) {
    const LitScene lit = smallScene();
    Context moved = [] {
        Context first = Context::createHeadless();
        return Context(std::move(first));
    }();
    Renderer renderer(moved);
    const std::vector<float> before = drawn(moved, renderer, lit);
    const Context again = std::move(moved);
    EXPECT_EQ(drawn(again, renderer, lit), before);
}

TEST(AdoptedContext, drawsLikeAHeadlessOne) {
    const LitScene lit = smallScene();
    std::vector<float> reference;
    {
        const Context headless = Context::createHeadless(software());
        Renderer renderer(headless);
        reference = drawn(headless, renderer, lit);
    }
    HostContext host(4, 5);
    ASSERT_TRUE(host.valid());
    {
        const Context adopted = Context::adoptCurrent();
        EXPECT_TRUE(adopted.attempts().empty());
        Renderer renderer(adopted);
        const std::vector<float> pixels = drawn(adopted, renderer, lit);
        if (adopted.isSoftware()) {
            EXPECT_EQ(pixels, reference);
        }
    }
    EXPECT_EQ(host.takeErrors(), std::vector<std::string>{});
    GLint major = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    EXPECT_GE(major, 4) << "the context is the host's: it outlives the adoption";
}

TEST(AdoptedContext, requiresACurrentContext) {
    { const Context gone = Context::createHeadless(); }
    const std::string text = errorOf([] { Context::adoptCurrent(); }, ErrorKind::environment);
    EXPECT_EQ(text, "no OpenGL context is current on this thread");
}

// Mesa offers an older version where the environment says so, which it reads once per process: each of the
// tests below runs in a process of its own.

[[noreturn]] void endWith(const std::string& text) {
    std::fputs(text.c_str(), stderr);
    std::exit(0);
}

TEST(OldOpenGlDeathTest, isRefusedInOneSentenceWhenAdopted) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        {
            setenv("MESA_GL_VERSION_OVERRIDE", "4.1", 1);
            HostContext host(3, 3);
            if (!host.valid()) endWith("no context");
            endWith(errorOf([] { Context::adoptCurrent(); }, ErrorKind::environment));
        },
        testing::ExitedWithCode(0), "^candela needs OpenGL 4\\.5, and this context \\(.*\\) offers 4\\.1$");
}

TEST(OldOpenGlDeathTest, isRefusedWithEveryAttemptWhenHeadless) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        {
            setenv("MESA_GL_VERSION_OVERRIDE", "4.1", 1);
            endWith(errorOf([] { Context::createHeadless(software()); }, ErrorKind::environment));
        },
        testing::ExitedWithCode(0),
        "^no OpenGL 4\\.5 context can be created without a window\\. .*EGL surfaceless display: .*4\\.5");
}

}  // namespace
}  // namespace candela::test
