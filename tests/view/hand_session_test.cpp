// Pointer and keys move the camera and pick; the copied command draws the very same picture.

#include "own_display.h"
#include "view_session.h"

#include <glm/geometric.hpp>

#include <chrono>
#include <cmath>
#include <thread>

namespace {

constexpr OpenPanels noPanels{.scene = false,
                              .material = false,
                              .lights = false,
                              .camera = false,
                              .color = false,
                              .drawing = false,
                              .statistics = false,
                              .probe = false};
constexpr int left = 1, middle = 2, right = 3, wheelUp = 4, wheelDown = 5;

/// The sample scene in a window without panels: what the pointer does is meant for the picture.
class HandSession : public ViewTest {
  protected:
    void SetUp() override {
        ViewTest::SetUp();
        if (IsSkipped()) return;
        session = std::make_unique<ViewSession>(
            std::vector<std::string>{"square.gltf", "--size", smallSize, "--brdf", "gltf"});
        session->model().panels = noPanels;
        session->awaitScene();
    }

    /// What the viewer shows now is what its command line draws, to the last code value.
    void expectCommandDrawsThePicture() {
        const PngPicture shown = session->picture();
        const std::string command = session->copiedCommand();
        EXPECT_EQ(maxDifference(shown, renderedBy(command)), 0) << command;
    }

    const CameraControl& camera() { return session->model().camera; }

    std::unique_ptr<ViewSession> session;
};

TEST_F(HandSession, TheFilesOwnCameraIsTheFirst) {
    EXPECT_EQ(camera().eye(), glm::vec3(0.0f, 0.0f, 3.0f));
    EXPECT_FALSE(session->model().options.eye);
    expectCommandDrawsThePicture();
}

TEST_F(HandSession, LeftButtonTurnsRoundTheTarget) {
    const PngPicture before = session->picture();
    const float distance = glm::distance(camera().eye(), camera().target());
    session->drag(left, 160, 120, 200, 150);
    EXPECT_LT(camera().eye().x, -0.1f);
    EXPECT_GT(camera().eye().y, 0.1f);
    // Rounding of a few turns in single precision.
    EXPECT_NEAR(glm::distance(camera().eye(), camera().target()), distance, 1.0e-5f);
    EXPECT_GT(maxDifference(session->picture(), before), 20);
    expectCommandDrawsThePicture();
}

TEST_F(HandSession, MiddleButtonAndShiftLeftMoveSideways) {
    session->drag(middle, 160, 120, 200, 120);
    const glm::vec3 eye = camera().eye();
    EXPECT_LT(eye.x, -0.1f);
    EXPECT_EQ(camera().target().x, eye.x);
    useHand("keydown shift");
    session->drag(left, 160, 120, 160, 150);
    useHand("keyup shift");
    EXPECT_GT(camera().eye().y, 0.1f);
    // Rounding of a sum.
    EXPECT_NEAR(camera().eye().y, camera().target().y, 1.0e-5f);
    expectCommandDrawsThePicture();
}

TEST_F(HandSession, WheelComesNearer) {
    session->pointTo(160, 120);
    useHand("click " + std::to_string(wheelUp));
    session->settle();
    const float near = camera().eye().z;
    EXPECT_LT(near, 2.9f);
    EXPECT_GT(near, 1.0f);
    useHand("click --repeat 2 " + std::to_string(wheelDown));
    session->settle();
    EXPECT_GT(camera().eye().z, 3.1f);
    expectCommandDrawsThePicture();
}

TEST_F(HandSession, RightButtonLooksAround) {
    session->drag(right, 160, 120, 190, 120);
    EXPECT_EQ(camera().eye(), glm::vec3(0.0f, 0.0f, 3.0f));
    EXPECT_GT(camera().target().x, 0.1f);
    expectCommandDrawsThePicture();
}

TEST_F(HandSession, RightButtonAndWFly) {
    session->pointTo(160, 120);
    useHand("mousedown " + std::to_string(right));
    session->settle();
    // The window has slept: the flight must not begin with a leap.
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    useHand("keydown w");
    session->settle();
    const float first = camera().eye().z;
    EXPECT_LT(first, 3.0f);
    // Two seconds to the target, 3 m away; a step of the flight lasts a tenth of a second at most, and
    // settling takes four steps.
    EXPECT_GT(first, 3.0f - 4.0f * 0.1f * 1.6f);
    EXPECT_TRUE(session->stepUntil([&] { return camera().eye().z < first - 0.2f; }));
    useHand("keyup w");
    session->settle();
    const glm::vec3 there = camera().eye();
    session->step(5);
    EXPECT_EQ(camera().eye(), there);
    useHand("keydown d");
    EXPECT_TRUE(session->stepUntil([&] { return camera().eye().x > 0.1f; }));
    useHand("keyup d mouseup " + std::to_string(right));
    session->settle();
    expectCommandDrawsThePicture();
}

TEST_F(HandSession, KeysDoNotFlyWithoutTheButton) {
    session->pointTo(160, 120);
    useHand("keydown w");
    session->settle();
    useHand("keyup w");
    session->settle();
    EXPECT_FALSE(session->model().options.eye);
}

TEST_F(HandSession, FBringsEverythingBack) {
    // By 75 degrees: past the picture's edge, but still on the side that the square faces.
    session->drag(right, 160, 120, 260, 120);
    const std::size_t lost = session->picture().colors();
    session->pointTo(160, 120);
    useHand("key f");
    session->settle();
    // The box of the square, without its light.
    EXPECT_EQ(camera().target(), glm::vec3(0.0f));
    EXPECT_GT(session->picture().colors(), lost + 10);
    expectCommandDrawsThePicture();
}

TEST_F(HandSession, AClickPicksAndShiftFFramesIt) {
    session->click(160, 120);
    EXPECT_EQ(session->model().pickedNode, 0u);
    session->click(5, 230);
    EXPECT_EQ(session->model().pickedNode, std::nullopt) << "the background";
    session->click(160, 120);
    EXPECT_FALSE(session->model().options.eye) << "a click moves nothing";
    useHand("key shift+f");
    session->settle();
    EXPECT_TRUE(session->model().options.eye);
    EXPECT_EQ(camera().target(), glm::vec3(0.0f));
}

TEST_F(HandSession, APanelKeepsThePointerForItself) {
    session->model().panels.camera = true;
    session->step(3);
    // The panel lies in the right column from the menu bar down.
    session->drag(left, 300, 60, 280, 70);
    EXPECT_FALSE(session->model().options.eye);
    EXPECT_FALSE(session->model().pickedNode);
}

TEST_F(HandSession, TheProbeTellsOfThePixelUnderThePointer) {
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

/// A scene that takes long to draw: the resolution scale of its picture is up to the hand.
class SlowHandSession : public HandSession {
  protected:
    void SetUp() override {
        HandSession::SetUp();
        if (IsSkipped()) return;
        session->drop("plaza:512");
        session->model().options.technique = candela::Technique::fullscreen;
        session->step();
        session->model().options.display.exposure = 1.0;  // a picture whose time holds no compiling
        session->step();
        // Far over what counts as fluent, even on a fast machine: 512 lights at each of 76800 pixels.
        ASSERT_GT(session->model().frames.back().milliseconds, 60.0);
    }

    bool lowersResolution() {
        return session->stepUntil([&] { return session->model().divisor > 1; });
    }
};

TEST_F(SlowHandSession, LowersTheResolutionOnlyWhileTheCameraMoves) {
    session->pointTo(160, 120);
    useHand("mousedown " + std::to_string(left));
    session->settle();
    useHand("mousemove_relative 20 5");
    EXPECT_TRUE(lowersResolution());
    useHand("mouseup " + std::to_string(left));
    EXPECT_TRUE(session->stepUntil([&] { return session->model().divisor == 1; }));
    const std::size_t drawn = session->model().frames.size();
    session->step(5);
    EXPECT_EQ(session->model().frames.size(), drawn) << "at rest nothing is drawn";
    expectCommandDrawsThePicture();
}

TEST_F(SlowHandSession, TheProbeReadsTheLastPixelAtLowResolution) {
    session->resize(323, 243);  // neither is a multiple of 4
    session->model().panels.probe = true;
    session->pointTo(160, 60);
    useHand("mousedown " + std::to_string(left));
    session->settle();
    useHand("mousemove 322 242");
    EXPECT_TRUE(lowersResolution());
    EXPECT_EQ(session->model().pointer, glm::ivec2(322, 242));
    EXPECT_EQ(session->messages(Message::Kind::error), 0u);
    useHand("mouseup " + std::to_string(left));
}

TEST_F(HandSession, TheClipboardSaysWhatTheCommandCanNot) {
    session->document().setVisibility(0, candela::GpuScene::Visibility::hidden);
    session->copiedCommand();
    EXPECT_NE(session->model().messages.back().text.find("hidden node 0"), std::string::npos)
        << session->model().messages.back().text;
}

TEST_F(HandSession, APictureIsSavedByTheKeysAlone) {
    session->pointTo(160, 120);
    useHand("key ctrl+s");
    session->settle();
    useHand("type --delay 30 typed");
    session->settle();
    useHand("key Return");
    session->settle();
    EXPECT_EQ(readPng(folder / "typed.png").width, 320);
}

}  // namespace
