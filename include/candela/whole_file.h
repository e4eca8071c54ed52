#pragma once

#include <candela/export.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace candela {

/// Writes a file atomically: into a file without a name in the same folder, which gets its name once every
/// byte is on the disk. When the process is killed, or the disk or the limit of file sizes (`ulimit -f`) is
/// reached, nothing of it stays and an existing file is unchanged. (Where the file system has no files
/// without a name, a temporary file is used, which stays behind a killed process.)
///
/// A new file gets its permissions by the umask, a replaced one keeps its own. Symbolic links are followed.
/// What is not an ordinary file (a device, a pipe, an open descriptor such as /dev/stdout) can not be
/// replaced and is written in place.
///
/// Throws `Error` (environment) that names the file, and the folder if that is at fault.
CANDELA_API void writeWholeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// A file that is written piece by piece and is whole or not there, as one of `writeWholeFile`: it takes its
/// place at the end. Memory does not hold it. What is not an ordinary file gets all bytes at the end; until
/// then they are in a file without a name in the system's folder for temporary files. One thread at a time
/// may use it.
class CANDELA_API WholeFile {
  public:
    /// Throws `Error` as `writeWholeFile` does.
    explicit WholeFile(const std::filesystem::path& path);
    /// For an open file descriptor, such as that of standard output, which stays open. `name` is what errors
    /// name. Throws `Error` (environment) when there is no room for temporary files.
    WholeFile(int descriptor, const std::string& name);
    WholeFile(WholeFile&&) noexcept;
    WholeFile& operator=(WholeFile&&) noexcept;
    /// Without `finish` nothing of the file stays, and what was in its place is unchanged.
    ~WholeFile();

    // What follows throws `Error` (environment) that names the file, and (badInput) after `finish`.

    /// Appends.
    void write(std::span<const std::byte> bytes);
    /// Writes from `position` on, which is `size()` at most, over what is there.
    void writeAt(std::uint64_t position, std::span<const std::byte> bytes);
    /// Puts the file in its place.
    void finish();

    /// Bytes written.
    std::uint64_t size() const;
    /// What errors name.
    const std::string& name() const;

  private:
    struct State;
    State& open() const;

    std::unique_ptr<State> state_;
};

}  // namespace candela
