#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>

namespace candela {

/// Reads the files of one scene's folder, and no others. Each file is read once, and kept until the object is
/// destroyed.
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

    /// The bytes of the file, which is not kept. Throws as `read` does, but a file may be of any size.
    std::uint64_t size(const std::string& path) const;
    /// Reads the bytes from `offset` on until `into` is full. Throws as `size` does, and badInput when the
    /// file ends before.
    void readPart(const std::string& path, std::uint64_t offset, std::span<std::byte> into) const;

    /// Frees what `read` has returned.
    void forget() { files_.clear(); }

    /// `path` where a file has this name. Else that of the first one, by bytes, whose name differs from it in
    /// the case of ASCII letters; and `path` again where there is none.
    std::string inAnyCase(const std::string& path) const;

    /// The bytes of a file. An array and not a vector, which would first fill it with zeros.
    struct Bytes {
        std::unique_ptr<std::byte[]> data;
        std::size_t size = 0;
    };

  private:
    int folder_ = -1;  // A descriptor, so that the folder can be renamed, but not replaced.
    std::map<std::string, Bytes> files_;
};

}  // namespace candela
