// The panels, used by pointer events: selections in them affect the image.

#include "common/shadow_stats.h"
#include "own_display.h"
#include "sample_scene.h"
#include "view_session.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

namespace {

/// A window with one panel open, large enough for its content.
class PanelSession : public ViewTest {
  protected:
    void open(bool OpenPanels::*panel) {
        session = std::make_unique<ViewSession>(std::vector<std::string>{"plaza:16", "--size", "640x480"});
        session->model().panels = {};
        session->model().panelsHidden = false;
        for (bool OpenPanels::*each :
             {&OpenPanels::scene, &OpenPanels::material, &OpenPanels::lights, &OpenPanels::camera,
              &OpenPanels::color, &OpenPanels::drawing, &OpenPanels::statistics, &OpenPanels::probe})
            session->model().panels.*each = each == panel;
        session->awaitScene();
        session->step(3);
    }

    /// Opens a menu of the bar by a click.
    void openMenu(const char* name) {
        ImGuiWindow* bar = ImGui::FindWindowByName("##MainMenuBar");
        ASSERT_NE(bar, nullptr);
        const ImGuiID wanted = ImHashStr(name, 0, bar->GetID("##menubar"));
        for (int x = 10; x < 400; x += 10) {
            session->click(x, 9);
            if (!GImGui->OpenPopupStack.empty() && GImGui->OpenPopupStack.back().PopupId == wanted) return;
        }
        FAIL() << "no menu " << name;
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
    openMenu("View");
    const ImGuiWindow& menu = *GImGui->OpenPopupStack.back().Window;
    // Its first row.
    session->click(static_cast<int>(menu.Pos.x) + 20,
                   static_cast<int>(menu.Pos.y + 0.9f * ImGui::GetFrameHeight()));
    EXPECT_TRUE(session->model().panels.scene);
    EXPECT_FALSE(session->model().panels.lights);
}

TEST_F(PanelSession, ADraggedValueIsOneStepThatIsUndone) {
    open(&OpenPanels::color);
    double& exposure = session->model().options.display.exposure;
    const ImGuiWindow* window = ImGui::FindWindowByName("Colour");
    ASSERT_NE(window, nullptr);
    const int x = static_cast<int>(window->Pos.x) + 20;
    for (int y = static_cast<int>(window->Pos.y) + 30; y < 480 && exposure == 0.0; y += 8)
        session->drag(1, x, y, x + 40, y);
    const double dragged = exposure;
    ASSERT_NE(dragged, 0.0);
    session->sendFast("key --delay 0 ctrl+z");
    EXPECT_EQ(exposure, 0.0);
    session->sendFast("key --delay 0 ctrl+shift+z");
    EXPECT_EQ(exposure, dragged);
    EXPECT_EQ(maxDifference(session->picture(), renderedBy(session->copiedCommand())), 0);
}

TEST_F(PanelSession, TheFileBrowserOpensWhatItLists) {
    std::filesystem::create_directories(folder / "sub");
    folder.write("sub/scene.gltf", sampleScene());
    folder.write("sub/scene.txt", "no scene");
    open(nullptr);
    session->sendFast("key --delay 0 ctrl+o");
    session->sendFast("type --delay 0 sub");
    session->sendFast("key --delay 0 Return");
    ASSERT_FALSE(GImGui->OpenPopupStack.empty()) << "a folder is entered";
    const ImGuiWindow& browser = *GImGui->OpenPopupStack.back().Window;
    const ImGuiWindow* list = nullptr;
    for (const ImGuiWindow* window : GImGui->Windows)
        if (window->ParentWindow == &browser) list = window;
    ASSERT_NE(list, nullptr);
    // The second row, after that of the folder above.
    const int y = static_cast<int>(list->Pos.y + 6.0f + 1.5f * ImGui::GetTextLineHeightWithSpacing());
    session->click(static_cast<int>(list->Pos.x) + 30, y);
    session->click(static_cast<int>(list->Pos.x) + 30, y);
    session->awaitScene();
    EXPECT_TRUE(session->model().options.scene.ends_with("sub/scene.gltf")) << session->model().options.scene;
}

TEST_F(PanelSession, TabHidesAllPanelsAndBringsThemBack) {
    open(&OpenPanels::lights);
    const int narrow = session->model().options.width;
    for (int i = 0; i < 3; ++i) {
        session->sendFast("key --delay 0 Tab");
        EXPECT_EQ(session->model().options.width, 640);
        EXPECT_EQ(session->model().options.height, 480);
        session->sendFast("key --delay 0 Tab");
        EXPECT_EQ(session->model().options.width, narrow);
    }
}

TEST_F(PanelSession, ASplitterMovesTheEdgeOfThePicture) {
    open(&OpenPanels::lights);
    const Layout before = session->model().layout;
    const int x = static_cast<int>(before.picture.position.x) - 2;
    session->drag(1, x, 240, x - 40, 240);
    EXPECT_NEAR(session->model().layout.picture.position.x, before.picture.position.x - 40.0f, 0.5f);
    EXPECT_EQ(session->model().options.width,
              static_cast<int>(std::lround(640.0f - session->model().layout.picture.position.x)));
    EXPECT_EQ(maxDifference(session->picture(), renderedBy(session->copiedCommand())), 0);
}

TEST_F(PanelSession, KeysAreListedAndTextIsScaled) {
    open(&OpenPanels::lights);
    session->sendFast("key --delay 0 F1");
    const ImGuiWindow* keys = ImGui::FindWindowByName("Keys");
    ASSERT_NE(keys, nullptr);
    EXPECT_TRUE(keys->Active);
    session->sendFast("key --delay 0 Escape");
    EXPECT_FALSE(keys->Active);
    const float letter = ImGui::GetFontSize();
    for (int i = 0; i < 2; ++i) session->sendFast("key --delay 0 ctrl+equal");
    // Two steps of 1.1, rounded to whole pixels.
    EXPECT_NEAR(ImGui::GetFontSize(), 1.21f * letter, 1.0f);
    for (int i = 0; i < 2; ++i) session->sendFast("key --delay 0 ctrl+minus");
    EXPECT_EQ(ImGui::GetFontSize(), letter);
    session->sendFast("key --delay 0 ctrl+q");
    EXPECT_TRUE(glfwWindowShouldClose(session->window()));
}

TEST_F(PanelSession, AllPanelsAreDrawnWithoutErrorsInAnySize) {
    open(nullptr);
    session->model().panels = {true, true, true, true, true, true, true, true, true};
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
