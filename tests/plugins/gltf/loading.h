#pragma once

#include <candela/error.h>
#include <candela/import.h>

#include <filesystem>
#include <optional>
#include <string>

#include "gltf_file.h"

namespace candela_test {

/// A temporary folder, removed by the destructor.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Writes a file into the folder, creates the folders of its name, and returns its path.
    std::string write(const std::string& name, const std::string& content) const;
    std::string write(const std::string& name, const Bytes& content) const;

  private:
    std::filesystem::path path_;
};

/// The plugins built with the tests.
const candela::PluginRegistry& plugins();

/// Imports the file at `path`.
candela::ImportedScene loadPath(const std::string& path);
/// Writes `file` as .gltf and imports it.
candela::ImportedScene load(const GltfFile& file);
candela::ImportedScene loadText(const std::string& text);
candela::ImportedScene loadGlb(const Bytes& bytes);

/// The error message of loading; "" when loading succeeds.
std::string errorOfText(const std::string& text);
std::string errorOfGlb(const Bytes& bytes);
std::string errorOfPath(const std::string& path);
/// The message of the error, or the notes, where there is none.
std::string complaintsOf(const GltfFile& file);
/// The error of a strict import.
std::string strictErrorOfText(const std::string& text);
inline std::string errorOf(const GltfFile& file) {
    return errorOfText(file.text());
}

/// Whether one of the report's notes contains `part`.
bool hasNote(const candela::ImportedScene& imported, const std::string& part);

}  // namespace candela_test
