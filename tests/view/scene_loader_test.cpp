// Scenes are read on a thread of their own; reading can be cancelled.

#include "scene_loader.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace {

using namespace std::chrono_literals;

std::atomic<int> wakes{0};

void wake() {
    ++wakes;
}

class SceneLoaderTest : public testing::Test {
  protected:
    void start(const std::string& scene) {
        SceneOptions options;
        options.scene = scene;
        options.scatter = scatter;
        loader.start(plugins, options, wake);
    }
    SceneLoader::Result await() {
        for (;;) {
            if (std::optional<SceneLoader::Result> result = loader.take()) return std::move(*result);
            std::this_thread::sleep_for(1ms);
        }
    }

    const candela::PluginRegistry plugins{{CANDELA_TEST_PLUGINS}};
    std::optional<candela::LightScatter> scatter;
    SceneLoader loader;
};

TEST_F(SceneLoaderTest, ReturnsTheSceneOnce) {
    wakes = 0;
    EXPECT_FALSE(loader.take());
    EXPECT_FALSE(loader.status());
    scatter = candela::LightScatter{5, {}, {}, 1};
    start("plaza:16");
    const SceneLoader::Result result = await();
    ASSERT_TRUE(result.scene);
    EXPECT_EQ(result.scene->scene.lights.size(), 21u);
    EXPECT_EQ(result.options.scene, "plaza:16");
    EXPECT_EQ(result.error, "");
    EXPECT_GE(wakes, 1) << "the window has to be notified";
    EXPECT_FALSE(loader.take());
    EXPECT_FALSE(loader.status());
}

TEST_F(SceneLoaderTest, ReturnsTheErrorWhenItFails) {
    wakes = 0;
    start("absent.gltf");
    const SceneLoader::Result result = await();
    EXPECT_FALSE(result.scene);
    EXPECT_NE(result.error.find("absent.gltf"), std::string::npos) << result.error;
    EXPECT_GE(wakes, 1);
}

TEST_F(SceneLoaderTest, ReportsProgress) {
    start("plaza:300000");
    const std::optional<LoadStatus> status = loader.status();
    ASSERT_TRUE(status);
    EXPECT_EQ(status->scene, "plaza:300000");
    EXPECT_GE(status->share, 0.0);
    EXPECT_LE(status->share, 1.0);
}

TEST_F(SceneLoaderTest, ACancelledSceneIsNotReturned) {
    start("plaza:300000");
    loader.cancel();
    EXPECT_FALSE(loader.status());
    const SceneLoader::Result result = await();
    EXPECT_FALSE(result.scene);
    EXPECT_EQ(result.error, "");
}

TEST_F(SceneLoaderTest, ASceneCancelledAfterReadingIsNotReturned) {
    start("plaza:1");
    // Usually read by now; if it is not, the test passes without covering this case.
    std::this_thread::sleep_for(500ms);
    loader.cancel();
    EXPECT_FALSE(await().scene);
}

TEST_F(SceneLoaderTest, ASecondSceneReplacesTheFirst) {
    start("plaza:300000");
    start("plaza:4");
    const SceneLoader::Result result = await();
    ASSERT_TRUE(result.scene);
    EXPECT_EQ(result.options.scene, "plaza:4");
    EXPECT_FALSE(loader.take());
}

TEST_F(SceneLoaderTest, CanBeDestroyedWhileReading) {
    start("plaza:300000");
}

}  // namespace
