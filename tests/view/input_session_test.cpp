// Pointer and keys move the camera and pick; the copied command draws the same image.

#include "own_display.h"
#include "view_session.h"

#include <glm/geometric.hpp>

#include <chrono>
#include <cmath>
#include <thread>

namespace {

constexpr int left = 1, middle = 2, right = 3, wheelUp = 4, wheelDown = 5;

/// The sample scene in a window without panels, which is the picture.
class InputSession : public ViewTest {
  protected:
    void SetUp() override {
        ViewTest::SetUp();
        if (IsSkipped()) return;
        session = std::make_unique<ViewSession>(
            std::vector<std::string>{"square.gltf", "--size", smallSize, "--brdf", "gltf"});
        session->awaitScene();
    }

    /// Expects the copied command line to draw exactly the shown image.
    void expectCommandDrawsThePicture() {
        const PngPicture shown = session->picture();
        const std::string command = session->copiedCommand();
        EXPECT_EQ(maxDifference(shown, renderedBy(command)), 0) << command;
    }

    const CameraControl& camera() { return session->model().camera; }

    std::unique_ptr<ViewSession> session;
};

TEST_F(InputSession, TheInitialCameraIsThatOfTheFile) {
    EXPECT_EQ(camera().eye(), glm::vec3(0.0f, 0.0f, 3.0f));
    EXPECT_FALSE(session->model().options.eye);
    expectCommandDrawsThePicture();
}

TEST_F(InputSession, LeftButtonOrbitsTheTarget) {
    const PngPicture before = session->picture();
    const float distance = glm::distance(camera().eye(), camera().target());
    session->drag(left, 160, 120, 200, 150);
    EXPECT_LT(camera().eye().x, -0.1f);
    EXPECT_GT(camera().eye().y, 0.1f);
    // Rounding of a few rotations in single precision.
    EXPECT_NEAR(glm::distance(camera().eye(), camera().target()), distance, 1.0e-5f);
    EXPECT_GT(maxDifference(session->picture(), before), 20);
    expectCommandDrawsThePicture();
}

TEST_F(InputSession, MiddleButtonAndShiftLeftPan) {
    session->drag(middle, 160, 120, 200, 120);
    const glm::vec3 eye = camera().eye();
    EXPECT_LT(eye.x, -0.1f);
    EXPECT_EQ(camera().target().x, eye.x);
    sendInput("keydown shift");
    session->drag(left, 160, 120, 160, 150);
    sendInput("keyup shift");
    EXPECT_GT(camera().eye().y, 0.1f);
    // Rounding of a sum.
    EXPECT_NEAR(camera().eye().y, camera().target().y, 1.0e-5f);
    expectCommandDrawsThePicture();
}

TEST_F(InputSession, WheelDollies) {
    session->pointTo(160, 120);
    sendInput("click " + std::to_string(wheelUp));
    session->settle();
    const float near = camera().eye().z;
    EXPECT_LT(near, 2.9f);
    EXPECT_GT(near, 1.0f);
    sendInput("click --repeat 2 " + std::to_string(wheelDown));
    session->settle();
    EXPECT_GT(camera().eye().z, 3.1f);
    expectCommandDrawsThePicture();
}

TEST_F(InputSession, RightButtonLooksAround) {
    session->drag(right, 160, 120, 190, 120);
    EXPECT_EQ(camera().eye(), glm::vec3(0.0f, 0.0f, 3.0f));
    EXPECT_GT(camera().target().x, 0.1f);
    expectCommandDrawsThePicture();
}

TEST_F(InputSession, RightButtonAndWFly) {
    session->pointTo(160, 120);
    sendInput("mousedown " + std::to_string(right));
    session->settle();
    // The window has been idle: the first step of the flight must not cover that time.
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    sendInput("keydown w");
    session->settle();
    const float first = camera().eye().z;
    EXPECT_LT(first, 3.0f);
    // Two seconds to the target, 3 m away; a step of the flight lasts a tenth of a second at most, and
    // settling takes four steps.
    EXPECT_GT(first, 3.0f - 4.0f * 0.1f * 1.6f);
    EXPECT_TRUE(session->stepUntil([&] { return camera().eye().z < first - 0.2f; }));
    sendInput("keyup w");
    session->settle();
    const glm::vec3 stopped = camera().eye();
    session->step(5);
    EXPECT_EQ(camera().eye(), stopped);
    sendInput("keydown d");
    EXPECT_TRUE(session->stepUntil([&] { return camera().eye().x > 0.1f; }));
    sendInput("keyup d mouseup " + std::to_string(right));
    session->settle();
    expectCommandDrawsThePicture();
}

TEST_F(InputSession, KeysDoNotFlyWithoutTheButton) {
    session->pointTo(160, 120);
    sendInput("keydown w");
    session->settle();
    sendInput("keyup w");
    session->settle();
    EXPECT_FALSE(session->model().options.eye);
}

TEST_F(InputSession, FFramesTheScene) {
    // By 75 degrees: the square leaves the image, but the eye stays on the side that it faces.
    session->drag(right, 160, 120, 260, 120);
    const std::size_t lost = session->picture().colors();
    session->pointTo(160, 120);
    sendInput("key f");
    session->settle();
    // The box of the square, without its light.
    EXPECT_EQ(camera().target(), glm::vec3(0.0f));
    EXPECT_GT(session->picture().colors(), lost + 10);
    expectCommandDrawsThePicture();
}

TEST_F(InputSession, AClickPicksAndShiftFFramesIt) {
    session->click(160, 120);
    EXPECT_EQ(session->model().pickedNode, 0u);
    session->click(5, 230);
    EXPECT_EQ(session->model().pickedNode, std::nullopt) << "the background";
    session->click(160, 120);
    EXPECT_FALSE(session->model().options.eye) << "a click moves nothing";
    sendInput("key shift+f");
    session->settle();
    EXPECT_TRUE(session->model().options.eye);
    EXPECT_EQ(camera().target(), glm::vec3(0.0f));
}

TEST_F(InputSession, APanelCapturesThePointer) {
    session->model().panelsHidden = false;
    session->step(3);
    // The panel of the camera lies in the right column from the menu bar down.
    session->drag(left, 300, 60, 280, 70);
    EXPECT_FALSE(session->model().options.eye);
    EXPECT_FALSE(session->model().pickedNode);
}

TEST_F(InputSession, ADragThatBeginsOverThePictureGoesOnOverAPanel) {
    session->model().panelsHidden = false;
    session->step(3);
    session->drag(left, 160, 120, 300, 120);
    const glm::vec3 eye = camera().eye();
    EXPECT_LT(eye.x, -0.5f);
    session->drag(left, 300, 60, 160, 120);
    EXPECT_EQ(camera().eye(), eye) << "one that begins over the panel does not";
}

TEST_F(InputSession, TheProbeReadsThePixelUnderThePointer) {
    session->model().panels.probe = true;
    session->pointTo(160, 100);
    ASSERT_TRUE(session->model().probe);
    EXPECT_EQ(session->model().pointer, glm::ivec2(160, 100));
    EXPECT_EQ(session->model().probe->node, 0u);
    // The packing of depth is 32-bit float at 3 m; the value comes back through one division.
    EXPECT_NEAR(session->model().probe->z, 3.0f, 1.0e-4f);
    EXPECT_EQ(session->model().probe->lightCount, 1u);
    const PngPicture shown = session->picture();
    const auto place = static_cast<std::size_t>(4 * (100 * shown.width + 160));
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_EQ(std::lround(session->model().probeDisplay[channel] * 255.0f),
                  shown.rgba[place + static_cast<std::size_t>(channel)]);
    session->pointTo(2, 100);
    EXPECT_FALSE(session->model().probe) << "the background";
}

/// A scene that takes long to draw, so that input lowers the resolution scale.
class SlowInputSession : public InputSession {
  protected:
    void SetUp() override {
        InputSession::SetUp();
        if (IsSkipped()) return;
        session->drop("plaza:512");
        session->model().options.technique = candela::Technique::fullscreen;
        session->step();
        session->model().options.display.exposure =
            1.0;  // so that the last frame's time includes no shader compilation
        session->step();
        // Slower than an interactive rate even on a fast machine: 512 lights at each of 76800 pixels.
        ASSERT_GT(session->model().frames.back().milliseconds, 60.0);
    }

    bool lowersResolution() {
        return session->stepUntil([&] { return session->model().divisor > 1; });
    }
};

TEST_F(SlowInputSession, LowersTheResolutionOnlyWhileTheCameraMoves) {
    session->pointTo(160, 120);
    sendInput("mousedown " + std::to_string(left));
    session->settle();
    sendInput("mousemove_relative 20 5");
    EXPECT_TRUE(lowersResolution());
    sendInput("mouseup " + std::to_string(left));
    EXPECT_TRUE(session->stepUntil([&] { return session->model().divisor == 1; }));
    const std::size_t drawn = session->model().frames.size();
    session->step(5);
    EXPECT_EQ(session->model().frames.size(), drawn) << "nothing is drawn while nothing changes";
    expectCommandDrawsThePicture();
}

TEST_F(SlowInputSession, TheProbeReadsTheLastPixelAtLowResolution) {
    session->resize(323, 243);  // neither is a multiple of 4
    session->model().panels.probe = true;
    session->pointTo(160, 60);
    sendInput("mousedown " + std::to_string(left));
    session->settle();
    sendInput("mousemove 322 242");
    EXPECT_TRUE(lowersResolution());
    EXPECT_EQ(session->model().pointer, glm::ivec2(322, 242));
    EXPECT_EQ(session->messages(Message::Kind::error), 0u);
    sendInput("mouseup " + std::to_string(left));
}

TEST_F(InputSession, EditsThatTheCommandCanNotExpressAreNoted) {
    session->document().setVisibility(0, candela::GpuScene::Visibility::hidden);
    session->copiedCommand();
    EXPECT_NE(session->model().messages.back().text.find("hidden node 0"), std::string::npos)
        << session->model().messages.back().text;
}

TEST_F(InputSession, AnImageIsSavedWithTheKeyboardOnly) {
    session->pointTo(160, 120);
    sendInput("key ctrl+s");
    session->settle();
    sendInput("type --delay 30 typed");
    session->settle();
    sendInput("key Return");
    session->settle();
    EXPECT_EQ(readPng(folder / "typed.png").width, 320);
}

}  // namespace
