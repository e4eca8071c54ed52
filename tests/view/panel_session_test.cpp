// The panels, used by pointer events: selections in them affect the image.

#include "common/shadow_stats.h"
#include "own_display.h"
#include "view_session.h"

#include <imgui_internal.h>

#include <algorithm>
#include <functional>

namespace {

/// A window with one panel open, large enough for its content.
class PanelSession : public ViewTest {
  protected:
    void open(bool OpenPanels::*panel) {
        session = std::make_unique<ViewSession>(std::vector<std::string>{"plaza:16", "--size", "640x480"});
        session->model().panels = {};
        for (bool OpenPanels::*each :
             {&OpenPanels::scene, &OpenPanels::material, &OpenPanels::lights, &OpenPanels::camera,
              &OpenPanels::color, &OpenPanels::drawing, &OpenPanels::statistics, &OpenPanels::probe})
            session->model().panels.*each = each == panel;
        session->awaitScene();
        session->step(3);
    }

    /// Opens the lists of a panel one after another, from the top, and selects the last row of each, until
    /// `selected` is true.
    bool selectIn(const char* panel, const std::function<bool()>& selected) {
        const ImGuiWindow* window = ImGui::FindWindowByName(panel);
        if (!window) return false;
        const int x = static_cast<int>(window->Pos.x) + 20;
        const int end = static_cast<int>(window->Pos.y + window->Size.y);
        for (int y = static_cast<int>(window->Pos.y) + 30; y < end && !selected(); y += 10) {
            session->click(x, y);
            selectLastRow();
        }
        return selected();
    }

    std::unique_ptr<ViewSession> session;

  private:
    void selectLastRow() {
        const ImVector<ImGuiPopupData>& popups = GImGui->OpenPopupStack;
        if (popups.empty() || !popups.back().Window) return;
        const ImGuiWindow& list = *popups.back().Window;
        session->click(static_cast<int>(list.Pos.x) + 10,
                       static_cast<int>(list.Pos.y + list.Size.y - 0.8f * ImGui::GetFontSize()));
    }
};

TEST_F(PanelSession, DisplayAndViewAreSelectedFromLists) {
    open(&OpenPanels::color);
    const PngPicture before = session->picture();
    ASSERT_TRUE(selectIn("Colour", [&] { return !session->model().options.display.display.empty(); }));
    ASSERT_TRUE(selectIn("Colour", [&] { return !session->model().options.display.view.empty(); }));
    const candela::DisplayOptions options = session->model().options.display;
    EXPECT_EQ(options.display, session->model().color.displays().back());
    EXPECT_EQ(options.view, session->model().color.views(options.display).back());
    const PngPicture shown = session->picture();
    EXPECT_GT(maxDifference(shown, before), 5);
    // Two runs may bake an ACES view or not, which differ by a quarter of a code and its rounding.
    EXPECT_LE(maxDifference(shown, renderedBy(session->copiedCommand())), 1);
}

TEST_F(PanelSession, TechniqueAndBrdfAreSelectedFromLists) {
    open(&OpenPanels::drawing);
    ASSERT_TRUE(selectIn("Drawing", [&] {
        return session->model().options.technique != candela::Technique::automatic &&
               session->model().options.brdf != candela::BrdfModel::course;
    }));
    EXPECT_EQ(session->model().options.technique, candela::Technique::fullscreen);
    EXPECT_EQ(maxDifference(session->picture(), renderedBy(session->copiedCommand())), 0);
}

TEST_F(PanelSession, ALightLosesItsShadowByItsBox) {
    open(&OpenPanels::lights);
    session->model().pickedLight = 3;
    session->step(2);
    ImGuiWindow* window = ImGui::FindWindowByName("Lights");
    ASSERT_NE(window, nullptr);
    ImGui::SetScrollY(window, window->ScrollMax.y);  // To the last controls of the light.
    session->step(2);
    const auto& lights = session->document().lights();
    const auto castsShadow = [](const candela::WorldLight& light) { return light.castsShadow; };
    ASSERT_TRUE(std::ranges::all_of(lights, castsShadow));
    EXPECT_TRUE(selectIn("Lights", [&] { return !std::ranges::all_of(lights, castsShadow); }));
    EXPECT_FALSE(session->document().changes().empty());
}

TEST_F(PanelSession, ShadowsAreSwitchedByABox) {
    if (!candela::hasShadows()) GTEST_SKIP() << "the library has no shadows";
    open(&OpenPanels::drawing);
    SceneOptions& options = session->model().options;
    const candela::Shadows before = drawnShadows(options.shadows);
    ASSERT_TRUE(selectIn("Drawing", [&] { return drawnShadows(options.shadows) != before; }));
    options.technique = candela::Technique::automatic;
    const PngPicture shown = session->picture();
    const std::string command = session->copiedCommand();
    EXPECT_NE(command.find(std::string("--shadows ") + toString(options.shadows)), command.npos) << command;
    EXPECT_EQ(maxDifference(shown, renderedBy(command)), 0);
}

TEST_F(PanelSession, EveryPanelOpensFromTheMenu) {
    open(nullptr);
    // The second menu of the bar; its first rows are the panels.
    session->click(70, 9);
    ASSERT_FALSE(GImGui->OpenPopupStack.empty());
    const ImGuiWindow& menu = *GImGui->OpenPopupStack.back().Window;
    session->click(static_cast<int>(menu.Pos.x) + 20, static_cast<int>(menu.Pos.y) + 16);
    EXPECT_TRUE(session->model().panels.scene);
    EXPECT_FALSE(session->model().panels.lights);
}

TEST_F(PanelSession, AllPanelsAreDrawnWithoutErrorsInAnySize) {
    open(nullptr);
    session->model().panels = {true, true, true, true, true, true, true, true};
    session->model().pickedNode = 1;
    session->model().pickedMaterial = 0;
    session->model().pickedLight = 3;
    for (const auto& [width, height] : {std::pair(640, 480), std::pair(100, 80), std::pair(1200, 900)}) {
        session->resize(width, height);
        session->model().requests.countPairs = true;
        session->step(4);
    }
    ASSERT_TRUE(session->model().pairs);
    EXPECT_GT(session->model().pairs->pairsLit, 0u);
    EXPECT_EQ(session->messages(Message::Kind::error), 0u);
}

}  // namespace
