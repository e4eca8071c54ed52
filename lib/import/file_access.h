#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>

namespace candela {

/// Reads the files of one scene's folder and of nothing beyond it. What was read is kept until the object
/// dies, and a file asked for twice is read once.
class FileAccess {
  public:
    /// Throws `Error` (environment) when the folder can not be opened.
    explicit FileAccess(const std::filesystem::path& folder);
    ~FileAccess();
    FileAccess(const FileAccess&) = delete;
    FileAccess& operator=(const FileAccess&) = delete;

    /// The whole file; `path` is relative to the folder. Throws `Error` that names `path`: badInput for a
    /// path that is absolute or leaves the folder, also by a symbolic link, and for what is not a regular
    /// file; environment when the file is absent or can not be read; limit when it is too large.
    std::span<const std::byte> read(const std::string& path);

    /// The bytes of a file. An array and not a vector, which would write zeros over it all before it is read
    /// into.
    struct Bytes {
        std::unique_ptr<std::byte[]> data;
        std::size_t size = 0;
    };

  private:
    int folder_ = -1;  // Descriptor of the folder: it can be renamed, but not exchanged under us.
    std::map<std::string, Bytes> files_;
};

}  // namespace candela
