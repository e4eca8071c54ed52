#include "panels/path_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <utility>

namespace {

constexpr float fieldLetters = 36.0f;

}  // namespace

PathDialog::PathDialog(const char* title, const char* action, const char* hint, std::string path)
    : title_(title), action_(action), hint_(hint), path_(std::move(path)) {}

bool PathDialog::draw() {
    if (std::exchange(opening_, false)) ImGui::OpenPopup(title_);
    const ImVec2 center = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(center, ImGuiCond_Appearing, {0.5f, 0.5f});
    if (!ImGui::BeginPopupModal(title_, nullptr,
                                ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings))
        return false;
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(fieldLetters * ImGui::GetFontSize());
    const bool entered =
        ImGui::InputTextWithHint("##path", hint_, &path_, ImGuiInputTextFlags_EnterReturnsTrue);
    const bool confirmed = (ImGui::Button(action_) || entered) && !path_.empty();
    ImGui::SameLine();
    const bool left = ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (confirmed || left) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return confirmed;
}
