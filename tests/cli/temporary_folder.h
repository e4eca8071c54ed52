#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// A temporary folder, deleted with its contents at the end of its scope.
class TemporaryFolder {
  public:
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();

    const std::filesystem::path& path() const { return path_; }
    /// Writes a file into it and returns its path.
    std::string write(const std::string& name, const std::string& text) const;
    /// The path of a file in it.
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    /// The names of its entries, sorted.
    std::vector<std::string> names() const;

  private:
    std::filesystem::path path_;
};
