// The timeline, by pointer and keys: playing, scrubbing, clips and repetition.

#include "own_display.h"
#include "view_session.h"

#include <imgui_internal.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace {

class TimelineSession : public ViewTest {
  protected:
    void SetUp() override {
        ViewTest::SetUp();
        if (IsSkipped()) return;
        // "sway" of 1 s, as the sample scene has it, and "still", of the same keys, on no light.
        nlohmann::json scene = nlohmann::json::parse(std::ifstream(folder / "square.gltf"));
        scene["animations"][0]["name"] = "sway";
        scene["animations"].push_back(scene["animations"][0]);
        scene["animations"][1]["name"] = "still";
        scene["animations"][1]["channels"][0]["target"]["node"] = 3;
        folder.write("clips.gltf", scene.dump());
        session = std::make_unique<ViewSession>(
            std::vector<std::string>{"clips.gltf", "--size", "640x400", "--shadows", "off", "--camera", "0"});
        session->model().panels = {};
        session->model().panels = {
            .scene = false, .lights = false, .camera = false, .color = false, .drawing = false};
        session->model().panelsHidden = false;
        session->awaitScene();
        session->stepUntilIdle();
        const ImGuiWindow* panel = ImGui::FindWindowByName("Timeline");
        ASSERT_NE(panel, nullptr);
        left = static_cast<int>(panel->Pos.x);
        right = left + static_cast<int>(panel->Size.x);
        row = static_cast<int>(panel->Pos.y + 0.5f * panel->Size.y);
    }
    double& time() { return session->model().options.time; }
    bool popupIsOpen() const { return !GImGui->OpenPopupStack.empty(); }
    /// Clicks along the row from its right end until `reached`.
    bool clickFromRight(const std::function<bool()>& reached) {
        for (int x = right - 8; x > left && !reached(); x -= 12) session->click(x, row);
        return reached();
    }

    std::unique_ptr<ViewSession> session;
    int left = 0, right = 0, row = 0;
};

TEST_F(TimelineSession, TheFirstButtonAndTheKeyPlayAndPause) {
    session->click(left + 20, row);
    ASSERT_TRUE(session->model().playing);
    const PngPicture start = rendered({"clips.gltf", "--size", "320x240", "--shadows", "off"});
    ASSERT_TRUE(session->stepUntil([&] { return time() > 0.1; }));
    session->click(left + 20, row);
    EXPECT_FALSE(session->model().playing);
    const double paused = time();
    session->step(5);
    EXPECT_EQ(time(), paused);
    sendInput("key --delay 0 space");
    EXPECT_TRUE(session->stepUntil([&] { return session->model().playing && time() > paused; }));
    session->sendFast("key --delay 0 space");
}

TEST_F(TimelineSession, TheSliderScrubsOverTheClip) {
    const int middle = (left + right) / 2;
    session->click(middle, row);
    const double first = time();
    EXPECT_GT(first, 0.0);
    EXPECT_LT(first, 1.0);
    EXPECT_EQ(session->document().time(), first) << "the scene is posed then";
    const glm::vec3 there = session->document().lights()[0].position;
    session->drag(1, middle, row, middle + 40, row);
    EXPECT_GT(time(), first);
    EXPECT_GT(glm::distance(session->document().lights()[0].position, there), 0.0f);
    EXPECT_EQ(maxDifference(session->picture(), renderedBy(session->copiedCommand())), 0);
    // Beyond both ends.
    session->drag(1, middle, row, right - 1, row);
    EXPECT_EQ(time(), 1.0) << "the last key";
    session->drag(1, middle, row, left, row);
    EXPECT_EQ(time(), 0.0);
    EXPECT_FALSE(session->document().history().canUndo()) << "time is no edit";
}

TEST_F(TimelineSession, AClipIsChosenFromTheList) {
    const glm::vec3 start = session->document().lights()[0].position;
    ASSERT_TRUE(clickFromRight([&] { return popupIsOpen(); }));
    // The last row of the list, which opens above the row or below it.
    const ImGuiWindow* list = GImGui->OpenPopupStack.back().Window;
    ASSERT_NE(list, nullptr);
    session->click(static_cast<int>(list->Pos.x) + 20, static_cast<int>(list->Pos.y + list->Size.y) - 14);
    EXPECT_EQ(session->model().options.animation, "1");
    session->click((left + right) / 2, row);
    ASSERT_GT(time(), 0.0);
    EXPECT_EQ(session->document().lights()[0].position, start) << "the other clip does not play";
    EXPECT_EQ(maxDifference(session->picture(), renderedBy(session->copiedCommand())), 0);
}

TEST_F(TimelineSession, LoopRepeatsTheClip) {
    ASSERT_TRUE(clickFromRight([&] { return session->model().options.repeatAnimations; }));
    time() = 1.25;
    session->step();
    EXPECT_DOUBLE_EQ(session->document().time(), 0.25);
    EXPECT_EQ(maxDifference(session->picture(), renderedBy(session->copiedCommand())), 0);
}

}  // namespace
