#include "style.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>

namespace {

/// Height of a line of text, in pixels at a scale of 1.
constexpr float letterPixels = 14.0f;
/// Of the font of ImGui, which is made of pixels.
constexpr float builtInPixels = 13.0f;

/// The usual places of fonts with Latin, Greek and Cyrillic letters: Debian, Fedora, Arch.
constexpr std::array fontFiles{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/usr/share/fonts/liberation-sans/LiberationSans-Regular.ttf",
};

/// Pairs of a first and a last character: those of names of files in European scripts.
constexpr std::array<ImWchar, 9> characters{0x20, 0x24f, 0x370, 0x52f, 0x1e00, 0x1eff, 0x2010, 0x20bf, 0};

const char* fontFile() {
    for (const char* file : fontFiles) {
        std::error_code failed;
        if (std::filesystem::is_regular_file(file, failed)) return file;
    }
    return nullptr;
}

void chooseFont(float scale, float pixelRatio) {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    io.FontGlobalScale = 1.0f / pixelRatio;
    const char* file = fontFile();
    const float pixels = std::round(letterPixels * scale * pixelRatio);
    if (file && io.Fonts->AddFontFromFileTTF(file, pixels, nullptr, characters.data())) return;
    ImFontConfig builtIn;
    builtIn.SizePixels = builtInPixels * std::fmax(std::round(scale * pixelRatio), 1.0f);
    io.Fonts->AddFontDefault(&builtIn);
}

ImVec4 grey(float value, float alpha = 1.0f) {
    return {value, value, 1.04f * value, alpha};
}

/// Greys, so that no colour of the panels changes how the picture is seen; one colour for what is active.
void chooseColors(ImVec4* colors) {
    const ImVec4 accent{0.82f, 0.62f, 0.33f, 1.0f}, dimAccent{0.50f, 0.40f, 0.26f, 1.0f};
    colors[ImGuiCol_Text] = grey(0.86f);
    colors[ImGuiCol_TextDisabled] = grey(0.55f);
    colors[ImGuiCol_WindowBg] = colors[ImGuiCol_MenuBarBg] = grey(0.135f);
    colors[ImGuiCol_ChildBg] = grey(0.0f, 0.0f);
    colors[ImGuiCol_PopupBg] = grey(0.16f);
    colors[ImGuiCol_Border] = grey(0.24f);
    colors[ImGuiCol_FrameBg] = grey(0.20f);
    colors[ImGuiCol_FrameBgHovered] = grey(0.25f);
    colors[ImGuiCol_FrameBgActive] = grey(0.29f);
    colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = colors[ImGuiCol_TitleBgCollapsed] =
        grey(0.18f);
    colors[ImGuiCol_ScrollbarBg] = grey(0.12f);
    colors[ImGuiCol_ScrollbarGrab] = grey(0.28f);
    colors[ImGuiCol_ScrollbarGrabHovered] = grey(0.36f);
    colors[ImGuiCol_ScrollbarGrabActive] = grey(0.42f);
    colors[ImGuiCol_CheckMark] = accent;
    colors[ImGuiCol_SliderGrab] = grey(0.48f);
    colors[ImGuiCol_SliderGrabActive] = accent;
    colors[ImGuiCol_Button] = grey(0.24f);
    colors[ImGuiCol_ButtonHovered] = grey(0.31f);
    colors[ImGuiCol_ButtonActive] = grey(0.37f);
    colors[ImGuiCol_Header] = grey(0.27f);
    colors[ImGuiCol_HeaderHovered] = grey(0.31f);
    colors[ImGuiCol_HeaderActive] = grey(0.35f);
    colors[ImGuiCol_Separator] = grey(0.24f);
    colors[ImGuiCol_Tab] = colors[ImGuiCol_TabUnfocused] = grey(0.18f);
    colors[ImGuiCol_TabHovered] = grey(0.33f);
    colors[ImGuiCol_TabActive] = colors[ImGuiCol_TabUnfocusedActive] = grey(0.28f);
    colors[ImGuiCol_PlotHistogram] = accent;
    colors[ImGuiCol_TextSelectedBg] = dimAccent;
    colors[ImGuiCol_TableHeaderBg] = grey(0.19f);
    colors[ImGuiCol_NavHighlight] = accent;
    colors[ImGuiCol_ModalWindowDimBg] = grey(0.0f, 0.45f);
}

}  // namespace

void chooseStyle(float scale, float pixelRatio) {
    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    chooseColors(style.Colors);
    style.WindowPadding = {7.0f, 6.0f};
    style.FramePadding = {5.0f, 2.0f};
    style.ItemSpacing = {6.0f, 4.0f};
    style.ScrollbarSize = 11.0f;
    style.WindowBorderSize = style.ChildBorderSize = 0.0f;
    style.WindowRounding = 0.0f;
    style.FrameRounding = style.GrabRounding = style.PopupRounding = style.TabRounding = 2.0f;
    style.WindowMenuButtonPosition = ImGuiDir_Left;
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
    chooseFont(scale, pixelRatio);
}
