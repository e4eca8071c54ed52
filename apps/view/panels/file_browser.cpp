#include "panels/file_browser.h"

#include "panels/widgets.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <system_error>
#include <utility>

namespace {

constexpr const char* title = "Open a scene";
constexpr float widthLetters = 40.0f, heightLetters = 28.0f;

std::string smallLetters(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    return text;
}

bool isBefore(const std::string& a, const std::string& b) {
    return std::pair(smallLetters(a), a) < std::pair(smallLetters(b), b);
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

}  // namespace

FolderContent readFolder(const std::filesystem::path& folder, const std::vector<std::string>& endings) {
    FolderContent content;
    std::error_code failed;
    for (std::filesystem::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with('.')) continue;
        std::error_code unknown;  // a broken link is neither
        if (entry->is_directory(unknown)) {
            content.folders.push_back(name);
        } else if (entry->is_regular_file(unknown) &&
                   std::ranges::find(endings, smallLetters(entry->path().extension().string())) !=
                       endings.end()) {
            content.files.push_back(name);
        }
    }
    if (failed) content.error = folder.string() + ": " + failed.message();
    std::ranges::sort(content.folders, isBefore);
    std::ranges::sort(content.files, isBefore);
    return content;
}

void FileBrowser::open() {
    opening_ = true;
}

void FileBrowser::enter(const std::filesystem::path& folder, const std::vector<std::string>& endings) {
    folder_ = folder.lexically_normal();
    content_ = readFolder(folder_, endings);
    typed_.clear();
}

/// A folder is entered; all else is a scene.
std::optional<std::string> FileBrowser::accept(const std::string& text,
                                               const std::vector<std::string>& endings) {
    if (text.empty()) return std::nullopt;
    const std::filesystem::path inFolder = folder_ / text;
    std::error_code unknown;
    if (std::filesystem::is_directory(inFolder, unknown)) {
        enter(inFolder, endings);
        return std::nullopt;
    }
    // What is no file is a procedural scene, or a path whose error is shown.
    return std::filesystem::exists(inFolder, unknown) ? inFolder.string() : text;
}

std::optional<std::string> FileBrowser::drawContent(const std::vector<std::string>& endings) {
    if (!content_.error.empty()) showWrappedText(content_.error);
    std::optional<std::string> entered, chosen;
    std::uint64_t id = 0;
    if (folder_.has_relative_path() && listRow(id++, Row::plain, "..")) entered = "..";
    for (const std::string& name : content_.folders)
        if (listRow(id++, Row::plain, name + "/")) entered = name;
    for (const std::string& name : content_.files) {
        if (listRow(id++, typed_ == name ? Row::selected : Row::plain, name)) {
            if (typed_ == name) chosen = (folder_ / name).string();
            typed_ = name;
        }
    }
    if (content_.files.empty() && content_.error.empty()) showDimText("no scenes in this folder");
    if (entered) enter(folder_ / *entered, endings);
    return chosen;
}

std::optional<std::string> FileBrowser::draw(const std::vector<std::string>& endings) {
    if (std::exchange(opening_, false)) {
        std::error_code unknown;
        enter(folder_.empty() ? std::filesystem::current_path(unknown) : folder_, endings);
        ImGui::OpenPopup(title);
    }
    const float letter = ImGui::GetFontSize();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(widthLetters * letter, 0.95f * display.x),
                              std::min(heightLetters * letter, 0.95f * display.y)});
    if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings))
        return std::nullopt;
    showDimText(folder_.string());
    ImGui::BeginChild("content", {0.0f, -3.2f * ImGui::GetFrameHeightWithSpacing()}, true);
    std::optional<std::string> chosen = drawContent(endings);
    ImGui::EndChild();
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    const bool entered = ImGui::InputTextWithHint("##path", "a path, or a scene such as plaza:4096", &typed_,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    showDimText("lists " + joined(endings));
    if (ImGui::Button("Open") || entered) chosen = accept(typed_, endings);
    ImGui::SameLine();
    const bool left = ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (chosen || left) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}
