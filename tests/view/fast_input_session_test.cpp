// Input at the full speed of xdotool: nothing of it is lost, and the window shows what it did.

#include "own_display.h"
#include "view_session.h"

#include <imgui_internal.h>
#include <glm/geometric.hpp>

#include <string>

namespace {

constexpr int times = 100;

/// The sample scene in a window with its panels.
class FastInputSession : public ViewTest {
  protected:
    void SetUp() override {
        ViewTest::SetUp();
        if (IsSkipped()) return;
        session = std::make_unique<ViewSession>(
            std::vector<std::string>{"square.gltf", "--size", "480x360", "--shadows", "off"});
        session->model().panelsHidden = false;
        session->awaitScene();
        session->stepUntilIdle();
    }

    const CameraControl& camera() { return session->model().camera; }
    static bool popupIsOpen() { return !GImGui->OpenPopupStack.empty(); }

    std::unique_ptr<ViewSession> session;
};

TEST_F(FastInputSession, EveryChordIsTaken) {
    int opened = 0, closed = 0;
    for (int i = 0; i < times; ++i) {
        session->sendFast("key --delay 0 ctrl+s");
        opened += popupIsOpen();
        session->sendFast("key --delay 0 Escape");
        closed += !popupIsOpen();
    }
    EXPECT_EQ(opened, times);
    EXPECT_EQ(closed, times);
}

TEST_F(FastInputSession, ChordsInOneBurstAreAllTaken) {
    // GLFW takes two presses of a key in one millisecond for one that an input method repeats.
    std::string keys = "key --delay 4";
    for (int i = 0; i < times; ++i) keys += " space";
    // An even number of times: what plays is paused again. One more is not.
    session->sendFast(keys);
    EXPECT_FALSE(session->model().playing);
    sendInput("key --delay 0 space");
    EXPECT_TRUE(session->stepUntil([&] { return session->model().playing; }));
}

TEST_F(FastInputSession, EveryPickShowsInTheTreeAtOnce) {
    int picked = 0, shown = 0;
    for (int i = 0; i < times; ++i) {
        session->model().pickedNode.reset();
        session->step(3);
        session->sendFast("mousemove 240 180 click --delay 0 1");
        picked += session->model().pickedNode == 0u;
        const std::size_t hash = session->panelsHash();
        session->step(3);
        shown += session->panelsHash() == hash;
    }
    EXPECT_EQ(picked, times);
    EXPECT_EQ(shown, times);
}

TEST_F(FastInputSession, AQuickDragTurnsByItsOwnLengthOnly) {
    // 50 pixels of the picture's height, from which half a turn is the whole.
    session->sendFast("mousemove 220 180 mousedown 3 mousemove 270 180 mouseup 3");
    const glm::vec3 eye = camera().eye(), turned = camera().target();
    ASSERT_GT(glm::distance(turned, glm::vec3(0.0f)), 0.1f);
    int exact = 0;
    for (int i = 0; i < times; ++i) {
        // Back, from elsewhere, and again as at first.
        session->sendFast("mousemove 250 150 mousedown 3 mousemove 200 150 mouseup 3");
        session->sendFast("mousemove 210 220 mousedown 3 mousemove 260 220 mouseup 3 mousemove 230 150");
        // Rounding of angles in single precision, twice a turn.
        exact += glm::distance(camera().target(), turned) < 1.0e-5f * static_cast<float>(i + 2);
    }
    EXPECT_EQ(exact, times);
    EXPECT_EQ(camera().eye(), eye);
}

TEST_F(FastInputSession, ThePointerComesBackToWhereItLeft) {
    int picked = 0;
    for (int i = 0; i < 5; ++i) {
        session->model().pickedNode.reset();
        session->sendFast("mousemove 240 180 mousemove 600 450 mousemove 240 180");
        session->sendFast("mousemove 600 450");
        session->sendFast("mousemove 240 180 click --delay 0 1");
        picked += session->model().pickedNode == 0u;
    }
    EXPECT_EQ(picked, 5);
}

TEST_F(FastInputSession, AClickThatClosesAMenuPicksNothing) {
    session->click(20, 9);
    ASSERT_TRUE(popupIsOpen()) << "the menu is open";
    session->sendFast("mousemove 240 180 click --delay 0 1");
    EXPECT_FALSE(popupIsOpen());
    EXPECT_FALSE(session->model().pickedNode);
}

}  // namespace
