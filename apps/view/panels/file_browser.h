#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What a folder holds, by name, without what begins with a dot.
struct FolderContent {
    std::vector<std::string> folders, files;
    std::string error;  ///< Why it can not be read; empty where it can.
};
/// Files that end in one of `endings`, such as ".gltf", in letters of either case.
FolderContent readFolder(const std::filesystem::path& folder, const std::vector<std::string>& endings);

/// A modal window in which a scene is chosen: a file of a folder, or what is typed.
class FileBrowser {
  public:
    /// Shows it from the next `draw` on, with the folder of the last time, at first the working directory.
    void open();
    /// Returns what the user has chosen, once.
    std::optional<std::string> draw(const std::vector<std::string>& endings);

  private:
    void enter(const std::filesystem::path& folder, const std::vector<std::string>& endings);
    std::optional<std::string> drawContent(const std::vector<std::string>& endings);
    std::optional<std::string> accept(const std::string& text, const std::vector<std::string>& endings);

    std::filesystem::path folder_;
    FolderContent content_;
    std::string typed_;
    bool opening_ = false;
};
