// Events of any speed reach ImGui one after another.

#include "input_queue.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <string>

namespace {

using Press = InputQueue::Press;

/// The events of each frame, as ImGui would see them.
class InputQueueTest : public testing::Test {
  protected:
    void tap(int key) {
        queue.pressKey(key, Press::down);
        queue.pressKey(key, Press::up);
    }
    void frame() {
        io.MouseWheel = 0.0f;
        queue.beginFrame(io);
    }
    /// The number of frames until all events are taken.
    int frames() {
        int count = 0;
        for (; !queue.empty(); ++count) frame();
        return count;
    }

    InputQueue queue;
    ImGuiIO io;
};

TEST_F(InputQueueTest, AKeyThatIsLetGoAtOnceIsDownForOneFrame) {
    tap(GLFW_KEY_F);
    frame();
    EXPECT_TRUE(io.KeysDown[GLFW_KEY_F]);
    frame();
    EXPECT_FALSE(io.KeysDown[GLFW_KEY_F]);
    EXPECT_TRUE(queue.empty());
}

TEST_F(InputQueueTest, AChordIsDownTogether) {
    queue.pressKey(GLFW_KEY_LEFT_CONTROL, Press::down);
    tap(GLFW_KEY_S);
    queue.pressKey(GLFW_KEY_LEFT_CONTROL, Press::up);
    frame();
    EXPECT_TRUE(io.KeysDown[GLFW_KEY_S]);
    EXPECT_TRUE(io.KeyCtrl);
    frame();
    EXPECT_FALSE(io.KeysDown[GLFW_KEY_S]);
    EXPECT_FALSE(io.KeyCtrl);
}

TEST_F(InputQueueTest, AModifierAfterAKeyDoesNotChangeIt) {
    queue.pressKey(GLFW_KEY_F, Press::down);
    queue.pressKey(GLFW_KEY_LEFT_SHIFT, Press::down);
    frame();
    EXPECT_TRUE(io.KeysDown[GLFW_KEY_F]);
    EXPECT_FALSE(io.KeyShift);
    frame();
    EXPECT_TRUE(io.KeyShift);
}

TEST_F(InputQueueTest, AClickIsDownForOneFrameWhereItWas) {
    queue.movePointer({10.0f, 20.0f});
    queue.pressButton(0, Press::down);
    queue.pressButton(0, Press::up);
    queue.movePointer({70.0f, 20.0f});
    frame();
    EXPECT_FALSE(io.MouseDown[0]) << "the way to the place of the press is no drag";
    frame();
    EXPECT_TRUE(io.MouseDown[0]);
    EXPECT_EQ(io.MousePos.x, 10.0f);
    frame();
    EXPECT_FALSE(io.MouseDown[0]);
    EXPECT_EQ(io.MousePos.x, 10.0f);
    frame();
    EXPECT_EQ(io.MousePos.x, 70.0f);
}

TEST_F(InputQueueTest, MovesAndStepsOfTheWheelAreTakenTogether) {
    for (int i = 0; i < 50; ++i) queue.movePointer({static_cast<float>(i), 0.0f});
    EXPECT_EQ(frames(), 1);
    EXPECT_EQ(io.MousePos.x, 49.0f);
    for (int i = 0; i < 3; ++i) queue.turnWheel({0.0f, 1.0f});
    frame();
    EXPECT_EQ(io.MouseWheel, 3.0f);
    EXPECT_TRUE(queue.empty());
}

TEST_F(InputQueueTest, TypedTextKeepsItsOrderWithKeysThatEdit) {
    const auto typed = [this](int key, unsigned character) {
        queue.pressKey(key, Press::down);
        queue.type(character);
        queue.pressKey(key, Press::up);
    };
    typed(GLFW_KEY_A, 'a');
    tap(GLFW_KEY_BACKSPACE);
    typed(GLFW_KEY_B, 'b');
    std::string seen;
    while (!queue.empty()) {
        io.InputQueueCharacters.clear();
        frame();
        if (io.KeysDown[GLFW_KEY_BACKSPACE]) seen += '<';
        for (const ImWchar character : io.InputQueueCharacters) seen += static_cast<char>(character);
    }
    EXPECT_EQ(seen, "a<b");
}

TEST_F(InputQueueTest, ThePointerLeavesOnlyWithoutAButton) {
    queue.movePointer({5.0f, 5.0f});
    queue.pressButton(2, Press::down);
    queue.leave();
    frames();
    EXPECT_EQ(io.MousePos.x, 5.0f);
    queue.pressButton(2, Press::up);
    queue.leave();
    frames();
    EXPECT_LT(io.MousePos.x, -1.0e30f);
}

TEST_F(InputQueueTest, UnknownKeysAndButtonsAreIgnored) {
    queue.pressKey(GLFW_KEY_UNKNOWN, Press::down);
    queue.pressKey(100000, Press::down);
    queue.pressButton(7, Press::down);
    queue.pressButton(-1, Press::down);
    EXPECT_TRUE(queue.empty());
}

}  // namespace
